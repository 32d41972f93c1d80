// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "tests/graph_fixtures.h"
#include "vcg_ext/skeleton/resampling.h"

namespace mgf {
namespace {

using test::add_polyline;
using test::everywhere;
using test::line_skeleton;
using test::ring_skeleton;
using test::single_node_skeleton;
using test::star_skeleton;
using test::tube_skeleton;

constexpr double kDegree = M_PI / 180;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * (b - a)).norm();
}

double distance_to_graph(const Vec3& p, const CurveSkeleton& skeleton) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::array<Index, 2>& e : skeleton.edge) {
    least =
        std::min(least, distance_to_segment(p, skeleton.position[e[0]], skeleton.position[e[1]]));
  }
  return least;
}

/// Moves every node by up to `amplitude` in each coordinate.
CurveSkeleton shaken(CurveSkeleton skeleton, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amplitude, amplitude);
  for (Vec3& p : skeleton.position) p += Vec3(shift(random), shift(random), shift(random));
  return skeleton;
}

CurveSkeleton helix(double radius) {
  std::vector<Vec3> nodes{Vec3(3, 0, 0)};
  std::vector<std::array<Index, 2>> edges;
  add_polyline(nodes, edges, 0, kNone, 300, [](double t) {
    return Vec3(3 * std::cos(4 * M_PI * t), 3 * std::sin(4 * M_PI * t), 8 * t);
  });
  return tube_skeleton(nodes, edges, radius);
}

/// The raw kept nodes are there once, in place, and no raw or smooth point strays.
void expect_faithful(const CurveSkeleton& raw, const BranchGraph& graph,
                     const SmoothSkeleton& smooth, double max_shift) {
  std::multiset<Index> kept(smooth.raw_node.begin(), smooth.raw_node.end());
  for (Index v = 0; v < raw.node_count(); ++v) {
    EXPECT_EQ(kept.count(v), graph.node_kind[v] == NodeKind::kRegular ? 0U : 1U);
    EXPECT_LE(distance_to_graph(raw.position[v], smooth), max_shift + 1e-12);
  }
  for (Index v = 0; v < smooth.node_count(); ++v) {
    EXPECT_LE(distance_to_graph(smooth.position[v], raw), max_shift + 1e-12);
    if (smooth.raw_node[v] != kNone) {
      EXPECT_EQ(smooth.position[v], raw.position[smooth.raw_node[v]]);
    }
  }
  const BranchGraph again = build_branches(smooth);
  EXPECT_EQ(again.branches.size(), graph.branches.size());
  EXPECT_EQ(again.components, graph.components);
  EXPECT_EQ(again.cycles, graph.cycles);
  for (const std::array<Index, 2>& ends : smooth.edge) EXPECT_NE(ends[0], ends[1]);
  std::set<std::set<Index>> distinct;
  for (const std::array<Index, 2>& ends : smooth.edge) distinct.insert({ends[0], ends[1]});
  EXPECT_EQ(distinct.size(), smooth.edge_count());
}

TEST(Smoothing, TakesTheZigzagOffAHelix) {
  const CurveSkeleton clean = helix(0.5);
  const CurveSkeleton raw = shaken(clean, 0.08, 1);
  const BranchGraph graph = build_branches(raw);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, everywhere());
  expect_faithful(raw, graph, smooth, 0.25);
  EXPECT_LE(smooth.mean_turning, 5 * kDegree);
  double sum = 0.0;
  for (const Vec3& p : smooth.position) sum += distance_to_graph(p, clean);
  EXPECT_LE(sum / static_cast<double>(smooth.node_count()), 0.1 * 0.5);
}

TEST(Smoothing, DoesntShrinkACircle) {
  const CurveSkeleton raw = ring_skeleton(5.0, 200, 1.0);
  const BranchGraph graph = build_branches(raw);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, everywhere());
  expect_faithful(raw, graph, smooth, 0.5);
  for (const Vec3& p : smooth.position) EXPECT_NEAR(p.norm(), 5.0, 2e-3);
}

TEST(Smoothing, KeepsTheGraphOfAStar) {
  const CurveSkeleton raw = shaken(star_skeleton({4, 5, 6, 7}, 60, 0.5), 0.05, 2);
  const BranchGraph graph = build_branches(raw);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, everywhere());
  expect_faithful(raw, graph, smooth, 0.25);
  EXPECT_LE(smooth.mean_turning, 5 * kDegree);
}

TEST(Smoothing, ShiftsNoFurtherThanAllowedEvenWhereTheZigzagIsWild) {
  const CurveSkeleton raw = shaken(helix(0.2), 0.5, 3);
  const BranchGraph graph = build_branches(raw);
  expect_faithful(raw, graph, smooth_skeleton(raw, graph, everywhere()), 0.1);
}

