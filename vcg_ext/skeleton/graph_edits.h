// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a curve skeleton that keep its homotopy type, and the averages that follow from edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf {

/// The edges at each node, ascending.
inline Rows<Index> edges_of_nodes(const CurveSkeleton& skeleton) {
  Rows<Index> rows;
  std::vector<Index> degree(skeleton.node_count(), 0);
  for (const auto& ends : skeleton.edge) {
    for (const Index node : ends) ++degree[node];
  }
  rows.begin.assign(1, 0);
  for (const Index d : degree) rows.begin.push_back(rows.begin.back() + d);
  rows.items.resize(rows.begin.back());
  std::vector<Index> next(rows.begin.begin(), rows.begin.end() - 1);
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    for (const Index node : skeleton.edge[e]) rows.items[next[node]++] = e;
  }
  return rows;
}

/// The end of an edge that is not `node` (`node` itself for a loop at it).
inline Index other_end(const CurveSkeleton& skeleton, Index edge, Index node) {
  const auto& ends = skeleton.edge[edge];
  return ends[0] == node ? ends[1] : ends[0];
}

/// The part of a skeleton with the given nodes and edges, renumbered in order. Every end of a kept
/// edge must be kept. `new_number`, if given, takes the new number of each node, or kNone.
inline CurveSkeleton sub_skeleton(const CurveSkeleton& skeleton, const std::vector<char>& keep_node,
                                  const std::vector<char>& keep_edge,
                                  std::vector<Index>* new_number = nullptr) {
  CurveSkeleton part;
  std::vector<Index> number(skeleton.node_count(), kNone);
  for (Index n = 0; n < skeleton.node_count(); ++n) {
    if (keep_node[n] == 0) continue;
    number[n] = to_index(part.node_count());
    part.position.push_back(skeleton.position[n]);
    part.radius.push_back(skeleton.radius[n]);
    part.node_mgf.push_back(skeleton.node_mgf[n]);
    part.node_eccentricity.push_back(skeleton.node_eccentricity[n]);
  }
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    if (keep_edge[e] == 0) continue;
    part.edge.push_back({number[skeleton.edge[e][0]], number[skeleton.edge[e][1]]});
    part.mgf.push_back(skeleton.mgf[e]);
    part.girth.push_back(skeleton.girth[e]);
    part.circumference.push_back(skeleton.circumference[e]);
    part.eccentricity.push_back(skeleton.eccentricity[e]);
    part.theta_birth.push_back(skeleton.theta_birth[e]);
    part.voronoi_edge.push_back(skeleton.voronoi_edge[e]);
    part.contacts.push_back(skeleton.contacts[e]);
    part.outside.push_back(skeleton.outside[e]);
  }
  if (new_number != nullptr) *new_number = std::move(number);
  return part;
}

/// Contracts edges not longer than `length` (cospherical contacts give Voronoi edges of length
/// zero), except those that would close a loop. `new_number` as in `sub_skeleton`.
inline CurveSkeleton contract_short_edges(const CurveSkeleton& skeleton, double length,
                                          std::vector<Index>& new_number) {
  DisjointSets merged(skeleton.node_count());
  std::vector<char> keep_edge(skeleton.edge_count(), 1);
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    const auto [u, v] = skeleton.edge[e];
    const bool is_short = (skeleton.position[u] - skeleton.position[v]).norm() <= length;
    if (is_short && merged.join(u, v)) keep_edge[e] = 0;
  }
  CurveSkeleton joined = skeleton;
  std::vector<char> keep_node(skeleton.node_count(), 0);
  for (Index n = 0; n < skeleton.node_count(); ++n) {
    const Index set = merged.find(n);
    keep_node[set] = 1;
    joined.radius[set] = std::min(joined.radius[set], skeleton.radius[n]);
    joined.node_mgf[set] = std::max(joined.node_mgf[set], skeleton.node_mgf[n]);
  }
  for (auto& ends : joined.edge) ends = {merged.find(ends[0]), merged.find(ends[1])};
  CurveSkeleton result = sub_skeleton(joined, keep_node, keep_edge, &new_number);
  for (Index n = 0; n < skeleton.node_count(); ++n) new_number[n] = new_number[merged.find(n)];
  return result;
}

/// Gives edges whose eccentricity is undefined (collinear contacts) the mean of their defined
/// neighbours', in rounds outward; 1 where a component has none. Their circumference follows.
inline void fill_undefined_eccentricity(CurveSkeleton& skeleton) {
  const auto defined = [](double e) { return std::isfinite(e) && e > 0.0; };
  const Rows<Index> edges = edges_of_nodes(skeleton);
  std::vector<Index> undefined;
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    if (!defined(skeleton.eccentricity[e])) undefined.push_back(e);
  }
  std::vector<Index> open = undefined;
  while (!open.empty()) {
    const std::vector<double> before = skeleton.eccentricity;
    std::vector<Index> still_open;
    for (const Index e : open) {
      double sum = 0.0;
      int count = 0;
      for (const Index node : skeleton.edge[e]) {
        for (const Index neighbour : edges[node]) {
          if (!defined(before[neighbour])) continue;
          sum += before[neighbour];
          ++count;
        }
      }
      if (count > 0) {
        skeleton.eccentricity[e] = sum / count;
      } else {
        still_open.push_back(e);
      }
    }
    if (still_open.size() == open.size()) {
      for (const Index e : still_open) skeleton.eccentricity[e] = 1.0;
      still_open.clear();
    }
    open = std::move(still_open);
  }
  for (const Index e : undefined) {
    skeleton.circumference[e] = skeleton.girth[e] / skeleton.eccentricity[e];
  }
}

/// Sets each node's eccentricity to the mean over its edges, weighted by length.
inline void average_eccentricity(CurveSkeleton& skeleton) {
  std::vector<double> weight(skeleton.node_count(), 0.0);
  std::fill(skeleton.node_eccentricity.begin(), skeleton.node_eccentricity.end(), 0.0);
  for (std::size_t e = 0; e < skeleton.edge_count(); ++e) {
    const auto& ends = skeleton.edge[e];
    const double length = (skeleton.position[ends[0]] - skeleton.position[ends[1]]).norm();
    for (const Index node : ends) {
      skeleton.node_eccentricity[node] += length * skeleton.eccentricity[e];
      weight[node] += length;
    }
  }
  for (std::size_t n = 0; n < skeleton.node_count(); ++n) {
    if (weight[n] > 0.0) skeleton.node_eccentricity[n] /= weight[n];
  }
}

}  // namespace mgf
