// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/surface/surface_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "tests/graph_fixtures.h"
#include "tests/swept_fixtures.h"

namespace mgf {
namespace {

using test::circled_tube;
using test::CircledShape;
using test::CircledTee;
using test::count_pieces;

SurfaceMap map_of(const CircledShape& shape) {
  return map_surface(shape.surface, unrefined(shape.surface), shape.skeleton,
                     build_branches(shape.skeleton), shape.circles);
}

TEST(SurfaceMap, PlacesTheFacesOfATubeAlongIt) {
  const CircledShape shape = circled_tube(10.0, 0.5, 100, 24);
  const BranchGraph graph = build_branches(shape.skeleton);
  const bool reversed = shape.skeleton.position[graph.branches[0].first_node].x() > 5.0;
  const SurfaceMap map = map_of(shape);
  for (Index f = 0; f < shape.surface.triangles.size(); ++f) {
    const Triangle& t = shape.surface.triangles[f];
    const Vec3 centre =
        (shape.surface.points[t[0]] + shape.surface.points[t[1]] + shape.surface.points[t[2]]) / 3;
    EXPECT_EQ(map.faces.branch[f], 0U);
    const double along = reversed ? 10.0 - centre.x() : centre.x();
    EXPECT_NEAR(map.faces.arc_length[f], along, 1e-9);
    EXPECT_NEAR(map.faces.distance[f], std::hypot(centre.y(), centre.z()), 1e-9);
    EXPECT_NEAR(map.faces.girth[f], M_PI, 1e-9);
  }
  for (Index v = 0; v < shape.surface.points.size(); ++v) {
    const Vec3& p = shape.surface.points[v];
    EXPECT_EQ(map.vertices.branch[v], 0U);
    EXPECT_NEAR(map.vertices.arc_length[v], reversed ? 10.0 - p.x() : p.x(), 1e-9);
  }
}

TEST(SurfaceMap, GivesEachArmOfATeeOneConnectedPart) {
  const CircledTee tee(4, 4);
  const BranchGraph graph = build_branches(tee.shape.skeleton);
  ASSERT_EQ(graph.branches.size(), 3U);
  const SurfaceMap map = map_of(tee.shape);
  std::map<Index, std::set<Index>> branches_of_arm;
  for (Index f = 0; f < tee.shape.surface.triangles.size(); ++f) {
    EXPECT_NE(map.faces.branch[f], kNone);
    if (tee.arm_of_face(f) != kNone) {
      branches_of_arm[tee.arm_of_face(f)].insert(map.faces.branch[f]);
    }
  }
  std::set<Index> all;
  for (const auto& [arm, branches] : branches_of_arm) {
    EXPECT_EQ(branches.size(), 1U) << "arm " << arm;
    all.insert(branches.begin(), branches.end());
  }
  EXPECT_EQ(all.size(), 3U);
  for (const auto& [branch, pieces] : count_pieces(tee.shape.surface, map.faces.branch)) {
    EXPECT_EQ(pieces, 1) << "branch " << branch;
  }
}

TEST(SurfaceMap, PartsStayConnectedWhenCirclesStray) {
  CircledTee tee(4, 4);
  std::mt19937 random(11);
  std::vector<std::vector<Index>> circles(tee.shape.circles.faces.size());
  const auto faces = static_cast<Index>(tee.shape.surface.triangles.size());
  for (Index e = 0; e < circles.size(); ++e) {
    const Row<Index> row = tee.shape.circles.faces[e];
    circles[e].assign(row.begin(), row.end());
    for (int stray = 0; stray < 6; ++stray)
      circles[e].push_back(static_cast<Index>(random()) % faces);
  }
  test::set_circles(circles, tee.shape);
  const SurfaceMap map = map_of(tee.shape);
  const auto pieces = count_pieces(tee.shape.surface, map.faces.branch);
  EXPECT_EQ(pieces.size(), 3U);
  for (const auto& [branch, count] : pieces) EXPECT_EQ(count, 1) << "branch " << branch;
}

TEST(SurfaceMap, VerticesBelongToABranchOfTheirFaces) {
  const CircledTee tee(3, 3);
  const BranchGraph graph = build_branches(tee.shape.skeleton);
  const SurfaceMap map = map_of(tee.shape);
  std::vector<std::set<Index>> around(tee.shape.surface.points.size());
  for (Index f = 0; f < tee.shape.surface.triangles.size(); ++f) {
    for (const Index v : tee.shape.surface.triangles[f]) around[v].insert(map.faces.branch[f]);
  }
  for (Index v = 0; v < around.size(); ++v) {
    EXPECT_EQ(around[v].count(map.vertices.branch[v]), 1U);
    EXPECT_EQ(graph.edge_branch[map.vertices.edge[v]], map.vertices.branch[v]);
    EXPECT_GE(map.vertices.arc_length[v], 0.0);
    EXPECT_LE(map.vertices.arc_length[v], graph.branches[map.vertices.branch[v]].length + 1e-12);
  }
}

TEST(SurfaceMap, PlacesAPartThatIsMadeOfOthersCircles) {
  CircledTee tee(4, 4);
  CurveSkeleton& skeleton = tee.shape.skeleton;
  const BranchGraph graph = build_branches(skeleton);
  ASSERT_EQ(graph.branches.size(), 3U);
  // A trunk so wide that it takes the ends of the others, and whose own circles are all missing.
  const Branch& trunk = graph.branches[0];
  for (const Index e : trunk.edges) skeleton.mgf[e] *= 2;
  for (const Index v : trunk.nodes) skeleton.node_mgf[v] *= 2;
  std::vector<std::vector<Index>> circles(skeleton.edge_count());
  for (Index e = 0; e < circles.size(); ++e) {
    const Row<Index> row = tee.shape.circles.faces[e];
    if (graph.edge_branch[e] != 0) circles[e].assign(row.begin(), row.end());
  }
  test::set_circles(circles, tee.shape);

  const SurfaceMap map = map_of(tee.shape);
  Index of_trunk = 0;
  for (Index f = 0; f < map.faces.branch.size(); ++f) {
    ASSERT_NE(map.faces.edge[f], kNone);
    EXPECT_EQ(map.faces.branch[f], graph.edge_branch[map.faces.edge[f]]);
    if (map.faces.branch[f] == 0) ++of_trunk;
  }
  EXPECT_GT(of_trunk, 0U);
  for (const Index edge : map.vertices.edge) EXPECT_NE(edge, kNone);
}

TEST(SurfaceMap, OfASkeletonWithoutEdgesIsEmptyHanded) {
  CircledShape shape = circled_tube(1.0, 0.5, 2, 8);
  shape.skeleton = test::single_node_skeleton();
  test::set_circles({}, shape);
  const SurfaceMap map = map_of(shape);
  ASSERT_EQ(map.faces.branch.size(), shape.surface.triangles.size());
  ASSERT_EQ(map.vertices.edge.size(), shape.surface.points.size());
  for (const Index branch : map.faces.branch) EXPECT_EQ(branch, kNone);
  for (const Index edge : map.vertices.edge) EXPECT_EQ(edge, kNone);
}

TEST(Parts, BordersHaveNoTeeth) {
  // A grid strip whose left half is one part and right half another, with single faces swapped.
  CircledShape shape = circled_tube(10.0, 2.0, 20, 16);
  const FaceGraph faces = build_face_graph(shape.surface);
  std::vector<Index> part(faces.face_count());
  for (Index f = 0; f < part.size(); ++f) part[f] = faces.centroid[f].x() < 5.0 ? 0 : 1;
  std::vector<Index> toothed = part;
  for (Index f = 0; f < part.size(); ++f) {
    bool at_border = false;
    for (const Index g : faces.neighbour[f]) at_border = at_border || part[g] != part[f];
    if (at_border && f % 3 == 0) toothed[f] = 1 - part[f];
  }
  const auto border = [&](const std::vector<Index>& label) {
    double length = 0.0;
    for (Index f = 0; f < label.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (label[faces.neighbour[f][i]] != label[f]) length += 0.5 * faces.edge_length[f][i];
      }
    }
    return length;
  };
  ASSERT_GT(border(toothed), border(part));
  straighten_borders(faces, toothed);
  EXPECT_NEAR(border(toothed), border(part), 1e-9);
  for (const auto& [label, pieces] : count_pieces(shape.surface, toothed)) {
    EXPECT_EQ(pieces, 1) << "part " << label;
  }
}

TEST(FaceFlood, GivesEveryFaceTheNearestSeed) {
  const CircledShape shape = circled_tube(10.0, 0.5, 50, 10);
  const FaceGraph faces = build_face_graph(shape.surface);
  std::vector<Index> seeds(faces.face_count(), kNone);
  for (const Index f : shape.circles.faces[0]) seeds[f] = 4;
  for (const Index f : shape.circles.faces[49]) seeds[f] = 2;
  const FaceFlood flood = flood_faces(faces, seeds);
  for (Index f = 0; f < seeds.size(); ++f) {
    const double x = faces.centroid[f].x();
    if (std::abs(x - 5.0) > 0.2) {
      EXPECT_EQ(flood.label[f], x < 5.0 ? 4U : 2U);
    }
    EXPECT_TRUE(std::isfinite(flood.distance[f]));
  }
}

}  // namespace
}  // namespace mgf