// From side to side of a blade of width `width` whose ball has a radius of 0.1.
CurveSkeleton zigzag(double width) {
  std::vector<Vec3> nodes{Vec3::Zero()};
  std::vector<std::array<Index, 2>> edges;
  add_polyline(nodes, edges, 0, kNone, 80,
               [](double t) { return Vec3(4 * t, std::lround(80 * t) % 2 == 0 ? 0.0 : 0.4, 0.0); });
  CurveSkeleton raw = tube_skeleton(nodes, edges, 0.1);
  for (double& mgf : raw.node_mgf) mgf = width;
  return raw;
}

TEST(Smoothing, StraightensTheZigzagOfAPlateThinnerThanItsMesh) {
  const CurveSkeleton raw = zigzag(4.0);
  const BranchGraph graph = build_branches(raw);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, everywhere());
  expect_faithful(raw, graph, smooth, 0.5 * 4.0 / M_PI);
  EXPECT_LE(smooth.mean_turning, 5 * kDegree);
  for (const double radius : smooth.radius) EXPECT_DOUBLE_EQ(radius, 0.1);
}

TEST(Smoothing, CantStraightenAZigzagAsWideAsThePlate) {
  const CurveSkeleton raw = zigzag(0.2 * M_PI);  // it may be shifted by half of 0.2
  const BranchGraph graph = build_branches(raw);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, everywhere());
  expect_faithful(raw, graph, smooth, 0.1);
  EXPECT_GT(smooth.mean_turning, 5 * kDegree);
}

TEST(Smoothing, CountsInRadiiOfTheTubeOnlyWhereThatOfTheBallLeavesAZigzag) {
  const auto smooth_wave = [](double period, double width) {
    std::vector<Vec3> nodes{Vec3::Zero()};
    std::vector<std::array<Index, 2>> edges;
    add_polyline(nodes, edges, 0, kNone, 200,
                 [&](double t) { return Vec3(12 * t, std::sin(2 * M_PI * 12 * t / period), 0); });
    CurveSkeleton raw = tube_skeleton(nodes, edges, 0.5);
    for (double& mgf : raw.node_mgf) mgf = width;
    return smooth_skeleton(raw, build_branches(raw), everywhere());
  };
  const double tube = 0.5 * M_PI;
  const double plate = 4.0 * tube;
  EXPECT_EQ(smooth_wave(3.0, plate).position, smooth_wave(3.0, tube).position);
  EXPECT_GT(smooth_wave(3.0, plate).mean_turning, 4 * kDegree);  // it would gain by the tube's
  EXPECT_GT(smooth_wave(2.0, tube).mean_turning, 5 * kDegree);
  EXPECT_LT(smooth_wave(2.0, plate).mean_turning, 2 * kDegree);
}

TEST(BranchCurve, IsMeasuredInRadiiOfTheBallOrOfTheTube) {
  CurveSkeleton skeleton = line_skeleton(6.0, 2, 0.5);
  skeleton.node_mgf = {2.0 * M_PI, 2.0 * M_PI, 0.1};
  const BranchGraph graph = build_branches(skeleton);
  const BranchCurve ball = branch_curve(skeleton, graph.branches[0], LocalRadius::kBall);
  EXPECT_EQ(ball.unit, (std::vector<double>{0.5, 0.5, 0.5}));
  EXPECT_DOUBLE_EQ(ball.parameter.back(), 12.0);
  BranchCurve tube = branch_curve(skeleton, graph.branches[0], LocalRadius::kTube);
  std::sort(tube.unit.begin(), tube.unit.end());  // whichever end is first
  EXPECT_EQ(tube.unit, (std::vector<double>{0.5, 2.0, 2.0})) << "the ball's where it is larger";
  EXPECT_EQ(tube.radius, (std::vector<double>{0.5, 0.5, 0.5}));
}

TEST(BranchCurve, IsMeasuredInRadiiOfTheBallWhereTheMgfIsInfinite) {
  CurveSkeleton skeleton = line_skeleton(6.0, 2, 0.5);
  skeleton.node_mgf.assign(3, std::numeric_limits<double>::infinity());
  const BranchGraph graph = build_branches(skeleton);
  const BranchCurve curve = branch_curve(skeleton, graph.branches[0], LocalRadius::kTube);
  EXPECT_EQ(curve.unit, (std::vector<double>{0.5, 0.5, 0.5}));
  EXPECT_EQ(curve.mgf, (std::vector<double>{0.0, 0.0, 0.0})) << "to be interpolated";
}

TEST(Smoothing, FollowsTheRawCurveWhereNothingElseIsInside) {
  const CurveSkeleton raw = shaken(line_skeleton(6.0, 20, 1.0), 0.2, 4);
  const auto only_on_it = [&](const Vec3& a, const Vec3& b) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      if (distance_to_graph((1 - t) * a + t * b, raw) > 1e-9) return false;
    }
    return true;
  };
  const BranchGraph graph = build_branches(raw);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, test::shape_of_segments(only_on_it));
  EXPECT_EQ(smooth.outside_edges, 0U);
  expect_faithful(raw, graph, smooth, 1e-9);
}

