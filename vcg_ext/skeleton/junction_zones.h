// SPDX-License-Identifier: GPL-3.0-or-later
// Where a limb ends and the trunk begins: which branch owns the surface round each skeleton edge.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf {
namespace junction_zones {

/// A zone gives at most this share of a branch away at an end with a tip at the other, and at most
/// that share where both ends are junctions, so that every limb keeps a part of its own.
inline constexpr double kLeafShare = 1.0 / 2;
inline constexpr double kInnerShare = 1.0 / 3;
/// The trunk takes the end of a branch only if it is this much wider than the branch is there; a
/// short link between junctions is the trunk only if it is this much wider than all that leave.
inline constexpr double kTrunkMargin = 1.25;

/// Local radius by the medial geodesic function: that of the tube with this MGF.
inline double rho(const CurveSkeleton& skeleton, Index node) {
  return skeleton.node_mgf[node] / kPi;
}

/// Whether a branch only links two junctions of one zone: it is no longer than their radius.
inline bool is_link(const CurveSkeleton& skeleton, const BranchGraph& graph, const Branch& branch) {
  return branch.first_node != branch.last_node &&
         graph.node_kind[branch.first_node] == NodeKind::kJunction &&
         graph.node_kind[branch.last_node] == NodeKind::kJunction &&
         branch.length <
             std::max(rho(skeleton, branch.first_node), rho(skeleton, branch.last_node));
}

/// The edges of a branch, counted from its last or first node, that lie in the zone of the junction
/// there: within its radius.
inline std::size_t edges_in_zone(const CurveSkeleton& skeleton, const BranchGraph& graph,
                                 const Branch& branch, bool from_last) {
  const Index junction = from_last ? branch.last_node : branch.first_node;
  const Index other = from_last ? branch.first_node : branch.last_node;
  const double share = graph.node_kind[other] == NodeKind::kTip ? kLeafShare : kInnerShare;
  const std::size_t n = branch.edges.size();
  double walked = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Index node = branch.nodes[from_last ? n - 1 - i : i + 1];
    walked += skeleton_edge_length(skeleton, branch.edges[from_last ? n - 1 - i : i]);
    const double distance = (skeleton.position[node] - skeleton.position[junction]).norm();
    if (distance > rho(skeleton, junction) || walked > share * branch.length) return i;
  }
  return n;
}

/// A branch's way out of a zone.
struct Exit {
  Index branch = 0;
  Index zone = 0;
  bool from_last = false;
  std::size_t edges = 0;  ///< how many of its edges are in the zone
  double width = 0.0;     ///< MGF of the first edge outside

  /// Edge number i of the branch, counted from the junction.
  Index edge(const std::vector<Index>& edges_of_branch, std::size_t i) const {
    return edges_of_branch[from_last ? edges_of_branch.size() - 1 - i : i];
  }
};

/// The widest branch of a zone so far, and how wide it is (MGF).
struct Trunk {
  Index branch = kNone;
  double width = -1.0;
};

/// Zones as sets of junctions, and the branches that lie within one.
struct Zones {
  DisjointSets junctions;
  std::vector<char> is_link;  ///< one per branch
};

inline Zones find_zones(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  Zones zones{DisjointSets(skeleton.node_count()), {}};
  for (const Branch& branch : graph.branches) {
    zones.is_link.push_back(is_link(skeleton, graph, branch) ? 1 : 0);
    if (zones.is_link.back()) zones.junctions.join(branch.first_node, branch.last_node);
  }
  return zones;
}

/// Every way from a zone into a branch that isn't a link.
inline std::vector<Exit> find_exits(const CurveSkeleton& skeleton, const BranchGraph& graph,
                                    Zones& zones) {
  std::vector<Exit> exits;
  for (Index b = 0; b < graph.branches.size(); ++b) {
    const Branch& branch = graph.branches[b];
    for (const bool from_last : {false, true}) {
      const Index junction = from_last ? branch.last_node : branch.first_node;
      if (zones.is_link[b] || graph.node_kind[junction] != NodeKind::kJunction) continue;
      Exit exit;
      exit.branch = b;
      exit.zone = zones.junctions.find(junction);
      exit.from_last = from_last;
      exit.edges = edges_in_zone(skeleton, graph, branch, from_last);
      const std::size_t first_out = std::min(exit.edges, branch.edges.size() - 1);
      exit.width = skeleton.mgf[exit.edge(branch.edges, first_out)];
      exits.push_back(exit);
    }
  }
  return exits;
}

/// The trunk of each zone, by the zone's number.
inline std::vector<Trunk> find_trunks(const CurveSkeleton& skeleton, const BranchGraph& graph,
                                      const std::vector<Exit>& exits, Zones& zones) {
  std::vector<Trunk> trunks(skeleton.node_count());
  for (const Exit& exit : exits) {
    Trunk& trunk = trunks[exit.zone];
    if (exit.width > trunk.width) trunk = {exit.branch, exit.width};
  }
  for (Index b = 0; b < graph.branches.size(); ++b) {
    if (!zones.is_link[b]) continue;
    Trunk& trunk = trunks[zones.junctions.find(graph.branches[b].first_node)];
    double width = 0.0;
    for (const Index e : graph.branches[b].edges) width = std::max(width, skeleton.mgf[e]);
    if (width > kTrunkMargin * trunk.width) trunk = {b, width};
  }
  return trunks;
}

}  // namespace junction_zones

/// One entry per skeleton edge: the branch that owns the surface round it. That is its own branch,
/// except near a junction, where it may be the trunk: of the branches that meet there, the one that
/// is widest where it leaves the junction's radius rho = MGF / pi. The trunk takes what lies within
/// that radius of branches clearly thinner than itself, so an arm ends at the shoulder and not in
/// the middle of the chest. Junctions linked by a branch shorter than their radius share a trunk,
/// which owns the link. Linear time.
inline std::vector<Index> owning_branches(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  using junction_zones::Exit;
  junction_zones::Zones zones = junction_zones::find_zones(skeleton, graph);
  const std::vector<Exit> exits = junction_zones::find_exits(skeleton, graph, zones);
  const std::vector<junction_zones::Trunk> trunks =
      junction_zones::find_trunks(skeleton, graph, exits, zones);

  std::vector<Index> owner = graph.edge_branch;
  for (const Exit& exit : exits) {
    const junction_zones::Trunk& trunk = trunks[exit.zone];
    if (trunk.width <= junction_zones::kTrunkMargin * exit.width) continue;
    for (std::size_t i = 0; i < exit.edges; ++i) {
      owner[exit.edge(graph.branches[exit.branch].edges, i)] = trunk.branch;
    }
  }
  for (Index b = 0; b < graph.branches.size(); ++b) {
    if (!zones.is_link[b]) continue;
    const Branch& link = graph.branches[b];
    for (const Index e : link.edges)
      owner[e] = trunks[zones.junctions.find(link.first_node)].branch;
  }
  return owner;
}

}  // namespace mgf
