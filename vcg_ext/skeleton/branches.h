// SPDX-License-Identifier: GPL-3.0-or-later
// The branches of a curve skeleton: how the graph is cut at its junctions, ordered and rooted.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branch_chains.h"
#include "vcg_ext/skeleton/branch_tree.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/graph_edits.h"
#include "vcg_ext/skeleton/weighted_median.h"

namespace mgf {

/// What a node is in the graph.
enum class NodeKind : char { kRegular = 0, kTip = 1, kJunction = 2, kIsolated = 3 };

/// A maximal chain of edges without a junction inside, directed away from the root of its
/// component. Lengths in mesh units; means are weighted by length.
struct Branch {
  Index first_node = kNone;   ///< the end nearer the root; of a closed branch, where it is cut
  Index last_node = kNone;    ///< the other end; equal to `first_node` for a closed branch
  Index parent = kNone;       ///< branch through which the root is reached, or kNone at the root
  Index component = 0;        ///< connected component of the skeleton
  Index cycle = kNone;        ///< group of loops (block) that it is part of, or kNone
  bool on_cycle = false;      ///< part of a loop of the skeleton: `cycle` is not kNone
  bool closes_cycle = false;  ///< not in the spanning tree: cutting it opens one loop
  double length = 0.0;
  double chord = 0.0;       ///< straight distance between the ends
  double tortuosity = 0.0;  ///< length / chord; 0 for a closed branch, where it is undefined
  double radius_min = 0.0, radius_mean = 0.0, radius_max = 0.0;
  double girth_min = 0.0, girth_mean = 0.0, girth_max = 0.0;
  double eccentricity_median = 0.0;  ///< weighted by length
  bool tubular = false;              ///< half of its own surface or more is labelled so
  double area_share = 0.0;           ///< of the input surface that belongs to it, in [0, 1]
  double tubular_share = 0.0;        ///< of its own surface labelled tubular, in [0, 1]
  std::vector<Index> nodes;          ///< from `first_node` to `last_node`
  std::vector<Index> edges;          ///< edge i joins nodes i and i + 1
};

/// The branches of a skeleton. Ids are positions: components by falling total length, then branches
/// by falling length, then by place; so they don't depend on how the skeleton is numbered.
struct BranchGraph {
  std::vector<Branch> branches;
  std::vector<Index> edge_branch;   ///< one per skeleton edge
  std::vector<NodeKind> node_kind;  ///< one per skeleton node
  std::vector<Index> node_branch;   ///< one per node: a branch it lies on; a junction's longest;
                                    ///< kNone for an isolated node
  std::vector<Index> junction_cluster;  ///< one per node: junctions joined by a branch shorter than
                                        ///< their radius share it; kNone for other nodes
  Index components = 0;
  Index cycles = 0;             ///< first Betti number of the skeleton
  Index junction_clusters = 0;  ///< junctions, when near ones count as one
};

namespace branching {

inline std::vector<NodeKind> kinds_of_nodes(const Rows<Index>& node_edges) {
  std::vector<NodeKind> kind(node_edges.size());
  for (std::size_t v = 0; v < kind.size(); ++v) {
    const std::size_t degree = node_edges[v].size();
    kind[v] = degree == 0   ? NodeKind::kIsolated
              : degree == 1 ? NodeKind::kTip
              : degree == 2 ? NodeKind::kRegular
                            : NodeKind::kJunction;
  }
  return kind;
}

/// Smallest, largest and weighted mean of a quantity along a branch.
struct Range {
  double least = 0.0, mean = 0.0, most = 0.0;
};

/// The range of the finite `values`; a plain mean if no weight is positive, zeros if none is
/// finite.
inline Range weighted_range(const std::vector<double>& values, const std::vector<double>& weights) {
  Range range;
  double weight_sum = 0.0;
  double weighted_sum = 0.0;
  double plain_sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    range.least = count == 0 ? values[i] : std::min(range.least, values[i]);
    range.most = count == 0 ? values[i] : std::max(range.most, values[i]);
    weight_sum += weights[i];
    weighted_sum += weights[i] * values[i];
    plain_sum += values[i];
    ++count;
  }
  if (weight_sum > 0.0) {
    range.mean = weighted_sum / weight_sum;
  } else if (count > 0) {
    range.mean = plain_sum / static_cast<double>(count);
  }
  return range;
}

/// Fills the measures of `branch` that come from the skeleton alone.
inline void measure_branch(const CurveSkeleton& skeleton, Branch& branch) {
  std::vector<double> edge_length;
  std::vector<double> girth;
  std::vector<double> eccentricity;
  std::vector<double> node_weight(branch.nodes.size(), 0.0);
  std::vector<double> radius;
  for (std::size_t i = 0; i < branch.edges.size(); ++i) {
    const Index e = branch.edges[i];
    edge_length.push_back(skeleton_edge_length(skeleton, e));
    girth.push_back(skeleton.girth[e]);
    eccentricity.push_back(skeleton.eccentricity[e]);
    node_weight[i] += 0.5 * edge_length.back();
    node_weight[i + 1] += 0.5 * edge_length.back();
    branch.length += edge_length.back();
  }
  for (const Index v : branch.nodes) radius.push_back(skeleton.radius[v]);
  branch.chord =
      (skeleton.position[branch.last_node] - skeleton.position[branch.first_node]).norm();
  branch.tortuosity = branch.chord > 0.0 ? branch.length / branch.chord : 0.0;

  const Range radii = weighted_range(radius, node_weight);
  branch.radius_min = radii.least;
  branch.radius_mean = radii.mean;
  branch.radius_max = radii.most;
  const Range girths = weighted_range(girth, edge_length);
  branch.girth_min = girths.least;
  branch.girth_mean = girths.mean;
  branch.girth_max = girths.most;
  branch.eccentricity_median = weighted_median(eccentricity, edge_length);
}

/// One branch per node: of several, the first, which is the longest of its component.
inline std::vector<Index> branches_of_nodes(const BranchGraph& graph, std::size_t node_count) {
  std::vector<Index> node_branch(node_count, kNone);
  for (Index b = 0; b < graph.branches.size(); ++b) {
    for (const Index v : graph.branches[b].nodes) {
      if (node_branch[v] == kNone) node_branch[v] = b;
    }
  }
  return node_branch;
}

/// Merges junctions joined by a branch whose chord is below the larger of their radii.
inline void cluster_junctions(const CurveSkeleton& skeleton, BranchGraph& graph) {
  DisjointSets sets(skeleton.node_count());
  for (const Branch& branch : graph.branches) {
    if (graph.node_kind[branch.first_node] != NodeKind::kJunction) continue;
    if (graph.node_kind[branch.last_node] != NodeKind::kJunction) continue;
    const double reach =
        std::max(skeleton.radius[branch.first_node], skeleton.radius[branch.last_node]);
    if (branch.chord < reach) sets.join(branch.first_node, branch.last_node);
  }
  graph.junction_cluster.assign(skeleton.node_count(), kNone);
  std::vector<Index> cluster_of_root(skeleton.node_count(), kNone);
  for (const Branch& branch : graph.branches) {  // in the order of the branches: stable numbers
    for (const Index v : {branch.first_node, branch.last_node}) {
      if (graph.node_kind[v] != NodeKind::kJunction) continue;
      Index& cluster = cluster_of_root[sets.find(v)];
      if (cluster == kNone) cluster = graph.junction_clusters++;
      graph.junction_cluster[v] = cluster;
    }
  }
}

}  // namespace branching

