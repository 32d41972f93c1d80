// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "files_samples.h"
#include "filter_mgf_skeleton/io/colour.h"
#include "filter_mgf_skeleton/io/tube_mesh.h"
#include "vcg_ext/skeleton/branches.h"

namespace mgf::io {
namespace {

// Each directed edge once, and its opposite too: closed and consistently oriented.
bool is_closed_manifold(const TriangleSurface& surface) {
  std::map<std::pair<Index, Index>, int> directed;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
  }
  return std::all_of(directed.begin(), directed.end(), [&](const auto& entry) {
    const auto [ends, count] = entry;
    return count == 1 && directed.count({ends.second, ends.first}) == 1;
  });
}

int euler_number(const TriangleSurface& surface) {
  const auto faces = static_cast<int>(surface.triangles.size());
  return static_cast<int>(surface.points.size()) - faces * 3 / 2 + faces;
}

double volume(const TriangleSurface& surface) {
  double six_volumes = 0.0;
  for (const Triangle& t : surface.triangles) {
    six_volumes += surface.points[t[0]].dot(surface.points[t[1]].cross(surface.points[t[2]]));
  }
  return six_volumes / 6.0;
}

// The area of a regular twelve-gon round a unit circle.
const double kDodecagon = 12.0 * std::sin(M_PI / 6.0) / 2.0;

TEST(Tubes, RoundALineHasTheVolumeOfACapsule) {
  const TubeMesh tube = make_tubes({{{{0, 0, 0}, {0, 0, 10}}, {1.0, 2.0}, false}}, 1.0);
  EXPECT_TRUE(is_closed_manifold(tube.surface));
  EXPECT_EQ(euler_number(tube.surface), 2);
  // The barrel as a prism of twelve sides, the caps inside two half balls.
  EXPECT_GT(volume(tube.surface), 10.0 * kDodecagon + 0.8 * 4.0 / 3.0 * M_PI);
  EXPECT_LT(volume(tube.surface), 10.0 * kDodecagon + 4.0 / 3.0 * M_PI);
  for (const Vec3& p : tube.surface.points) {
    const Vec3 nearest(0, 0, std::clamp(p.z(), 0.0, 10.0));
    EXPECT_NEAR((p - nearest).norm(), 1.0, 1e-12);
  }
}

TEST(Tubes, RoundAnyBendStaysAtTheRadius) {
  // Right angles, a full turn back, and a repeated point.
  const std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {5, 5, 0}, {5, 5, 5}, {5, 5, 2}};
  const TubeMesh tube = make_tubes({{points, std::vector<double>(points.size(), 0.0), false}}, 0.5);
  EXPECT_TRUE(is_closed_manifold(tube.surface));
  EXPECT_EQ(euler_number(tube.surface), 2);
  for (const Vec3& p : tube.surface.points) {
    double nearest = 1e9;
    for (const Vec3& q : points) nearest = std::min(nearest, (p - q).norm());
    EXPECT_NEAR(nearest, 0.5, 1e-12);
  }
}

TEST(Tubes, RoundAKnottedLoopMeetsItselfWithoutATwist) {
  TubePath path;
  path.closed = true;
  constexpr int kPoints = 60;
  for (int i = 0; i < kPoints; ++i) {  // a trefoil, whose frames come back turned
    const double t = 2.0 * M_PI * i / kPoints;
    path.points.emplace_back(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                             -std::sin(3 * t));
    path.quality.push_back(t);
  }
  const TubeMesh tube = make_tubes({path}, 0.1);
  EXPECT_TRUE(is_closed_manifold(tube.surface));
  EXPECT_EQ(euler_number(tube.surface), 0);
  EXPECT_GT(volume(tube.surface), 0.0);
  // The lines along the tube are no longer than the steps of the path allow.
  double longest_step = 0.0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    longest_step = std::max(longest_step, (path.points[(i + 1) % kPoints] - path.points[i]).norm());
  }
  const std::size_t sides = tube.surface.points.size() / kPoints;
  for (std::size_t i = 0; i < tube.surface.points.size(); ++i) {
    const Vec3& next = tube.surface.points[(i + sides) % tube.surface.points.size()];
    EXPECT_LT((next - tube.surface.points[i]).norm(), 1.2 * longest_step);
  }
}

