// SPDX-License-Identifier: GPL-3.0-or-later
// Less detail from a computed skeleton, without recomputing: a smaller theta, fewer leaf branches.
#pragma once

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/graph_edits.h"

namespace mgf {

/// The skeleton at `theta`: the edges born below it with their ends, and, for each tree component
/// that has no edge left, its last node. Linear time.
inline CurveSkeleton skeleton_at_theta(const CurveSkeleton& full,
                                       const std::vector<Index>& last_nodes, double theta) {
  std::vector<char> keep_node(full.node_count(), 0);
  std::vector<char> keep_edge(full.edge_count(), 0);
  for (Index e = 0; e < full.edge_count(); ++e) {
    if (full.theta_birth[e] >= theta) continue;
    keep_edge[e] = 1;
    for (const Index node : full.edge[e]) keep_node[node] = 1;
  }
  // A tree's edges vanish towards its last node, so that node lies in whatever is left of it.
  for (const Index node : last_nodes) keep_node[node] = 1;
  return sub_skeleton(full, keep_node, keep_edge);
}

namespace detail {

/// Removes leaf branches in the order of their significance.
class LeafPruner {
 public:
  explicit LeafPruner(const CurveSkeleton& skeleton)
      : skeleton_(skeleton),
        edges_(edges_of_nodes(skeleton)),
        keep_node_(skeleton.node_count(), 1),
        keep_edge_(skeleton.edge_count(), 1),
        degree_(skeleton.node_count()) {
    for (Index n = 0; n < skeleton.node_count(); ++n) degree_[n] = to_index(edges_[n].size());
  }

  CurveSkeleton prune(double least_significance) {
    for (Index n = 0; n < skeleton_.node_count(); ++n) {
      if (degree_[n] == 1) offer(n);
    }
    while (!queue_.empty()) {
      const auto [significance, tip, junction] = queue_.top();
      if (significance >= least_significance) break;
      queue_.pop();
      // The branch has grown since it was offered if its junction is one no longer.
      if (degree_[junction] < 3) {
        offer(tip);
      } else {
        remove_branch(tip);
      }
    }
    return sub_skeleton(skeleton_, keep_node_, keep_edge_);
  }

 private:
  using Entry = std::tuple<double, Index, Index>;  // significance, tip, junction

  /// The live edge at `node` other than `from`; every node inside a branch has one.
  Index onward(Index node, Index from) const {
    for (const Index e : edges_[node]) {
      if (e != from && keep_edge_[e] != 0) return e;
    }
    return kNone;
  }

  /// Follows the branch from a tip; kNone if it ends at another tip, so that nothing would be left.
  Index junction_of(Index tip, double& length) const {
    length = 0.0;
    Index node = tip;
    Index edge = kNone;
    do {
      edge = onward(node, edge);
      const Index next = other_end(skeleton_, edge, node);
      length += (skeleton_.position[next] - skeleton_.position[node]).norm();
      node = next;
    } while (degree_[node] == 2);
    return degree_[node] >= 3 ? node : kNone;
  }

  /// Radius of the tube whose MGF a node has: half its circumference over pi.
  double tube_radius(Index node) const { return skeleton_.node_mgf[node] / kPi; }

  void offer(Index tip) {
    double length = 0.0;
    const Index junction = junction_of(tip, length);
    if (junction == kNone) return;
    const double at_junction = tube_radius(junction);
    const double beyond = length + tube_radius(tip) - at_junction;
    const double significance =
        at_junction > 0.0 ? beyond / at_junction : std::numeric_limits<double>::infinity();
    queue_.emplace(significance, tip, junction);
  }

  void remove_branch(Index tip) {
    Index node = tip;
    while (degree_[node] == 1) {
      const Index edge = onward(node, kNone);
      keep_edge_[edge] = 0;
      keep_node_[node] = 0;
      node = other_end(skeleton_, edge, node);
      --degree_[node];
      if (degree_[node] >= 2) break;
    }
  }

  const CurveSkeleton& skeleton_;
  Rows<Index> edges_;
  std::vector<char> keep_node_;
  std::vector<char> keep_edge_;
  std::vector<Index> degree_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace detail

/// Drops leaf branches that stick out of their junction's tube by less than `least_significance`
/// times its radius, the least significant first; two branches left at a junction become one, which
/// is judged anew. Significance is (length + ρ(tip) − ρ(junction)) / ρ(junction) with ρ = MGF / π,
/// so it has no unit. Loops, and the branches of a skeleton without a junction, stay. 0 drops
/// nothing of positive significance. n log n.
inline CurveSkeleton prune_leaf_branches(const CurveSkeleton& skeleton, double least_significance) {
  if (least_significance <= 0.0) return skeleton;
  return detail::LeafPruner(skeleton).prune(least_significance);
}

}  // namespace mgf
