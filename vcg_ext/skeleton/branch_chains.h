// SPDX-License-Identifier: GPL-3.0-or-later
// A skeleton's edges as chains between tips and junctions, in an order and a direction that don't
// depend on how nodes and edges are numbered.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/graph_edits.h"

namespace mgf {

/// Length of skeleton edge `e`, mesh units.
inline double skeleton_edge_length(const CurveSkeleton& skeleton, Index e) {
  return (skeleton.position[skeleton.edge[e][0]] - skeleton.position[skeleton.edge[e][1]]).norm();
}

namespace branching {

/// A maximal path of edges through nodes of degree two; closed if it ends where it starts.
struct Chain {
  std::vector<Index> nodes;
  std::vector<Index> edges;
};

/// Which connected component each node is in: by falling length, then by best node rank.
struct Components {
  std::vector<Index> of_node;
  Index count = 0;
};

inline std::array<double, 3> coordinates(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

/// Position of each node in an order by measures alone: widest (MGF) first, then by place.
inline std::vector<Index> canonical_node_ranks(const CurveSkeleton& skeleton) {
  std::vector<Index> order(skeleton.node_count());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index v) {
    return std::make_tuple(-skeleton.node_mgf[v], coordinates(skeleton.position[v]), v);
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  std::vector<Index> rank(order.size());
  for (Index i = 0; i < order.size(); ++i) rank[order[i]] = i;
  return rank;
}

inline Components connected_components(const CurveSkeleton& skeleton,
                                       const std::vector<Index>& rank) {
  const std::size_t n = skeleton.node_count();
  DisjointSets sets(n);
  for (const std::array<Index, 2>& ends : skeleton.edge) sets.join(ends[0], ends[1]);

  std::vector<double> length(n, 0.0);
  std::vector<Index> best_rank(n, kNone);
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    length[sets.find(skeleton.edge[e][0])] += skeleton_edge_length(skeleton, e);
  }
  std::vector<Index> roots;
  for (Index v = 0; v < n; ++v) {
    const Index root = sets.find(v);
    if (root == v) roots.push_back(v);
    best_rank[root] = std::min(best_rank[root], rank[v]);
  }
  std::sort(roots.begin(), roots.end(), [&](Index a, Index b) {
    return std::make_pair(-length[a], best_rank[a]) < std::make_pair(-length[b], best_rank[b]);
  });
  std::vector<Index> number(n, kNone);
  Components components;
  for (const Index root : roots) number[root] = components.count++;
  components.of_node.resize(n);
  for (Index v = 0; v < n; ++v) components.of_node[v] = number[sets.find(v)];
  return components;
}

/// Follows the path from `start` along `edge` to the next tip or junction, or back to `start`.
inline Chain walk_chain(const CurveSkeleton& skeleton, const Rows<Index>& node_edges, Index start,
                        Index edge) {
  Chain chain;
  chain.nodes.push_back(start);
  Index node = start;
  for (;;) {
    node = other_end(skeleton, edge, node);
    chain.nodes.push_back(node);
    chain.edges.push_back(edge);
    const Row<Index> around = node_edges[node];
    if (node == start || around.size() != 2) return chain;
    edge = around[0] == edge ? around[1] : around[0];
  }
}

inline void reverse_chain(Chain& chain) {
  std::reverse(chain.nodes.begin(), chain.nodes.end());
  std::reverse(chain.edges.begin(), chain.edges.end());
}

/// Cuts a loop without junction at its node of best rank.
inline void rotate_to_best_node(const std::vector<Index>& rank, Chain& loop) {
  loop.nodes.pop_back();
  const auto best = std::min_element(loop.nodes.begin(), loop.nodes.end(),
                                     [&](Index a, Index b) { return rank[a] < rank[b]; });
  const auto offset = best - loop.nodes.begin();
  std::rotate(loop.nodes.begin(), best, loop.nodes.end());
  std::rotate(loop.edges.begin(), loop.edges.begin() + offset, loop.edges.end());
  loop.nodes.push_back(loop.nodes.front());
}

/// Directs a chain from its end of better rank; a closed one so that its second node has it.
inline void direct_by_rank(const std::vector<Index>& rank, Chain& chain) {
  const bool closed = chain.nodes.front() == chain.nodes.back();
  const std::size_t inset = closed ? 1 : 0;
  const Index front = rank[chain.nodes[inset]];
  const Index back = rank[chain.nodes[chain.nodes.size() - 1 - inset]];
  if (back < front) reverse_chain(chain);
}

/// All chains of the skeleton, each directed by rank; every edge is in exactly one.
inline std::vector<Chain> trace_chains(const CurveSkeleton& skeleton, const Rows<Index>& node_edges,
                                       const std::vector<Index>& rank) {
  std::vector<Chain> chains;
  std::vector<char> used(skeleton.edge_count(), 0);
  const auto take = [&](Index start, Index edge) -> Chain& {
    chains.push_back(walk_chain(skeleton, node_edges, start, edge));
    for (const Index e : chains.back().edges) used[e] = 1;
    return chains.back();
  };
  for (Index v = 0; v < skeleton.node_count(); ++v) {
    if (node_edges[v].size() == 2) continue;
    for (const Index e : node_edges[v]) {
      if (!used[e]) direct_by_rank(rank, take(v, e));
    }
  }
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    if (used[e]) continue;
    Chain& loop = take(skeleton.edge[e][0], e);
    rotate_to_best_node(rank, loop);
    direct_by_rank(rank, loop);
  }
  return chains;
}

inline double chain_length(const CurveSkeleton& skeleton, const Chain& chain) {
  double length = 0.0;
  for (const Index e : chain.edges) length += skeleton_edge_length(skeleton, e);
  return length;
}

/// Sorts by component, falling length, then the places of the middle node and of the ends.
inline void sort_chains(const CurveSkeleton& skeleton, const Components& components,
                        std::vector<Chain>& chains) {
  const auto place = [&](Index v) { return coordinates(skeleton.position[v]); };
  const auto key = [&](const Chain& chain) {
    return std::make_tuple(components.of_node[chain.nodes.front()], -chain_length(skeleton, chain),
                           place(chain.nodes[chain.nodes.size() / 2]), place(chain.nodes.front()),
                           place(chain.nodes.back()), chain.edges.front());
  };
  using Key = decltype(key(chains.front()));
  std::vector<std::pair<Key, Index>> order;
  for (Index i = 0; i < chains.size(); ++i) order.emplace_back(key(chains[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<Chain> sorted;
  sorted.reserve(chains.size());
  for (const auto& entry : order) sorted.push_back(std::move(chains[entry.second]));
  chains = std::move(sorted);
}

}  // namespace branching
}  // namespace mgf
