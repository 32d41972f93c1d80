// SPDX-License-Identifier: GPL-3.0-or-later
// The spanning tree of a skeleton's branches: parents, the branches that close a loop, and which
// branches share loops.
#pragma once

#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branch_chains.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf::branching {

/// One entry per chain.
struct BranchTree {
  std::vector<Index> parent;       ///< chain on the way to the root, or kNone
  std::vector<char> closes_cycle;  ///< 1 if the chain isn't in the tree
  std::vector<Index> cycle;        ///< block of loops that the chain is part of, or kNone
};

/// The root of each component: the widest junction, else the widest tip, else the widest node.
inline std::vector<Index> component_roots(const Rows<Index>& node_edges,
                                          const Components& components,
                                          const std::vector<Index>& rank) {
  const auto preference = [&](Index v) {
    const std::size_t degree = node_edges[v].size();
    return std::make_pair(degree >= 3 ? 0 : degree == 1 ? 1 : 2, rank[v]);
  };
  std::vector<Index> roots(components.count, kNone);
  for (Index v = 0; v < node_edges.size(); ++v) {
    Index& root = roots[components.of_node[v]];
    if (root == kNone || preference(v) < preference(root)) root = v;
  }
  return roots;
}

/// Shortest ways from the roots over the chains' end nodes.
struct RootDistances {
  std::vector<double> distance;  ///< one per node; infinite except at chain ends
  std::vector<Index> arriving;   ///< one per node: the chain by which it is reached, or kNone
};

inline RootDistances distances_from_roots(const CurveSkeleton& skeleton,
                                          const std::vector<Index>& roots,
                                          const std::vector<Index>& rank,
                                          const std::vector<Chain>& chains) {
  const std::size_t n = skeleton.node_count();
  std::vector<Index> end_node;
  std::vector<double> length;
  for (const Chain& chain : chains) {
    end_node.push_back(chain.nodes.front());
    end_node.push_back(chain.nodes.back());
    length.push_back(chain_length(skeleton, chain));
  }
  const Rows<Index> ends_at = group_by_key(end_node, n);

  RootDistances result;
  result.distance.assign(n, std::numeric_limits<double>::infinity());
  result.arriving.assign(n, kNone);
  using Entry = std::tuple<double, Index, Index>;  // distance, rank, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index root : roots) {
    result.distance[root] = 0.0;
    queue.emplace(0.0, rank[root], root);
  }
  while (!queue.empty()) {
    const auto [distance, node_rank, node] = queue.top();
    queue.pop();
    if (distance > result.distance[node]) continue;
    for (const Index end : ends_at[node]) {
      const Index chain = end / 2;
      const Index other = end_node[end ^ 1U];
      const double reached = distance + length[chain];
      // Zero-length chains must not make two nodes each other's parent, so ties never re-parent.
      if (reached >= result.distance[other]) continue;
      result.distance[other] = reached;
      result.arriving[other] = chain;
      queue.emplace(reached, rank[other], other);
    }
  }
  return result;
}

/// Unites the chains on the loop that `closing` makes with the tree: up from its ends to where the
/// two ways meet.
inline void unite_loop(const std::vector<Chain>& chains, const std::vector<Index>& arriving,
                       Index closing, std::vector<Index>& seen_by, DisjointSets& sets) {
  const auto upward = [&](Index node) { return chains[arriving[node]].nodes.front(); };
  const Index first = chains[closing].nodes.front();
  const Index last = chains[closing].nodes.back();
  for (Index v = first;; v = upward(v)) {
    seen_by[v] = closing;
    if (arriving[v] == kNone) break;
  }
  Index meeting = last;
  for (; seen_by[meeting] != closing; meeting = upward(meeting)) {
    sets.join(closing, arriving[meeting]);
  }
  for (Index v = first; v != meeting; v = upward(v)) sets.join(closing, arriving[v]);
}

/// Numbers the blocks of loops, in the order of their first chain. The loops of all closing chains
/// generate the blocks (classes of edges that share simple cycles), whatever the spanning tree.
inline std::vector<Index> cycle_blocks(const std::vector<Chain>& chains,
                                       const std::vector<Index>& arriving,
                                       const std::vector<char>& closes_cycle) {
  DisjointSets sets(chains.size());
  std::vector<Index> seen_by(arriving.size(), kNone);
  std::vector<char> in_loop(chains.size(), 0);
  for (Index c = 0; c < chains.size(); ++c) {
    if (closes_cycle[c]) unite_loop(chains, arriving, c, seen_by, sets);
  }
  for (Index c = 0; c < chains.size(); ++c) {
    if (closes_cycle[c]) in_loop[sets.find(c)] = 1;
  }
  std::vector<Index> number(chains.size(), kNone);
  std::vector<Index> block(chains.size(), kNone);
  Index count = 0;
  for (Index c = 0; c < chains.size(); ++c) {
    const Index root = sets.find(c);
    if (!in_loop[root]) continue;
    if (number[root] == kNone) number[root] = count++;
    block[c] = number[root];
  }
  return block;
}

/// Spans each component by shortest ways from its root and directs every chain away from it.
inline BranchTree span_branches(const CurveSkeleton& skeleton, const Rows<Index>& node_edges,
                                const Components& components, const std::vector<Index>& rank,
                                std::vector<Chain>& chains) {
  const std::vector<Index> roots = component_roots(node_edges, components, rank);
  const RootDistances ways = distances_from_roots(skeleton, roots, rank, chains);

  BranchTree tree;
  tree.closes_cycle.assign(chains.size(), 1);
  for (const Index chain : ways.arriving) {
    if (chain != kNone) tree.closes_cycle[chain] = 0;
  }
  for (Index c = 0; c < chains.size(); ++c) {
    const Index first = chains[c].nodes.front();
    const Index last = chains[c].nodes.back();
    const auto order = [&](Index v) { return std::make_pair(ways.distance[v], rank[v]); };
    const bool backwards =
        tree.closes_cycle[c] ? order(last) < order(first) : ways.arriving[first] == c;
    if (backwards) reverse_chain(chains[c]);
    tree.parent.push_back(ways.arriving[chains[c].nodes.front()]);
  }
  tree.cycle = cycle_blocks(chains, ways.arriving, tree.closes_cycle);
  return tree;
}

}  // namespace mgf::branching