TEST(Smoothing, DoesntCutTheCornerOfANarrowBend) {
  std::vector<Vec3> nodes{Vec3(0, 0, 0)};
  std::vector<std::array<Index, 2>> edges;
  const Index corner =
      add_polyline(nodes, edges, 0, kNone, 20, [](double t) { return Vec3(4 * t, 0, 0); });
  add_polyline(nodes, edges, corner, kNone, 20, [](double t) { return Vec3(4, 4 * t, 0); });
  const CurveSkeleton raw = tube_skeleton(nodes, edges, 1.0);
  const auto in_corridor = [](const Vec3& a, const Vec3& b) {
    for (int i = 0; i <= 20; ++i) {
      const Vec3 p = a + (b - a) * (i / 20.0);
      if (p.x() < 3.95 && p.y() > 0.05) return false;
    }
    return true;
  };
  const BranchGraph graph = build_branches(raw);
  EXPECT_GT(smooth_skeleton(raw, graph, everywhere()).position.size(), 0U);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, test::shape_of_segments(in_corridor));
  EXPECT_EQ(smooth.outside_edges, 0U);
  expect_faithful(raw, graph, smooth, 0.5);
}

TEST(Smoothing, CountsEdgesThatAreOutsideInTheRawOneToo) {
  const CurveSkeleton raw = line_skeleton(3.0, 3, 1.0);
  const auto broken_in_the_middle = [](const Vec3& a, const Vec3& b) {
    return std::max(a.x(), b.x()) <= 1.4 || std::min(a.x(), b.x()) >= 1.6;
  };
  const SmoothSkeleton smooth =
      smooth_skeleton(raw, build_branches(raw), test::shape_of_segments(broken_in_the_middle));
  EXPECT_GE(smooth.outside_edges, 1U);
  EXPECT_LT(smooth.outside_edges, smooth.edge_count());
  EXPECT_EQ(std::count(smooth.outside.begin(), smooth.outside.end(), char{1}),
            static_cast<long>(smooth.outside_edges));
}

TEST(Smoothing, CarriesTheMeasuresOfTheEdgeBeneath) {
  CurveSkeleton raw = line_skeleton(4.0, 4, 1.0);
  raw.girth = {1, 2, 3, 4};
  raw.node_mgf = {0, 1, 2, 3, 4};
  const SmoothSkeleton smooth = smooth_skeleton(raw, build_branches(raw), everywhere());
  ASSERT_EQ(smooth.raw_edge.size(), smooth.edge_count());
  for (Index e = 0; e < smooth.edge_count(); ++e) {
    const double middle =
        0.5 * (smooth.position[smooth.edge[e][0]].x() + smooth.position[smooth.edge[e][1]].x());
    EXPECT_EQ(smooth.girth[e], std::floor(middle) + 1);
    EXPECT_EQ(smooth.girth[e], raw.girth[smooth.raw_edge[e]]);
  }
  for (Index v = 0; v < smooth.node_count(); ++v) {
    EXPECT_NEAR(smooth.node_mgf[v], smooth.position[v].x(), 1e-9);
    EXPECT_DOUBLE_EQ(smooth.node_eccentricity[v], 1.0);
  }
}

TEST(Smoothing, CopesWithTheSmallestSkeletons) {
  const CurveSkeleton one = single_node_skeleton();
  const SmoothSkeleton still_one = smooth_skeleton(one, build_branches(one), everywhere());
  EXPECT_EQ(still_one.node_count(), 1U);
  EXPECT_EQ(still_one.edge_count(), 0U);
  EXPECT_EQ(smooth_skeleton({}, build_branches({}), everywhere()).node_count(), 0U);

  const CurveSkeleton point = tube_skeleton({Vec3::Ones(), Vec3::Ones()}, {{0, 1}}, 0.5);
  for (const Vec3& p : smooth_skeleton(point, build_branches(point), everywhere()).position) {
    EXPECT_EQ(p, Vec3::Ones());
  }
  const CurveSkeleton triangle = ring_skeleton(1.0, 3, 10.0);  // a loop far smaller than the tube
  const BranchGraph graph = build_branches(triangle);
  expect_faithful(triangle, graph, smooth_skeleton(triangle, graph, everywhere()), 5.0);
}

TEST(Smoothing, KeepsParallelAndClosedBranchesApart) {
  std::vector<Vec3> nodes{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  std::vector<std::array<Index, 2>> edges{{0, 1}};
  for (const double y : {0.3, -0.3}) {
    add_polyline(nodes, edges, 0, 1, 2, [&](double /*t*/) { return Vec3(0.5, y, 0); });
  }
  add_polyline(nodes, edges, 0, 0, 3, [](double t) { return Vec3(-t, t < 0.5 ? 0.3 : -0.3, 0); });
  const CurveSkeleton raw = tube_skeleton(nodes, edges, 5.0);
  const BranchGraph graph = build_branches(raw);
  EXPECT_EQ(graph.cycles, 3U);
  expect_faithful(raw, graph, smooth_skeleton(raw, graph, everywhere()), 2.5);
}

}  // namespace
}  // namespace mgf
