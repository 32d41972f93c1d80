// SPDX-License-Identifier: GPL-3.0-or-later
// Betti numbers by counting and elimination: of a closed surface, of tetrahedra glued by faces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// The Betti numbers that the solid inside a closed, edge-manifold surface has: its shells, the sum
/// of their genera, 0. Vertices in no triangle are ignored; one shared by several fans counts once
/// a fan.
inline BettiNumbers expected_betti_numbers(const TriangleSurface& surface) {
  // Corners glued along edges: classes of corners at one vertex are the vertices of the abstract
  // surface.
  const std::size_t faces = surface.triangles.size();
  const EdgeTable edges = make_edge_table(surface.triangles);
  DisjointSets shells(faces);
  DisjointSets corners(3 * faces);
  const auto corner_at = [&](const FaceSide& side, Index v) {
    const bool at_start = side_start(surface.triangles[side.face], side.side) == v;
    return 3 * side.face + (at_start ? side.side : (side.side + 1) % 3);
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const FaceSide& first = edges.sides[e].front();
    for (const FaceSide& side : edges.sides[e]) {
      shells.join(first.face, side.face);
      for (const Index v : edges.ends[e]) corners.join(corner_at(first, v), corner_at(side, v));
    }
  }
  const auto euler =
      static_cast<std::int64_t>(corners.count() + faces) - static_cast<std::int64_t>(edges.size());
  const auto shell_count = static_cast<std::int64_t>(shells.count());
  return {static_cast<Index>(shell_count),
          static_cast<Index>(std::max<std::int64_t>(0, shell_count - euler / 2)), 0};
}

/// The dual cells of tetrahedra glued by faces, from adjacency alone: corners that look alike but
/// aren't glued are different cells.
struct DualCells {
  std::size_t vertices = 0;                 ///< tetrahedra
  std::vector<std::array<Index, 2>> edges;  ///< inner faces: the tetrahedra on either side
  Rows<Index> facets;                       ///< inner edges: the inner faces round each
};

namespace betti_detail {

inline unsigned back_face(const std::vector<Tetrahedron>& tetrahedra,
                          const std::vector<std::array<Index, 4>>& neighbours, Index t,
                          unsigned i) {
  const Index u = neighbours[t][i];
  unsigned j = 0;
  while (j < 4 && (neighbours[u][j] != t || corner_index(tetrahedra[t], tetrahedra[u][j]) != 4)) {
    ++j;
  }
  if (j < 4) return j;
  for (j = 0; j < 4 && neighbours[u][j] != t;) ++j;  // two copies with the same corners
  return j;
}

// The bit that stands for the edge between two corners of a tetrahedron.
inline unsigned edge_bit(unsigned i, unsigned j) {
  constexpr std::array<std::array<std::uint8_t, 4>, 4> kBit = {
      {{0, 1, 2, 4}, {1, 0, 8, 16}, {2, 8, 0, 32}, {4, 16, 32, 0}}};
  return kBit[i][j];
}

// Walks round the edge xy of t, marking it in each tetrahedron passed; fills `ring` with the inner
// faces crossed. False at the boundary.
inline bool inner_ring(const std::vector<Tetrahedron>& tetrahedra,
                       const std::vector<std::array<Index, 4>>& neighbours,
                       const std::vector<std::array<Index, 4>>& face_ids, Index t, Index x, Index y,
                       std::vector<std::uint8_t>& passed, std::vector<Index>& ring) {
  ring.clear();
  const Index first = t;
  do {
    const unsigned i = corner_index(tetrahedra[t], x);
    const unsigned j = corner_index(tetrahedra[t], y);
    passed[t] = static_cast<std::uint8_t>(passed[t] | edge_bit(i, j));
    const unsigned k = kEvenThird[i][j];
    if (neighbours[t][k] == kNone) return false;
    ring.push_back(face_ids[t][k]);
    t = neighbours[t][k];
  } while (t != first);
  return true;
}

// How many inner vertices there are, components, and components without boundary.
struct Solids {
  std::size_t vertices = 0;
  std::size_t components = 0;
  std::size_t closed_components = 0;
};

inline Solids count_solids(const std::vector<Tetrahedron>& tetrahedra,
                           const std::vector<std::array<Index, 4>>& neighbours) {
  Solids solids;
  DisjointSets corners(4 * tetrahedra.size());
  DisjointSets components(tetrahedra.size());
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = neighbours[t][i];
      if (u == kNone || u < t) continue;
      components.join(t, u);
      for (unsigned k = 0; k < 4; ++k) {
        if (k == i) continue;
        corners.join(4 * t + k, 4 * u + corner_index(tetrahedra[u], tetrahedra[t][k]));
      }
    }
  }
  std::vector<char> open(4 * tetrahedra.size(), 0);
  std::vector<char> open_component(tetrahedra.size(), 0);
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      if (neighbours[t][i] != kNone) continue;
      open_component[components.find(t)] = 1;
      for (unsigned k = 0; k < 4; ++k) {
        if (k != i) open[corners.find(4 * t + k)] = 1;
      }
    }
  }
  for (Index c = 0; c < open.size(); ++c) {
    if (corners.find(c) == c && open[c] == 0) ++solids.vertices;
  }
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    if (components.find(t) == t && open_component[t] == 0) ++solids.closed_components;
  }
  solids.components = components.count();
  return solids;
}

}  // namespace betti_detail

