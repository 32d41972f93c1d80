// SPDX-License-Identifier: GPL-3.0-or-later
// Every theta from one erosion: when each edge of the eroded complex appears (paper, section 5.5).
//
// The skeleton at a smaller theta is what is left of the skeleton at the loosest one when its leaf
// edges, as far as they carry no mark at that theta, are collapsed. Collapsing leaves is confluent
// and the marks are nested, so SK^θ1 ⊆ SK^θ2 holds exactly for θ1 < θ2. The widest vertex of a tree
// always stays: where no mark is left, that is what the erosion itself would leave of the shape.
#pragma once

#include <algorithm>
#include <queue>
#include <tuple>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/erosion.h"
#include "vcg_ext/skeleton/erosion_order.h"

namespace mgf {

/// When the cells of an eroded complex appear.
struct ThetaBirths {
  std::vector<double> edge;        ///< one per Voronoi edge; meaningful where the edge is alive
  std::vector<Index> last_vertex;  ///< per tree component, the vertex left when every edge is gone:
                                   ///< its widest
};

namespace detail {

/// Of each component of the live vertices and edges that has no loop, the vertex that comes last in
/// the order, ascending.
inline std::vector<Index> widest_vertices_of_trees(const MedialComplex& complex,
                                                   const ErodedComplex& eroded,
                                                   const ErosionOrder& order) {
  DisjointSets components(complex.vertex_count());
  std::vector<Index> on_loop;
  for (Index e = 0; e < complex.edge_count(); ++e) {
    const auto& ends = complex.edge_vertices[e];
    if (eroded.edge_alive[e] != 0 && !components.join(ends[0], ends[1])) on_loop.push_back(ends[0]);
  }
  std::vector<char> has_loop(complex.vertex_count(), 0);
  for (const Index v : on_loop) has_loop[components.find(v)] = 1;

  std::vector<Index> widest(complex.vertex_count(), kNone);  // by the component's representative
  for (Index v = 0; v < complex.vertex_count(); ++v) {
    const Index component = components.find(v);
    if (eroded.vertex_alive[v] == 0 || has_loop[component] != 0) continue;
    Index& best = widest[component];
    if (best == kNone || order.vertex_rank[v] > order.vertex_rank[best]) best = v;
  }
  widest.erase(std::remove(widest.begin(), widest.end(), kNone), widest.end());
  std::sort(widest.begin(), widest.end());
  return widest;
}

}  // namespace detail

/// Peels the live edges leaf by leaf, the one that can go at the largest theta first, but never a
/// tree's last vertex. An edge is in the skeleton at every theta above its birth. n log n in the
/// live edges.
inline ThetaBirths compute_theta_births(const MedialComplex& complex, const ErodedComplex& eroded,
                                        const ErosionOrder& order, double loosest_theta) {
  ThetaBirths births;
  births.edge.assign(complex.edge_count(), kAlwaysThere);
  births.last_vertex = detail::widest_vertices_of_trees(complex, eroded, order);
  std::vector<char> stays(complex.vertex_count(), 0);
  for (const Index v : births.last_vertex) stays[v] = 1;
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
    if (degree[v] != 1 || stays[v] != 0) return;
    for (const Index e : complex.vertex_edges[v]) {
      if (alive[e] == 0) continue;
      const Index low_first = to_index(complex.vertex_count()) - 1 - order.vertex_rank[v];
      if (held[e] == 0) leaves.emplace(eroded.mark_score[e], low_first, v, e);
    }
  };
  for (Index v = 0; v < complex.vertex_count(); ++v) offer(v);

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
    --degree[other];
    offer(other);
  }
  return births;
}

}  // namespace mgf