TEST(Tubes, OfOnePointAreABall) {
  const TubeMesh ball = make_tubes({{{{1, 2, 3}}, {7.0}, false}}, 2.0);
  EXPECT_TRUE(is_closed_manifold(ball.surface));
  EXPECT_EQ(euler_number(ball.surface), 2);
  for (const Vec3& p : ball.surface.points) EXPECT_NEAR((p - Vec3(1, 2, 3)).norm(), 2.0, 1e-12);
  EXPECT_EQ(ball.quality, std::vector<double>(ball.surface.points.size(), 7.0));
}

TEST(Tubes, OfASkeletonAreOneSurfaceABranch) {
  const CurveSkeleton skeleton = test::ring_with_tail();
  const BranchGraph graph = build_branches(skeleton);
  const std::vector<TubePath> paths = tube_paths(skeleton, graph, skeleton.eccentricity, 0.0);
  ASSERT_EQ(paths.size(), 3U);  // ring, tail, lone node
  EXPECT_EQ(std::count_if(paths.begin(), paths.end(), [](const TubePath& p) { return p.closed; }),
            1);
  const TubeMesh tubes = make_tubes(paths, 0.01);
  EXPECT_TRUE(is_closed_manifold(tubes.surface));
  EXPECT_EQ(euler_number(tubes.surface), 0 + 2 + 2);
  EXPECT_EQ(tubes.quality.size(), tubes.surface.points.size());
}

TEST(Tubes, KeepTheNumberOfABranch) {
  const CurveSkeleton skeleton = test::star_skeleton({3, 2, 1}, 4, 0.2);
  const BranchGraph graph = build_branches(skeleton);
  const std::vector<double> ids(graph.edge_branch.begin(), graph.edge_branch.end());
  const std::vector<TubePath> paths = tube_paths(skeleton, graph, ids, -1.0);
  ASSERT_EQ(paths.size(), 3U);
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(paths[b].quality, std::vector<double>(5, static_cast<double>(b)));
  }
}

TEST(Tubes, HaveAThicknessEvenOfOneNode) {
  EXPECT_GT(default_tube_radius(test::single_node_skeleton()), 0.0);
  EXPECT_NEAR(default_tube_radius(test::line_skeleton(100.0, 4, 1.0)), 0.4, 1e-12);
}

TEST(ColourScale, GoesFromBlueOverGreenToRed) {
  const ColourScale scale{1.0, 3.0};
  EXPECT_EQ(scale(1.0), (Colour{0, 0, 255}));
  EXPECT_EQ(scale(1.5), (Colour{0, 255, 255}));
  EXPECT_EQ(scale(2.0), (Colour{0, 255, 0}));
  EXPECT_EQ(scale(2.5), (Colour{255, 255, 0}));
  EXPECT_EQ(scale(3.0), (Colour{255, 0, 0}));
  EXPECT_EQ(scale(-9.0), scale(1.0));
  EXPECT_EQ(scale(9.0), scale(3.0));
}

TEST(ColourScale, OfOneValueIsItsMiddle) {
  EXPECT_EQ(quantile_scale({2.0, 2.0}, 0.0)(2.0), (Colour{0, 255, 0}));
  EXPECT_EQ(quantile_scale({}, 0.0).high, 1.0);
}

TEST(ColourScale, LeavesOutTheTails) {
  std::vector<double> values;
  for (int i = 100; i >= 0; --i) values.push_back(i);
  values[0] = 1e9;
  const ColourScale scale = quantile_scale(values, 0.05);
  EXPECT_EQ(scale.low, 5.0);
  EXPECT_EQ(scale.high, 95.0);
}

TEST(BranchColours, DifferWhereBranchesMeet) {
  const BranchGraph graph =
      build_branches(test::star_skeleton(std::vector<double>(14, 1.0), 2, 0.1));
  const std::vector<Colour> colours = branch_colours(graph);
  ASSERT_EQ(colours.size(), 14U);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(colours[i] == colours[j]);
  }
}

TEST(BranchColours, ServeAnyNumberOfBranches) {
  const BranchGraph graph =
      build_branches(test::star_skeleton(std::vector<double>(40, 1.0), 2, 0.1));
  EXPECT_EQ(branch_colours(graph).size(), 40U);
  EXPECT_TRUE(branch_colours(build_branches(test::single_node_skeleton())).empty());
}

}  // namespace
}  // namespace mgf::io
