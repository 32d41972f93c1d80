// SPDX-License-Identifier: GPL-3.0-or-later
// Less detail from a computed skeleton, without recomputing: a smaller theta, fewer leaf branches.
#pragma once

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/contact_spacing.h"
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

/// What hangs on a junction ends at least this many edges of the surface away from it, or the
/// surface's sampling doesn't tell it from noise.
inline constexpr double kResolvedEdges = 2.7;

/// Removes what hangs on a junction by one edge and hardly leaves the junction's ball.
class TwigPruner {
 public:
  TwigPruner(const CurveSkeleton& skeleton, const std::vector<double>& contact_spacing)
      : skeleton_(skeleton),
        spacing_(spacing_at_nodes(skeleton, contact_spacing)),
        edges_(edges_of_nodes(skeleton)),
        keep_node_(skeleton.node_count(), 1),
        keep_edge_(skeleton.edge_count(), 1),
        degree_(skeleton.node_count()),
        last_visit_(skeleton.node_count(), 0) {
    for (Index n = 0; n < skeleton.node_count(); ++n) degree_[n] = to_index(edges_[n].size());
  }

  CurveSkeleton prune(double least_significance) {
    while (remove_twigs(least_significance)) {
    }
    return sub_skeleton(skeleton_, keep_node_, keep_edge_);
  }

 private:
  struct Twig {
    double significance;
    Index junction;
    Index edge;  ///< by which it hangs on the junction
    bool operator<(const Twig& other) const {
      return std::tie(significance, junction, edge) <
             std::tie(other.significance, other.junction, other.edge);
    }
  };

  /// Radius of the tube with the node's MGF, or of the node's ball if that is larger.
  double tube_radius(Index node) const {
    return std::max(skeleton_.node_mgf[node] / kPi, skeleton_.radius[node]);
  }

  /// How far the tube at `node` sticks out of that at `junction`, in radii of the latter; minus
  /// infinity where it ends too few edges of the surface away to be told from noise.
  double reach(Index junction, Index node) const {
    const double radius = tube_radius(junction);
    const double end =
        (skeleton_.position[node] - skeleton_.position[junction]).norm() + tube_radius(node);
    const double edge_length = std::max(spacing_[junction], spacing_[node]);
    if (end < kResolvedEdges * edge_length) return -std::numeric_limits<double>::infinity();
    return radius > 0.0 ? (end - radius) / radius : std::numeric_limits<double>::infinity();
  }

  /// The furthest reach of what hangs on a junction by `edge`, whose edges it leaves in `twig_`;
  /// infinite as soon as it is seen to be `enough`, or a loop.
  double significance(Index junction, Index edge, double enough) {
    constexpr double kStays = std::numeric_limits<double>::infinity();
    double furthest = -kStays;
    twig_.assign(1, edge);
    front_.assign(1, {other_end(skeleton_, edge, junction), edge});
    last_visit_[junction] = ++visit_;
    while (!front_.empty()) {
      const auto [node, arriving] = front_.back();
      front_.pop_back();
      if (last_visit_[node] == visit_) return kStays;
      last_visit_[node] = visit_;
      furthest = std::max(furthest, reach(junction, node));
      if (furthest >= enough) return kStays;
      for (const Index e : edges_[node]) {
        if (e == arriving || keep_edge_[e] == 0) continue;
        front_.emplace_back(other_end(skeleton_, e, node), e);
        twig_.push_back(e);
      }
    }
    return furthest;
  }

  /// Removes twigs, the least significant first, as long as their junctions are junctions. Returns
  /// whether there was one: what is left may then hang on another junction.
  bool remove_twigs(double least_significance) {
    std::vector<Twig> twigs;
    for (Index junction = 0; junction < skeleton_.node_count(); ++junction) {
      if (degree_[junction] < 3) continue;
      for (const Index edge : edges_[junction]) {
        if (keep_edge_[edge] == 0) continue;
        const double significant = significance(junction, edge, least_significance);
        if (significant < least_significance) twigs.push_back({significant, junction, edge});
      }
    }
    std::sort(twigs.begin(), twigs.end());
    bool removed = false;
    for (const Twig& twig : twigs) {
      if (keep_edge_[twig.edge] == 0 || degree_[twig.junction] < 3) continue;
      significance(twig.junction, twig.edge, least_significance);  // for what is left of it
      remove(twig.junction);
      removed = true;
    }
    return removed;
  }

  /// Removes the edges of `twig_` and all their nodes but the junction.
  void remove(Index junction) {
    for (const Index e : twig_) {
      keep_edge_[e] = 0;
      for (const Index node : skeleton_.edge[e]) {
        --degree_[node];
        if (node != junction) keep_node_[node] = 0;
      }
    }
  }

  const CurveSkeleton& skeleton_;
  std::vector<double> spacing_;  ///< of the surface, one per node
  Rows<Index> edges_;
  std::vector<char> keep_node_;
  std::vector<char> keep_edge_;
  std::vector<Index> degree_;
  std::vector<Index> last_visit_;
  Index visit_ = 0;
  std::vector<Index> twig_;
  std::vector<std::pair<Index, Index>> front_;  ///< nodes to visit, with the edge they come from
};

}  // namespace detail

/// Drops what hangs on a junction j by one edge, a leaf branch or a tree of them, and sticks out of
/// the tube there by less than `least_significance` times its radius ρ(j): for all of its nodes x
/// (|x − j| + ρ(x) − ρ(j)) / ρ(j) is less, where ρ is the larger of MGF / π and the radius of the
/// node's ball. So it has no unit. Nodes count only where |x − j| + ρ(x) is at least 2.7 edges of
/// the surface at j and x: nearer, noise of the samples makes twigs as large. `contact_spacing` has
/// the length of edges at each contact. The least significant goes first; two branches left at a
/// junction become one, and what is left is judged anew. Loops, and a path between two tips, stay.
/// 0 drops nothing. Each junction looks at the nodes within its reach.
inline CurveSkeleton prune_leaf_branches(const CurveSkeleton& skeleton,
                                         const std::vector<double>& contact_spacing,
                                         double least_significance) {
  if (least_significance <= 0.0) return skeleton;
  return detail::TwigPruner(skeleton, contact_spacing).prune(least_significance);
}

}  // namespace mgf
