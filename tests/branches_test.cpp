// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/branches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "tests/graph_fixtures.h"
#include "vcg_ext/skeleton/eccentricity_filter.h"

namespace mgf {
namespace {

using test::add_polyline;
using test::line_skeleton;
using test::renumbered;
using test::ring_skeleton;
using test::single_node_skeleton;
using test::star_skeleton;
using test::tube_skeleton;

/// Every edge is in exactly one branch, in the place that the branch says, and ids agree.
void expect_consistent(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  std::vector<int> uses(skeleton.edge_count(), 0);
  for (Index b = 0; b < graph.branches.size(); ++b) {
    const Branch& branch = graph.branches[b];
    ASSERT_EQ(branch.nodes.size(), branch.edges.size() + 1);
    EXPECT_EQ(branch.nodes.front(), branch.first_node);
    EXPECT_EQ(branch.nodes.back(), branch.last_node);
    EXPECT_EQ(branch.on_cycle, branch.cycle != kNone);
    EXPECT_TRUE(branch.on_cycle || !branch.closes_cycle);
    for (std::size_t i = 0; i < branch.edges.size(); ++i) {
      ++uses[branch.edges[i]];
      EXPECT_EQ(graph.edge_branch[branch.edges[i]], b);
      const std::set<Index> ends(skeleton.edge[branch.edges[i]].begin(),
                                 skeleton.edge[branch.edges[i]].end());
      EXPECT_EQ(ends, (std::set<Index>{branch.nodes[i], branch.nodes[i + 1]}));
    }
    for (std::size_t i = 1; i + 1 < branch.nodes.size(); ++i) {
      EXPECT_EQ(graph.node_kind[branch.nodes[i]], NodeKind::kRegular);
    }
    if (branch.parent != kNone) {
      const Branch& parent = graph.branches[branch.parent];
      EXPECT_EQ(parent.last_node, branch.first_node);
      EXPECT_FALSE(parent.closes_cycle);
      EXPECT_EQ(parent.component, branch.component);
    }
  }
  for (const int count : uses) EXPECT_EQ(count, 1);
  const auto nodes = static_cast<long>(skeleton.node_count());
  const auto edges = static_cast<long>(skeleton.edge_count());
  EXPECT_EQ(static_cast<long>(graph.components) - static_cast<long>(graph.cycles), nodes - edges);
}

/// Two rings that share a node at the origin, a stick from the second, and a ring apart.
CurveSkeleton figure_eight_with_stick() {
  std::vector<Vec3> nodes{Vec3::Zero()};
  std::vector<std::array<Index, 2>> edges;
  const auto ring = [&](double radius, double side) {
    return [=](double t) {
      return Vec3(side * radius * (1 - std::cos(2 * M_PI * t)), radius * std::sin(2 * M_PI * t), 0);
    };
  };
  add_polyline(nodes, edges, 0, 0, 12, ring(0.7, -1.0));
  const Index middle =
      add_polyline(nodes, edges, 0, kNone, 6, [&](double t) { return ring(2.0, 1.0)(0.5 * t); });
  add_polyline(nodes, edges, middle, 0, 6, [&](double t) { return ring(2.0, 1.0)(0.5 + 0.5 * t); });
  add_polyline(nodes, edges, middle, kNone, 3, [](double t) { return Vec3(4 + t, 0, 0); });
  const Index apart = to_index(nodes.size());
  nodes.emplace_back(10.5, 0, 0);
  add_polyline(nodes, edges, apart, apart, 8, [](double t) {
    return Vec3(10 + 0.5 * std::cos(2 * M_PI * t), 0.5 * std::sin(2 * M_PI * t), 0);
  });
  return tube_skeleton(nodes, edges, 0.1);
}

TEST(Branches, ALoneNodeIsAComponentWithoutBranches) {
  const BranchGraph graph = build_branches(single_node_skeleton());
  EXPECT_TRUE(graph.branches.empty());
  EXPECT_EQ(graph.components, 1U);
  EXPECT_EQ(graph.cycles, 0U);
  EXPECT_EQ(graph.node_kind, std::vector<NodeKind>{NodeKind::kIsolated});
  EXPECT_EQ(graph.node_branch, std::vector<Index>{kNone});
}

TEST(Branches, AnEmptySkeletonHasNone) {
  const BranchGraph graph = build_branches(CurveSkeleton());
  EXPECT_TRUE(graph.branches.empty());
  EXPECT_EQ(graph.components, 0U);
}

TEST(Branches, ALineIsOneBranchMeasuredExactly) {
  CurveSkeleton skeleton = line_skeleton(4.0, 4, 0.5);
  skeleton.radius = {1.0, 2.0, 3.0, 2.0, 1.0};
  skeleton.girth = {6.0, 8.0, 8.0, 10.0};
  skeleton.eccentricity = {1.0, 3.0, 2.0, 9.0};
  const BranchGraph graph = build_branches(skeleton);
  expect_consistent(skeleton, graph);
  ASSERT_EQ(graph.branches.size(), 1U);
  const Branch& branch = graph.branches[0];
  EXPECT_DOUBLE_EQ(branch.length, 4.0);
  EXPECT_DOUBLE_EQ(branch.chord, 4.0);
  EXPECT_DOUBLE_EQ(branch.tortuosity, 1.0);
  EXPECT_DOUBLE_EQ(branch.radius_min, 1.0);
  EXPECT_DOUBLE_EQ(branch.radius_mean, 2.0);
  EXPECT_DOUBLE_EQ(branch.radius_max, 3.0);
  EXPECT_DOUBLE_EQ(branch.girth_min, 6.0);
  EXPECT_DOUBLE_EQ(branch.girth_mean, 8.0);
  EXPECT_DOUBLE_EQ(branch.girth_max, 10.0);
  EXPECT_DOUBLE_EQ(branch.eccentricity_median, 2.0);
  EXPECT_EQ(branch.parent, kNone);
}

TEST(Branches, TortuosityOfAHalfCircleIsHalfPi) {
  std::vector<Vec3> nodes{Vec3(1, 0, 0)};
  std::vector<std::array<Index, 2>> edges;
  add_polyline(nodes, edges, 0, kNone, 400,
               [](double t) { return Vec3(std::cos(M_PI * t), std::sin(M_PI * t), 0); });
  const BranchGraph graph = build_branches(tube_skeleton(nodes, edges, 0.1));
  EXPECT_NEAR(graph.branches.at(0).tortuosity, M_PI / 2, 1e-4);
}

TEST(Branches, AStarHasItsArmsByFallingLength) {
  const CurveSkeleton skeleton = star_skeleton({2.0, 3.0, 1.0}, 5, 0.2);
  const BranchGraph graph = build_branches(skeleton);
  expect_consistent(skeleton, graph);
  ASSERT_EQ(graph.branches.size(), 3U);
  EXPECT_NEAR(graph.branches[0].length, 3.0, 1e-12);
  EXPECT_NEAR(graph.branches[1].length, 2.0, 1e-12);
  EXPECT_NEAR(graph.branches[2].length, 1.0, 1e-12);
  EXPECT_EQ(graph.junction_clusters, 1U);
  for (const Branch& branch : graph.branches) {
    EXPECT_EQ(branch.first_node, 0U);  // the root
    EXPECT_EQ(branch.parent, kNone);
    EXPECT_FALSE(branch.on_cycle);
    EXPECT_EQ(graph.node_kind[branch.last_node], NodeKind::kTip);
  }
  EXPECT_EQ(graph.node_branch[0], 0U);
}

TEST(Branches, ARingIsOneClosedBranch) {
  const CurveSkeleton skeleton = ring_skeleton(2.0, 60, 0.3);
  const BranchGraph graph = build_branches(skeleton);
  expect_consistent(skeleton, graph);
  ASSERT_EQ(graph.branches.size(), 1U);
  const Branch& ring = graph.branches[0];
  EXPECT_EQ(ring.first_node, ring.last_node);
  EXPECT_EQ(ring.cycle, 0U);
  EXPECT_TRUE(ring.closes_cycle);
  EXPECT_EQ(ring.parent, kNone);
  EXPECT_EQ(ring.tortuosity, 0.0);
  EXPECT_NEAR(ring.length, 4 * M_PI, 0.01);
  EXPECT_EQ(graph.cycles, 1U);
}

TEST(Branches, LoopsThatShareOnlyANodeAreTwoCycles) {
  const CurveSkeleton skeleton = figure_eight_with_stick();
  const BranchGraph graph = build_branches(skeleton);
  expect_consistent(skeleton, graph);
  ASSERT_EQ(graph.branches.size(), 5U);
  EXPECT_EQ(graph.components, 2U);
  EXPECT_EQ(graph.cycles, 3U);
  std::multiset<Index> cycles;
  int closing = 0;
  for (const Branch& branch : graph.branches) {
    cycles.insert(branch.cycle);
    closing += branch.closes_cycle ? 1 : 0;
  }
  EXPECT_EQ(cycles.count(kNone), 1U);  // the stick
  EXPECT_EQ(closing, 3);
  std::set<Index> distinct(cycles.begin(), cycles.end());
  EXPECT_EQ(distinct.size(), 4U);  // three loops and none
  // The two halves of the large ring share a cycle.
  EXPECT_EQ(graph.branches[0].cycle, graph.branches[1].cycle);
}

TEST(Branches, LoopsThatShareABranchAreOneCycle) {
  std::vector<Vec3> nodes{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  std::vector<std::array<Index, 2>> edges;
  for (const double height : {0.0, 1.0, -1.0}) {
    add_polyline(nodes, edges, 0, 1, 8,
                 [&](double t) { return Vec3(t, height * std::sin(M_PI * t), 0); });
  }
  const CurveSkeleton skeleton = tube_skeleton(nodes, edges, 0.01);
  const BranchGraph graph = build_branches(skeleton);
  expect_consistent(skeleton, graph);
  EXPECT_EQ(graph.cycles, 2U);
  for (const Branch& branch : graph.branches) EXPECT_EQ(branch.cycle, 0U);
}

TEST(Branches, DontDependOnTheNumbering) {
  CurveSkeleton skeleton = figure_eight_with_stick();
  for (Index v = 0; v < skeleton.node_count(); ++v) skeleton.node_mgf[v] += 0.001 * v;
  const BranchGraph graph = build_branches(skeleton);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const CurveSkeleton other_skeleton = renumbered(skeleton, seed);
    const BranchGraph other = build_branches(other_skeleton);
    expect_consistent(other_skeleton, other);
    ASSERT_EQ(other.branches.size(), graph.branches.size());
    for (std::size_t b = 0; b < graph.branches.size(); ++b) {
      const Branch& one = graph.branches[b];
      const Branch& two = other.branches[b];
      EXPECT_EQ(one.length, two.length);
      EXPECT_EQ(one.parent, two.parent);
      EXPECT_EQ(one.cycle, two.cycle);
      EXPECT_EQ(one.closes_cycle, two.closes_cycle);
      ASSERT_EQ(one.nodes.size(), two.nodes.size());
      for (std::size_t i = 0; i < one.nodes.size(); ++i) {
        EXPECT_EQ(skeleton.position[one.nodes[i]], other_skeleton.position[two.nodes[i]]);
      }
    }
  }
}

TEST(Branches, NearJunctionsCountAsOne) {
  // An H whose bar is shorter than the radius, and one whose bar isn't.
  for (const double bar : {0.5, 1.5}) {
    std::vector<Vec3> nodes{Vec3(0, 0, 0), Vec3(bar, 0, 0)};
    std::vector<std::array<Index, 2>> edges{{0, 1}};
    for (const Index end : {Index{0}, Index{1}}) {
      for (const double side : {-1.0, 1.0}) {
        const Vec3 from = nodes[end];
        add_polyline(nodes, edges, end, kNone, 4,
                     [&](double t) { return Vec3(from + Vec3(0, 5 * side * t, 0)); });
      }
    }
    const BranchGraph graph = build_branches(tube_skeleton(nodes, edges, 1.0));
    EXPECT_EQ(graph.junction_clusters, bar < 1.0 ? 1U : 2U);
    EXPECT_EQ(graph.junction_cluster[0] == graph.junction_cluster[1], bar < 1.0);
    EXPECT_EQ(graph.junction_cluster[2], kNone);
  }
}

TEST(Branches, ZeroLengthEdgesAreMeasuredWithoutDividingByZero) {
  const CurveSkeleton skeleton = tube_skeleton({Vec3(1, 1, 1), Vec3(1, 1, 1)}, {{0, 1}}, 0.5);
  const BranchGraph graph = build_branches(skeleton);
  const Branch& branch = graph.branches.at(0);
  EXPECT_EQ(branch.length, 0.0);
  EXPECT_EQ(branch.tortuosity, 0.0);
  EXPECT_DOUBLE_EQ(branch.radius_mean, 0.5);
  EXPECT_DOUBLE_EQ(branch.eccentricity_median, 1.0);
}

TEST(WeightedMedian, CountsByWeightAndSkipsWhatIsntFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(weighted_median({3.0, 1.0, 2.0}, {1.0, 1.0, 1.0}), 2.0);
  EXPECT_EQ(weighted_median({3.0, 1.0, 2.0}, {5.0, 1.0, 1.0}), 3.0);
  EXPECT_EQ(weighted_median({2.0, 1.0}, {1.0, 1.0}), 1.0);  // the lower of two
  EXPECT_EQ(weighted_median({nan, 4.0}, {9.0, 1.0}), 4.0);
  EXPECT_EQ(weighted_median({5.0, 7.0, 6.0}, {0.0, 0.0, 0.0}), 6.0);
  EXPECT_EQ(weighted_median({nan}, {1.0}), 0.0);
}

TEST(EccentricityFilter, RemovesAnIslandButKeepsAStep) {
  CurveSkeleton skeleton = line_skeleton(20.0, 200, 1.0);
  for (Index e = 100; e < 200; ++e) skeleton.eccentricity[e] = 2.0;
  skeleton.eccentricity[50] = 5.0;
  skeleton.eccentricity[150] = 0.9;
  skeleton.eccentricity[151] = 0.9;
  const std::vector<double> filtered = filtered_eccentricity(skeleton, build_branches(skeleton));
  for (Index e = 0; e < 200; ++e) {
    if (e == 99 || e == 100) continue;  // half their window is on the other side
    EXPECT_EQ(filtered[e], e < 100 ? 1.0 : 2.0) << e;
  }
}

TEST(EccentricityFilter, GoesRoundALoopAndCountsEachEdgeOnce) {
  CurveSkeleton skeleton = ring_skeleton(1.0, 5, 100.0);  // the window is longer than the loop
  skeleton.eccentricity = {1.0, 2.0, 3.0, 4.0, 5.0};
  const std::vector<double> filtered = filtered_eccentricity(skeleton, build_branches(skeleton));
  for (const double value : filtered) EXPECT_EQ(value, 3.0);
}

}  // namespace
}  // namespace mgf
