// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which the erosion visits cells: by increasing MGF, ties broken by all that is known
// of a cell (paper, section 5.4; the paper's key, the largest incident f alone, is full of exact
// ties, and then the result depends on the numbering of the mesh).
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

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

/// The values by which a cell is ordered: its facets' f, descending, filled up with 0; then a size.
struct ErosionKey {
  std::array<double, 6> mgf{};
  bool is_vertex = false;
  double size = 0.0;

  /// Adds a facet's f, keeping the descending order; at most six fit.
  void insert(double value) {
    for (double& entry : mgf) {
      if (value > entry) std::swap(value, entry);
    }
  }

  bool operator<(const ErosionKey& other) const {
    if (mgf != other.mgf) return mgf < other.mgf;
    if (is_vertex != other.is_vertex) return other.is_vertex;
    return size < other.size;
  }
};

/// Makes the keys of cells; `points` are numbered as the contacts.
class ErosionKeys {
 public:
  ErosionKeys(const MedialComplex& complex, const std::vector<double>& mgf,
              const std::vector<Vec3>& points)
      : complex_(complex), points_(points), priority_(erosion_priority(complex, mgf)) {}

  /// The first entry of the cell's key, enough to order most cells.
  double leading_mgf(Index cell) const { return key(cell).mgf[0]; }

  ErosionKey key(Index cell) const {
    return cell < complex_.edge_count() ? edge_key(cell)
                                        : vertex_key(cell - to_index(complex_.edge_count()));
  }

 private:
  ErosionKey edge_key(Index edge) const {
    ErosionKey key;
    const Triangle& dual = complex_.edge_contacts[edge];
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index facet = complex_.edge_facets[edge][i];
      if (facet != kNone) key.insert(priority_[facet]);
      const double side = (points_[dual[i]] - points_[dual[(i + 1) % 3]]).norm();
      key.size += side;
      longest = std::max(longest, side);
    }
    if (key.mgf[0] == 0.0) key.insert(longest);  // no facet: a tube as thin as one triangle
    return key;
  }

  ErosionKey vertex_key(Index vertex) const {
    std::array<Index, 6> facets{};  // a tetrahedron has six edges
    std::size_t count = 0;
    for (const Index edge : complex_.vertex_edges[vertex]) {
      for (const Index facet : complex_.edge_facets[edge]) {
        const Index* const end = facets.data() + count;
        if (facet != kNone && std::find<const Index*>(facets.data(), end, facet) == end)
          facets[count++] = facet;
      }
    }
    ErosionKey key;
    for (std::size_t i = 0; i < count; ++i) key.insert(priority_[facets[i]]);
    key.is_vertex = true;
    key.size = complex_.radius[vertex];
    return key;
  }

  const MedialComplex& complex_;
  const std::vector<Vec3>& points_;
  std::vector<double> priority_;
};

}  // namespace detail

/// Orders all edges and vertices of the complex. n log n; exact ties (symmetric shapes) by number.
inline ErosionOrder order_cells(const MedialComplex& complex, const std::vector<double>& mgf,
                                const std::vector<Vec3>& points) {
  struct Entry {
    double leading;
    Index cell;
  };
  const detail::ErosionKeys keys(complex, mgf, points);
  const Index edges = to_index(complex.edge_count());
  const Index cells = edges + to_index(complex.vertex_count());
  std::vector<Entry> entries(cells);
  for (Index cell = 0; cell < cells; ++cell) entries[cell] = {keys.leading_mgf(cell), cell};
  std::sort(entries.begin(), entries.end(), [&](const Entry& p, const Entry& q) {
    if (p.leading != q.leading) return p.leading < q.leading;
    const detail::ErosionKey p_key = keys.key(p.cell);
    const detail::ErosionKey q_key = keys.key(q.cell);
    if (p_key < q_key) return true;
    return !(q_key < p_key) && p.cell < q.cell;
  });

  ErosionOrder order;
  order.edge_rank.resize(edges);
  order.vertex_rank.resize(complex.vertex_count());
  order.cell_at.resize(cells);
  for (Index rank = 0; rank < cells; ++rank) {
    const Index cell = entries[rank].cell;
    order.cell_at[rank] = cell;
    (cell < edges ? order.edge_rank[cell] : order.vertex_rank[cell - edges]) = rank;
  }
  return order;
}

}  // namespace mgf
