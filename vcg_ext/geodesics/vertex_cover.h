// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertices to search from, so that each pair has one of its ends among them.
#pragma once

#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/pair_geodesics.h"

namespace mgf {

/// A set of searches that together serve all pairs asked.
struct SearchPlan {
  std::vector<Index> starts;  ///< distinct vertices, in the order they were chosen
  Rows<Index> pairs;          ///< one row per start: the pairs that its search serves
};

/// Greedy cover by weight: again and again the vertex whose pairs not yet served weigh most. Pairs
/// of weight 0 are left out. O(n log n); ties go to the smaller vertex.
inline SearchPlan plan_searches(const std::vector<VertexPair>& pairs,
                                const std::vector<double>& weight, std::size_t vertex_count) {
  std::vector<Index> first_end(pairs.size()), second_end(pairs.size());
  std::vector<double> open(vertex_count, 0.0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool asked = weight[i] > 0.0;
    first_end[i] = asked ? pairs[i].a : kNone;
    second_end[i] = asked ? pairs[i].b : kNone;
    if (!asked) continue;
    open[pairs[i].a] += weight[i];
    open[pairs[i].b] += weight[i];
  }
  const Rows<Index> of_first = group_by_key(first_end, vertex_count);
  const Rows<Index> of_second = group_by_key(second_end, vertex_count);

  struct Entry {
    double weight;
    Index vertex;
    bool operator<(const Entry& o) const {
      return weight < o.weight || (weight == o.weight && vertex > o.vertex);
    }
  };
  std::priority_queue<Entry> queue;
  for (Index v = 0; v < vertex_count; ++v) {
    if (open[v] > 0.0) queue.push({open[v], v});
  }
  SearchPlan plan;
  std::vector<char> served(pairs.size(), 0);
  while (!queue.empty()) {
    const Entry top = queue.top();
    queue.pop();
    // Weights only fall, so an entry that is out of date comes back where it belongs.
    if (open[top.vertex] < top.weight) {
      if (open[top.vertex] > 0.0) queue.push({open[top.vertex], top.vertex});
      continue;
    }
    bool chosen = false;
    for (const Rows<Index>* rows : {&of_first, &of_second}) {
      for (const Index pair : (*rows)[top.vertex]) {
        if (served[pair] != 0) continue;
        served[pair] = 1;
        chosen = true;
        plan.pairs.items.push_back(pair);
        const Index other = pairs[pair].a == top.vertex ? pairs[pair].b : pairs[pair].a;
        open[other] -= weight[pair];
      }
    }
    open[top.vertex] = 0.0;
    if (!chosen) continue;
    plan.starts.push_back(top.vertex);
    plan.pairs.close_row();
  }
  return plan;
}

}  // namespace mgf