/// The dual cells of `tetrahedra` glued by `neighbours`. Requires symmetric adjacency.
inline DualCells dual_cells(const std::vector<Tetrahedron>& tetrahedra,
                            const std::vector<std::array<Index, 4>>& neighbours) {
  DualCells cells;
  cells.vertices = tetrahedra.size();
  cells.edges.reserve(2 * tetrahedra.size());
  cells.facets.items.reserve(4 * tetrahedra.size());
  cells.facets.begin.reserve(tetrahedra.size());
  std::vector<std::array<Index, 4>> face_ids(tetrahedra.size(), {kNone, kNone, kNone, kNone});
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = neighbours[t][i];
      if (u == kNone || u < t) continue;
      face_ids[t][i] = to_index(cells.edges.size());
      face_ids[u][betti_detail::back_face(tetrahedra, neighbours, t, i)] = face_ids[t][i];
      cells.edges.push_back({t, u});
    }
  }
  std::vector<std::uint8_t> passed(tetrahedra.size(), 0);
  std::vector<Index> ring;
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      for (unsigned j = 0; j < i; ++j) {
        if ((passed[t] & betti_detail::edge_bit(i, j)) != 0 ||
            !betti_detail::inner_ring(tetrahedra, neighbours, face_ids, t, tetrahedra[t][i],
                                      tetrahedra[t][j], passed, ring)) {
          continue;
        }
        cells.facets.items.insert(cells.facets.items.end(), ring.begin(), ring.end());
        cells.facets.close_row();
      }
    }
  }
  return cells;
}

namespace betti_detail {

// Rank over Z/2 of the boundary map from facets to edges: free edges first, as in a collapse, then
// elimination of what remains.
inline std::size_t facet_rank(const DualCells& cells) {
  std::vector<std::array<Index, 3>> cofaces(cells.edges.size(), {kNone, kNone, kNone});
  std::vector<unsigned> live(cells.edges.size(), 0);
  for (Index f = 0; f < cells.facets.size(); ++f) {
    for (const Index e : cells.facets[f]) cofaces[e][live[e]++] = f;
  }
  std::vector<char> gone(cells.facets.size(), 0);
  std::vector<Index> queue;
  for (Index e = 0; e < live.size(); ++e) {
    if (live[e] == 1) queue.push_back(e);
  }
  std::size_t rank = 0;
  while (!queue.empty()) {
    const Index e = queue.back();
    queue.pop_back();
    if (live[e] != 1) continue;
    Index facet = kNone;
    for (const Index f : cofaces[e]) {
      if (f != kNone && gone[f] == 0) facet = f;
    }
    gone[facet] = 1;
    ++rank;
    for (const Index other : cells.facets[facet]) {
      if (--live[other] == 1) queue.push_back(other);
    }
  }
  std::vector<std::vector<Index>> columns;
  std::vector<Index> owner(cells.edges.size(), kNone);  // column with this pivot
  std::vector<Index> sum;
  for (Index f = 0; f < gone.size(); ++f) {
    if (gone[f] != 0) continue;
    std::vector<Index> column(cells.facets[f].begin(), cells.facets[f].end());
    std::sort(column.begin(), column.end());
    while (!column.empty() && owner[column.back()] != kNone) {
      sum.clear();
      const std::vector<Index>& other = columns[owner[column.back()]];
      std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                    std::back_inserter(sum));
      column.swap(sum);
    }
    if (column.empty()) continue;
    ++rank;
    owner[column.back()] = to_index(columns.size());
    columns.push_back(std::move(column));
  }
  return rank;
}

}  // namespace betti_detail

/// What tetrahedra glued by their faces are as a 3-manifold.
struct GluedTopology {
  BettiNumbers betti;        ///< over Z/2, of the interior
  Index inner_vertices = 0;  ///< vertices with no face on the boundary: 3-cells of the dual complex
};

/// The topology of `tetrahedra` glued by `neighbours`. Requires symmetric adjacency. Linear time
/// but for the part of the dual complex that no collapse reaches, which is eliminated.
inline GluedTopology glued_topology(const std::vector<Tetrahedron>& tetrahedra,
                                    const std::vector<std::array<Index, 4>>& neighbours,
                                    unsigned threads = 1) {
  DualCells cells;
  std::size_t rank2 = 0;
  betti_detail::Solids solids;
  parallel_beside(
      threads,
      [&] {
        cells = dual_cells(tetrahedra, neighbours);
        rank2 = betti_detail::facet_rank(cells);
      },
      [&] { solids = betti_detail::count_solids(tetrahedra, neighbours); });
  const std::size_t rank1 = cells.vertices - solids.components;
  const std::size_t rank3 = solids.vertices - solids.closed_components;
  return {{to_index(solids.components), to_index(cells.edges.size() - rank1 - rank2),
           to_index(cells.facets.size() - rank2 - rank3)},
          to_index(solids.vertices)};
}

}  // namespace mgf
