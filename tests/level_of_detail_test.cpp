// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/level_of_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "vcg_ext/skeleton/skeleton_hierarchy.h"

namespace mgf::test {
namespace {

constexpr double kTubeMgf = 3.14159265358979323846;  // a tube of radius 1

Index add_node(CurveSkeleton& skeleton, const Vec3& position, double mgf = kTubeMgf) {
  skeleton.position.push_back(position);
  skeleton.radius.push_back(1.0);
  skeleton.node_mgf.push_back(mgf);
  skeleton.node_eccentricity.push_back(1.0);
  return to_index(skeleton.node_count() - 1);
}

void add_edge(CurveSkeleton& skeleton, Index from, Index to, double birth = kAlwaysThere,
              double eccentricity = 1.0) {
  skeleton.voronoi_edge.push_back(to_index(skeleton.edge_count()));
  skeleton.edge.push_back({from, to});
  skeleton.mgf.push_back(kTubeMgf);
  skeleton.girth.push_back(2 * kTubeMgf);
  skeleton.circumference.push_back(2 * kTubeMgf);
  skeleton.eccentricity.push_back(eccentricity);
  skeleton.theta_birth.push_back(birth);
  skeleton.contacts.push_back({0, 1, 2});
  skeleton.outside.push_back(0);
}

/// Adds a straight chain of unit edges from `start`; returns its last node.
Index add_chain(CurveSkeleton& skeleton, Index start, const Vec3& direction, int edges,
                double birth = kAlwaysThere) {
  Index node = start;
  for (int i = 0; i < edges; ++i) {
    const Index next = add_node(skeleton, skeleton.position[node] + direction);
    add_edge(skeleton, node, next, birth);
    node = next;
  }
  return node;
}

/// What pruning leaves where the surface's edges, all of that length, are next to nothing, or not.
CurveSkeleton pruned_twigs(const CurveSkeleton& skeleton, double least_significance,
                           double edge_length = 0.0) {
  return prune_leaf_branches(skeleton, {edge_length, edge_length, edge_length}, least_significance);
}

Index leaves(const CurveSkeleton& skeleton) {
  const Rows<Index> edges = edges_of_nodes(skeleton);
  Index count = 0;
  for (Index n = 0; n < skeleton.node_count(); ++n) count += edges[n].size() == 1 ? 1 : 0;
  return count;
}

TEST(LevelOfDetail, DropsTheEdgesBornAtOrAboveTheta) {
  CurveSkeleton full;
  const Index root = add_node(full, Vec3::Zero());
  add_chain(full, root, Vec3::UnitX(), 3, -0.9);
  add_chain(full, root, Vec3::UnitY(), 2, -0.5);
  EXPECT_EQ(skeleton_at_theta(full, {root}, 0.0).edge_count(), 5U);
  EXPECT_EQ(skeleton_at_theta(full, {root}, -0.5).edge_count(), 3U);
  EXPECT_EQ(skeleton_at_theta(full, {root}, -0.95).edge_count(), 0U);
}

TEST(LevelOfDetail, ATreeNeverVanishes) {
  CurveSkeleton full;
  const Index root = add_node(full, {3, 4, 5});
  add_chain(full, root, Vec3::UnitX(), 3, -0.9);
  const CurveSkeleton point = skeleton_at_theta(full, {root}, -1.1);
  ASSERT_EQ(point.node_count(), 1U);
  EXPECT_EQ(point.position[0], Vec3(3, 4, 5));
}

TEST(Prune, RemovesASpurInsideTheTubeAndKeepsALimb) {
  CurveSkeleton skeleton;
  const Index root = add_node(skeleton, Vec3::Zero());
  add_chain(skeleton, root, Vec3::UnitX(), 10);
  add_chain(skeleton, root, -Vec3::UnitX(), 10);
  add_chain(skeleton, root, 0.2 * Vec3::UnitY(), 2);  // 0.4 of the tube's radius
  add_chain(skeleton, root, Vec3::UnitZ(), 5);
  ASSERT_EQ(leaves(skeleton), 4U);
  EXPECT_EQ(leaves(pruned_twigs(skeleton, 0.3)), 4U);
  EXPECT_EQ(leaves(pruned_twigs(skeleton, 0.5)), 3U);
  EXPECT_EQ(pruned_twigs(skeleton, 0.5).edge_count(), 25U);
}

TEST(Prune, JudgesWhatMergedAsOneBranch) {
  // A limb of three pieces with a spur at each joint: no piece alone is significant, the limb is.
  CurveSkeleton skeleton;
  const Index root = add_node(skeleton, Vec3::Zero());
  add_chain(skeleton, root, Vec3::UnitX(), 10);
  add_chain(skeleton, root, -Vec3::UnitX(), 10);
  Index joint = root;
  for (int piece = 0; piece < 3; ++piece) {
    joint = add_chain(skeleton, joint, 0.6 * Vec3::UnitZ(), 1);
    add_chain(skeleton, joint, 0.1 * Vec3::UnitY(), 1);
  }
  const CurveSkeleton pruned = pruned_twigs(skeleton, 1.0);
  EXPECT_EQ(leaves(pruned), 3U);
  EXPECT_GE(pruned.edge_count(), 23U);
}

TEST(Prune, KeepsLoopsAndTheLastBranch) {
  CurveSkeleton loop;
  const Index start = add_node(loop, Vec3::Zero());
  Index end = add_chain(loop, start, Vec3::UnitX(), 3);
  end = add_chain(loop, end, Vec3::UnitY(), 3);
  add_edge(loop, end, start);
  add_chain(loop, start, -0.1 * Vec3::UnitX(), 1);
  const CurveSkeleton pruned = pruned_twigs(loop, 100.0);
  EXPECT_EQ(pruned.edge_count(), 7U);
  EXPECT_EQ(betti_numbers(pruned).b1, 1U);

  CurveSkeleton line;
  add_chain(line, add_node(line, Vec3::Zero()), 0.01 * Vec3::UnitX(), 3);
  EXPECT_EQ(pruned_twigs(line, 100.0).edge_count(), 3U);
}

TEST(Prune, RemovesASprayThatEndsAtTheSurface) {
  // Noise on the surface: a spur to it that splits there, where the tubes of its ends are tiny.
  CurveSkeleton skeleton;
  const Index root = add_node(skeleton, Vec3::Zero());
  add_chain(skeleton, root, Vec3::UnitX(), 10);
  add_chain(skeleton, root, -Vec3::UnitX(), 10);
  const Index fork = add_node(skeleton, 0.98 * Vec3::UnitY(), 0.02 * kTubeMgf);
  add_edge(skeleton, root, fork);
  for (const double side : {-1.0, 1.0}) {
    const Index tip = add_node(skeleton, Vec3(0.1 * side, 0.98, 0), 0.01 * kTubeMgf);
    skeleton.radius[tip] = 0.01;
    add_edge(skeleton, fork, tip);
  }
  skeleton.radius[fork] = 0.02;
  ASSERT_EQ(leaves(skeleton), 4U);
  const CurveSkeleton pruned = pruned_twigs(skeleton, 0.3);
  EXPECT_EQ(leaves(pruned), 2U);
  EXPECT_EQ(pruned.edge_count(), 20U);
}

TEST(Prune, TakesReachNotLength) {
  CurveSkeleton skeleton;
  const Index root = add_node(skeleton, Vec3::Zero());
  add_chain(skeleton, root, Vec3::UnitX(), 10);
  add_chain(skeleton, root, -Vec3::UnitX(), 10);
  Index node = root;
  for (int i = 0; i < 20; ++i) {  // four radii long, and never a quarter radius away
    node = add_chain(skeleton, node, Vec3(0, 0.01, i % 2 == 0 ? 0.2 : -0.2), 1);
  }
  EXPECT_EQ(leaves(pruned_twigs(skeleton, 0.3)), 2U);
}

TEST(Prune, AsksForTwigsThatTheMeshResolves) {
  CurveSkeleton skeleton;
  const Index root = add_node(skeleton, Vec3::Zero());
  add_chain(skeleton, root, Vec3::UnitX(), 10);
  add_chain(skeleton, root, -Vec3::UnitX(), 10);
  add_chain(skeleton, root, Vec3::UnitY(), 1);  // ends two radii from the root
  EXPECT_EQ(leaves(pruned_twigs(skeleton, 0.3, 2 / 2.75)), 3U);
  EXPECT_EQ(leaves(pruned_twigs(skeleton, 0.3, 2 / 2.65)), 2U);
  EXPECT_EQ(leaves(pruned_twigs(skeleton, 0.0, 2 / 2.65)), 3U);
}

TEST(Prune, KnowsTheEdgesOfTheSurfaceAtItsNodes) {
  TriangleSurface tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const std::vector<double> spacing = contact_spacing(tetrahedron);
  const double side = (1 + 2 * std::sqrt(2.0)) / 3;
  EXPECT_DOUBLE_EQ(spacing[0], 1.0);
  EXPECT_DOUBLE_EQ(spacing[1], side);
  EXPECT_DOUBLE_EQ(spacing[4], 0.0);

  CurveSkeleton skeleton;
  add_chain(skeleton, add_node(skeleton, Vec3::Zero()), Vec3::UnitX(), 2);
  add_node(skeleton, 9 * Vec3::UnitX());
  skeleton.contacts = {{0, 0, 0}, {1, 2, 3}};
  const std::vector<double> at_nodes = spacing_at_nodes(skeleton, spacing);
  EXPECT_DOUBLE_EQ(at_nodes[0], 1.0);
  EXPECT_DOUBLE_EQ(at_nodes[1], (1 + side) / 2);
  EXPECT_DOUBLE_EQ(at_nodes[2], side);
  EXPECT_DOUBLE_EQ(at_nodes[3], 0.0);
}

TEST(Prune, ZeroKeepsThePapersOutput) {
  CurveSkeleton skeleton;
  const Index root = add_node(skeleton, Vec3::Zero());
  add_chain(skeleton, root, Vec3::UnitX(), 3);
  add_chain(skeleton, root, Vec3::UnitY(), 3);
  add_chain(skeleton, root, 1e-3 * Vec3::UnitZ(), 1);
  EXPECT_EQ(pruned_twigs(skeleton, 0.0).edge_count(), 7U);
}

TEST(GraphEdits, ContractsShortEdgesButNoLoop) {
  CurveSkeleton skeleton;
  const Index a = add_node(skeleton, Vec3::Zero());
  const Index b = add_chain(skeleton, a, Vec3::UnitX(), 1);
  const Index c = add_chain(skeleton, b, 1e-12 * Vec3::UnitX(), 1);
  add_chain(skeleton, c, Vec3::UnitX(), 1);
  std::vector<Index> number;
  const CurveSkeleton contracted = contract_short_edges(skeleton, 1e-9, number);
  EXPECT_EQ(contracted.edge_count(), 2U);
  EXPECT_EQ(contracted.node_count(), 3U);
  EXPECT_EQ(number[b], number[c]);

  CurveSkeleton tiny_loop;
  const Index p = add_node(tiny_loop, Vec3::Zero());
  const Index q = add_chain(tiny_loop, p, 1e-12 * Vec3::UnitX(), 1);
  add_edge(tiny_loop, q, p);
  EXPECT_EQ(betti_numbers(contract_short_edges(tiny_loop, 1e-9, number)).b1, 1U);
}

TEST(GraphEdits, FillsUndefinedEccentricityFromNeighbours) {
  CurveSkeleton skeleton;
  Index node = add_node(skeleton, Vec3::Zero());
  for (const double e : {2.0, std::nan(""), 4.0}) {
    const Index next = add_node(skeleton, skeleton.position[node] + Vec3::UnitX());
    add_edge(skeleton, node, next, kAlwaysThere, e);
    node = next;
  }
  fill_undefined_eccentricity(skeleton);
  EXPECT_DOUBLE_EQ(skeleton.eccentricity[1], 3.0);
  EXPECT_DOUBLE_EQ(skeleton.girth[1] / skeleton.circumference[1], 3.0);
}

}  // namespace
}  // namespace mgf::test