/// Cuts the skeleton at its junctions into branches and measures each. `tubular`, `area_share` and
/// `tubular_share` stay unset: see `with_surface_measures`.
/// The root of a component is its widest junction (by MGF); without a junction its widest tip, and
/// of a lone loop its widest node. Parents follow the shortest way to the root.
/// Cost: O(n log n) in the nodes, plus the loops times the branches on one of them.
inline BranchGraph build_branches(const CurveSkeleton& skeleton) {
  const Rows<Index> node_edges = edges_of_nodes(skeleton);
  const std::vector<Index> rank = branching::canonical_node_ranks(skeleton);
  const branching::Components components = branching::connected_components(skeleton, rank);
  std::vector<branching::Chain> chains = branching::trace_chains(skeleton, node_edges, rank);
  branching::sort_chains(skeleton, components, chains);
  const branching::BranchTree tree =
      branching::span_branches(skeleton, node_edges, components, rank, chains);

  BranchGraph graph;
  graph.components = components.count;
  graph.node_kind = branching::kinds_of_nodes(node_edges);
  graph.edge_branch.assign(skeleton.edge_count(), kNone);
  for (Index b = 0; b < chains.size(); ++b) {
    Branch branch;
    branch.nodes = std::move(chains[b].nodes);
    branch.edges = std::move(chains[b].edges);
    branch.first_node = branch.nodes.front();
    branch.last_node = branch.nodes.back();
    branch.component = components.of_node[branch.first_node];
    branch.parent = tree.parent[b];
    branch.cycle = tree.cycle[b];
    branch.on_cycle = branch.cycle != kNone;
    branch.closes_cycle = tree.closes_cycle[b] != 0;
    if (branch.closes_cycle) ++graph.cycles;
    branching::measure_branch(skeleton, branch);
    for (const Index e : branch.edges) graph.edge_branch[e] = b;
    graph.branches.push_back(std::move(branch));
  }
  graph.node_branch = branching::branches_of_nodes(graph, skeleton.node_count());
  branching::cluster_junctions(skeleton, graph);
  return graph;
}

}  // namespace mgf
