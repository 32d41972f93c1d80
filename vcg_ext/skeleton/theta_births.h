// SPDX-License-Identifier: GPL-3.0-or-later
// Every theta from one erosion: when each edge of the eroded complex appears (paper, section 5.5).
//
// The skeleton at a smaller theta is what is left of the skeleton at the loosest one when its leaf
// edges, as far as they carry no mark at that theta, are collapsed. Collapsing leaves is confluent
// and the marks are nested, so SK^θ1 ⊆ SK^θ2 holds exactly for θ1 < θ2.
#pragma once

#include <algorithm>
#include <queue>
#include <tuple>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/erosion.h"
#include "vcg_ext/skeleton/erosion_order.h"

namespace mgf {

/// When the cells of an eroded complex appear.
struct ThetaBirths {
  std::vector<double> edge;        ///< one per Voronoi edge; meaningful where the edge is alive
  std::vector<Index> last_vertex;  ///< per tree component, the vertex left when every edge is gone
};

/// Peels the live edges leaf by leaf, the one that can go at the largest theta first. An edge is in
/// the skeleton at every theta above its birth. n log n in the live edges.
inline ThetaBirths compute_theta_births(const MedialComplex& complex, const ErodedComplex& eroded,
                                        const ErosionOrder& order, double loosest_theta) {
  ThetaBirths births;
  births.edge.assign(complex.edge_count(), kAlwaysThere);
  std::vector<Index> degree(complex.vertex_count(), 0);
  std::vector<char> alive = eroded.edge_alive;
  std::vector<char> held(complex.edge_count(), 0);  // bounds a facet that could not be eroded
  for (Index e = 0; e < complex.edge_count(); ++e) {
    if (alive[e] == 0) continue;
    for (const Index v : complex.edge_vertices[e]) ++degree[v];
    for (const Index facet : complex.edge_facets[e]) {
      if (facet != kNone && eroded.facet_alive[facet] != 0) held[e] = 1;
    }
  }

  // (theta below which the leaf edge goes, order among equals, leaf, edge); largest first.
  using Leaf = std::tuple<double, Index, Index, Index>;
  std::priority_queue<Leaf> leaves;
  const auto offer = [&](Index v) {
    if (degree[v] != 1) return;
    for (const Index e : complex.vertex_edges[v]) {
      if (alive[e] == 0) continue;
      const Index low_first = to_index(complex.vertex_count()) - 1 - order.vertex_rank[v];
      if (held[e] == 0) leaves.emplace(eroded.mark_score[e], low_first, v, e);
    }
  };
  for (Index v = 0; v < complex.vertex_count(); ++v) {
    offer(v);
    if (degree[v] == 0 && eroded.vertex_alive[v] != 0) births.last_vertex.push_back(v);
  }

  double theta = loosest_theta;
  while (!leaves.empty()) {
    const auto [score, rank, leaf, edge] = leaves.top();
    leaves.pop();
    if (alive[edge] == 0) continue;
    theta = std::min(theta, score);
    births.edge[edge] = theta;
    alive[edge] = 0;
    const auto& ends = complex.edge_vertices[edge];
    const Index other = ends[0] == leaf ? ends[1] : ends[0];
    --degree[leaf];
    if (--degree[other] == 0) births.last_vertex.push_back(other);
    offer(other);
  }
  return births;
}

}  // namespace mgf
