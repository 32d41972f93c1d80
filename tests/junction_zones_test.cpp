// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/junction_zones.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/graph_fixtures.h"

namespace mgf {
namespace {

using test::add_polyline;
using test::single_node_skeleton;
using test::star_skeleton;
using test::tube_skeleton;

/// Widens the edges and nodes for which `inside(place)` holds to a tube of that radius.
template <class Inside>
void widen(CurveSkeleton& skeleton, double radius, const Inside& inside) {
  for (Index v = 0; v < skeleton.node_count(); ++v) {
    if (inside(skeleton.position[v])) skeleton.node_mgf[v] = M_PI * radius;
  }
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    const auto [u, v] = skeleton.edge[e];
    if (inside(0.5 * (skeleton.position[u] + skeleton.position[v]))) {
      skeleton.mgf[e] = M_PI * radius;
    }
  }
}

/// A trunk of radius 1 along x from -10 to 0 with two arms of radius 0.3 up and down from its end.
CurveSkeleton trunk_with_arms(double arm_length) {
  std::vector<Vec3> nodes{Vec3::Zero()};
  std::vector<std::array<Index, 2>> edges;
  add_polyline(nodes, edges, 0, kNone, 100, [](double t) { return Vec3(-10 * t, 0, 0); });
  for (const double side : {-1.0, 1.0}) {
    add_polyline(nodes, edges, 0, kNone, 50,
                 [&](double t) { return Vec3(0, side * arm_length * t, 0); });
  }
  CurveSkeleton skeleton = tube_skeleton(nodes, edges, 0.3);
  widen(skeleton, 1.0, [](const Vec3& p) { return std::abs(p.y()) < 1.0; });
  return skeleton;
}

TEST(JunctionZones, ATrunkOwnsWhatIsWithinItsRadius) {
  const CurveSkeleton skeleton = trunk_with_arms(5.0);
  const BranchGraph graph = build_branches(skeleton);
  const std::vector<Index> owner = owning_branches(skeleton, graph);
  ASSERT_NEAR(graph.branches[0].length, 10.0, 1e-9);  // the trunk is branch 0
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    const Vec3 middle =
        0.5 * (skeleton.position[skeleton.edge[e][0]] + skeleton.position[skeleton.edge[e][1]]);
    if (std::abs(std::abs(middle.y()) - 1.0) < 0.1) continue;
    EXPECT_EQ(owner[e], std::abs(middle.y()) < 1.0 ? 0U : graph.edge_branch[e]) << middle.y();
  }
}

TEST(JunctionZones, EvenAShortArmKeepsHalfOfItself) {
  const CurveSkeleton skeleton = trunk_with_arms(1.1);
  const BranchGraph graph = build_branches(skeleton);
  const std::vector<Index> owner = owning_branches(skeleton, graph);
  for (Index b = 1; b < 3; ++b) {
    double kept = 0.0;
    for (const Index e : graph.branches[b].edges) {
      if (owner[e] == b) kept += skeleton_edge_length(skeleton, e);
    }
    EXPECT_GE(kept, 0.5 * graph.branches[b].length - 1e-9);
  }
}

TEST(JunctionZones, EqualsKeepWhatIsTheirs) {
  const CurveSkeleton skeleton = star_skeleton({4, 5, 6}, 40, 0.5);
  const BranchGraph graph = build_branches(skeleton);
  EXPECT_EQ(owning_branches(skeleton, graph), graph.edge_branch);
}

TEST(JunctionZones, AShortLinkBelongsToTheTrunk) {
  // An H lying down whose bar is shorter than the radius of its widest limb.
  std::vector<Vec3> nodes{Vec3(0, 0, 0), Vec3(0.5, 0, 0)};
  std::vector<std::array<Index, 2>> edges{{0, 1}};
  add_polyline(nodes, edges, 0, kNone, 40, [](double t) { return Vec3(-8 * t, 0, 0); });
  add_polyline(nodes, edges, 0, kNone, 20, [](double t) { return Vec3(0, 5 * t, 0); });
  add_polyline(nodes, edges, 1, kNone, 20, [](double t) { return Vec3(0.5 + 4 * t, 0, 0); });
  add_polyline(nodes, edges, 1, kNone, 20, [](double t) { return Vec3(0.5, -4 * t, 0); });
  CurveSkeleton skeleton = tube_skeleton(nodes, edges, 0.3);
  widen(skeleton, 1.0, [](const Vec3& p) { return p.x() <= 0.6 && std::abs(p.y()) < 0.9; });
  const BranchGraph graph = build_branches(skeleton);
  const std::vector<Index> owner = owning_branches(skeleton, graph);
  EXPECT_NE(graph.edge_branch[0], graph.edge_branch[1]);
  EXPECT_EQ(owner[0], graph.edge_branch[1]);  // edge 1 begins the trunk
}

TEST(JunctionZones, ALinkFarWiderThanItsLimbsIsTheTrunk) {
  std::vector<Vec3> nodes{Vec3(0, 0, 0), Vec3(0.5, 0, 0)};
  std::vector<std::array<Index, 2>> edges{{0, 1}};
  for (const Index end : {Index{0}, Index{1}}) {
    for (const double side : {-1.0, 1.0}) {
      const Vec3 from = nodes[end];
      add_polyline(nodes, edges, end, kNone, 50, [&](double t) {
        return Vec3(from + Vec3(end == 0 ? -4 * t : 4 * t, 4 * side * t, 0));
      });
    }
  }
  CurveSkeleton skeleton = tube_skeleton(nodes, edges, 0.3);
  widen(skeleton, 1.0, [](const Vec3& p) { return p.norm() < 0.9; });
  const BranchGraph graph = build_branches(skeleton);
  const std::vector<Index> owner = owning_branches(skeleton, graph);
  EXPECT_EQ(owner[0], graph.edge_branch[0]);
  EXPECT_EQ(owner[1], graph.edge_branch[0]);  // a limb's first edge
  EXPECT_EQ(owner[50], graph.edge_branch[50]);
}

TEST(JunctionZones, CopeWithLoopsAndWithNothing) {
  EXPECT_TRUE(
      owning_branches(single_node_skeleton(), build_branches(single_node_skeleton())).empty());
  const CurveSkeleton ring = test::ring_skeleton(1.0, 12, 3.0);
  const BranchGraph graph = build_branches(ring);
  EXPECT_EQ(owning_branches(ring, graph), graph.edge_branch);
}

}  // namespace
}  // namespace mgf
