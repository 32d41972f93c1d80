// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the erosion visits cells: by increasing MGF, ties broken by all that is known
// of a cell (paper, section 5.4; the paper's key, the largest incident f alone, is full of exact
// ties, and then the result depends on the numbering of the mesh).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf {

/// Positions of the Voronoi edges and vertices in one common order, each number used once.
struct ErosionOrder {
  std::vector<Index> edge_rank;
  std::vector<Index> vertex_rank;
  std::vector<Index> cell_at;  ///< by rank: an edge e as e, a vertex v as edge_count + v
};

namespace detail {

/// f of the facets as the order sees it: those at a displaced vertex go first.
inline std::vector<double> erosion_priority(const MedialComplex& complex,
                                            const std::vector<double>& mgf) {
  constexpr double kFirst = 1e-6;
  std::vector<double> priority = mgf;
  for (std::size_t facet = 0; facet < priority.size(); ++facet) {
    const Row<Index> vertices = complex.facet_vertices[facet];
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](Index v) { return complex.displaced[v] != 0; })) {
      priority[facet] *= kFirst;
    }
  }
  return priority;
}

/// Orders cells by their keys: the f of a cell's facets, descending, filled up with nothing; an
/// edge before a vertex; a size; the number. The key of an edge without facets (a tube as thin as
/// one triangle) starts with the longest side of its dual triangle.
///
/// Only the facets are sorted. Taking them from the largest f down and noting each at its cells
/// gives all keys in order, and the cells grouped by their first entry; what is left to sort is
/// each small group.
class CellSorter {
 public:
  /// `points` are numbered as the contacts.
  CellSorter(const MedialComplex& complex, const std::vector<Vec3>& points)
      : complex_(complex),
        points_(points),
        edge_levels_(complex.edge_count(), EdgeLevels{}),
        vertex_levels_(complex.vertex_count(), VertexLevels{}) {}

  /// All cells, descending; `mgf` has one entry per facet.
  std::vector<Index> descending_cells(const std::vector<double>& mgf, unsigned threads) {
    group_cells(erosion_priority(complex_, mgf));
    constexpr std::size_t kChunk = 256;
    parallel_for(groups_.size(), threads, kChunk, [&](std::size_t group, unsigned) {
      const auto first = groups_.items.begin();
      std::sort(first + groups_.begin[group], first + groups_.begin[group + 1],
                [&](Index p, Index q) { return precedes(q, p); });
    });
    return std::move(groups_.items);
  }

 private:
  // Levels number the values of f from 1 up; 0 stands for no further facet. Each list descends.
  using EdgeLevels = std::array<Index, 3>;
  using VertexLevels = std::array<Index, 6>;  // a tetrahedron has six edges

  Index edge_count() const { return to_index(complex_.edge_count()); }

  /// Longest side of an edge's dual triangle.
  double longest_side(Index edge) const {
    const std::array<double, 3> sides = dual_sides(edge);
    return *std::max_element(sides.begin(), sides.end());
  }
  std::array<double, 3> dual_sides(Index edge) const {
    const auto [a, b, c] = complex_.edge_contacts[edge];
    return {(points_[a] - points_[b]).norm(), (points_[b] - points_[c]).norm(),
            (points_[c] - points_[a]).norm()};
  }

  /// The size that decides between cells of the same kind with the same facets.
  double size(Index cell) const {
    if (cell >= edge_count()) return complex_.radius[cell - edge_count()];
    const std::array<double, 3> sides = dual_sides(cell);
    return sides[0] + sides[1] + sides[2];
  }

  /// Makes the keys, and `groups_`: the cells whose key starts with the same level, a row each,
  /// levels descending.
  void group_cells(std::vector<double> value_of) {
    const Index facets = to_index(complex_.facet_count());
    std::vector<Index> lone_edges;
    for (Index e = 0; e < edge_count(); ++e) {
      const auto& around = complex_.edge_facets[e];
      if (std::any_of(around.begin(), around.end(), [](Index f) { return f != kNone; })) continue;
      lone_edges.push_back(e);
      value_of.push_back(longest_side(e));
    }
    std::vector<std::uint64_t> keys;
    keys.reserve(value_of.size());
    for (const double value : value_of) keys.push_back(descending_key(value));
    const std::vector<Index> sources = sorted_by_key(keys);  // a facet, or facets + a lone edge

    groups_.items.reserve(complex_.edge_count() + complex_.vertex_count());
    Index level = to_index(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const Index source = sources[i];
      if (i > 0 && value_of[source] != value_of[sources[i - 1]]) {
        groups_.close_row();
        --level;
      }
      if (source >= facets) {
        note(lone_edges[source - facets], level, edge_levels_[lone_edges[source - facets]]);
        continue;
      }
      for (const Index e : complex_.facet_edges[source]) note(e, level, edge_levels_[e]);
      for (const Index v : complex_.facet_vertices[source]) {
        note(edge_count() + v, level, vertex_levels_[v]);
      }
    }
    groups_.close_row();
    for (Index v = 0; v < complex_.vertex_count(); ++v) {
      if (vertex_levels_[v][0] == 0) groups_.items.push_back(edge_count() + v);
    }
    groups_.close_row();
  }

  /// Appends a level to a cell's key; the first one puts the cell into the current group.
  template <class Levels>
  void note(Index cell, Index level, Levels& levels) {
    if (levels[0] == 0) groups_.items.push_back(cell);
    *std::find(levels.begin(), levels.end(), Index{0}) = level;
  }

  /// Level number i of a cell's key.
  Index level_of(Index cell, std::size_t i) const {
    if (cell >= edge_count()) return vertex_levels_[cell - edge_count()][i];
    return i < EdgeLevels{}.size() ? edge_levels_[cell][i] : 0;
  }

  bool precedes(Index p, Index q) const {
    for (std::size_t i = 1; i < VertexLevels{}.size(); ++i) {
      const Index p_level = level_of(p, i);
      const Index q_level = level_of(q, i);
      if (p_level != q_level) return p_level < q_level;
    }
    const bool p_is_edge = p < edge_count();
    if (p_is_edge != (q < edge_count())) return p_is_edge;
    const double p_size = size(p);
    const double q_size = size(q);
    return p_size != q_size ? p_size < q_size : p < q;
  }

  const MedialComplex& complex_;
  const std::vector<Vec3>& points_;
  std::vector<EdgeLevels> edge_levels_;
  std::vector<VertexLevels> vertex_levels_;
  Rows<Index> groups_;
};

}  // namespace detail

/// Orders all edges and vertices of the complex. `points` are numbered as the contacts. n log n;
/// exact ties (symmetric shapes) by number. The same for any number of `threads` (0: all).
inline ErosionOrder order_cells(const MedialComplex& complex, const std::vector<double>& mgf,
                                const std::vector<Vec3>& points, unsigned threads = 0) {
  ErosionOrder order;
  order.cell_at = detail::CellSorter(complex, points).descending_cells(mgf, thread_count(threads));
  std::reverse(order.cell_at.begin(), order.cell_at.end());

  const Index edges = to_index(complex.edge_count());
  order.edge_rank.resize(edges);
  order.vertex_rank.resize(complex.vertex_count());
  for (Index rank = 0; rank < order.cell_at.size(); ++rank) {
    const Index cell = order.cell_at[rank];
    (cell < edges ? order.edge_rank[cell] : order.vertex_rank[cell - edges]) = rank;
  }
  return order;
}

}  // namespace mgf
