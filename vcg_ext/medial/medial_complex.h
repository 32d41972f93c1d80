// SPDX-License-Identifier: GPL-3.0-or-later
// The medial complex M_T (paper, section 5.1): the dual cell complex of the interior tetrahedra.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/medial/interior_tetrahedra.h"

namespace mgf {

/// The Voronoi cells inside the shape as flat arrays. A Voronoi vertex is dual to an interior
/// tetrahedron, a Voronoi edge to a triangle between two of them, a Voronoi facet to a Delaunay
/// edge all of whose tetrahedra are inside. Cells are never derived from coordinates.
struct MedialComplex {
  // Voronoi vertices, numbered as the tetrahedra.
  std::vector<Vec3> position;  ///< circumcentre, or a point nearby inside the shape (see placement)
  std::vector<double> radius;  ///< distance from `position` to the nearest of its four contacts
  std::vector<char> displaced;  ///< 1 where the circumcentre lies outside and was replaced
  Rows<Index> vertex_edges;     ///< incident Voronoi edges, ascending

  // Voronoi edges.
  std::vector<std::array<Index, 2>> edge_vertices;
  std::vector<Triangle> edge_contacts;            ///< corners a < b < c of the dual triangle
  std::vector<std::array<Index, 3>> edge_facets;  ///< dual to the sides bc, ca, ab; kNone for a
                                                  ///< side on the surface

  // Voronoi facets.
  std::vector<VertexPair> facet_contacts;  ///< ends a < b of the dual Delaunay edge
  Rows<Index> facet_edges;     ///< the bounding Voronoi edges, right-handed about a → b
  Rows<Index> facet_vertices;  ///< vertex i lies between edges i-1 and i of the same row

  // Three-dimensional cells: only a contact buried inside the shape (where its surface crosses
  // itself) has one.
  std::vector<std::array<Index, 2>> facet_cells;  ///< of the contacts a and b; kNone for a contact
                                                  ///< on the boundary
  Index cell_count = 0;

  std::size_t vertex_count() const { return position.size(); }
  std::size_t edge_count() const { return edge_vertices.size(); }
  std::size_t facet_count() const { return facet_contacts.size(); }
};

namespace detail {

/// The local number of corner `vertex` in a tetrahedron that has it.
inline std::size_t local_corner(const Tetrahedron& tetrahedron, Index vertex) {
  std::size_t i = 0;
  while (tetrahedron[i] != vertex) ++i;
  return i;
}

/// The corner of a tetrahedron that is none of the other three.
inline Index fourth_corner(const Tetrahedron& tetrahedron, Index x, Index y, Index z) {
  for (const Index corner : tetrahedron) {
    if (corner != x && corner != y && corner != z) return corner;
  }
  return kNone;
}

/// The six edges of a tetrahedron (i, j) with the other two corners (k, l) such that (i, j, k, l)
/// is an even permutation.
inline constexpr std::array<std::array<std::uint8_t, 4>, 6> kTetrahedronEdges = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

/// The number in `kTetrahedronEdges` of the edge between two local corners.
inline std::size_t local_edge(std::size_t i, std::size_t j) {
  if (i > j) std::swap(i, j);
  return i == 0 ? j - 1 : i + j;
}

/// Numbers the Voronoi edges; `edge_across[t][i]` is the one through the face opposite corner i.
inline std::vector<std::array<Index, 4>> number_voronoi_edges(const InteriorTetrahedra& interior,
                                                              MedialComplex& complex) {
  const std::size_t count = interior.tetrahedra.size();
  std::vector<std::array<Index, 4>> edge_across(count, {kNone, kNone, kNone, kNone});
  for (Index t = 0; t < count; ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Index u = interior.neighbours[t][i];
      if (u == kNone || edge_across[t][i] != kNone) continue;
      const Tetrahedron& corners = interior.tetrahedra[t];
      Triangle dual{corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]};
      const Index apex = fourth_corner(interior.tetrahedra[u], dual[0], dual[1], dual[2]);
      std::sort(dual.begin(), dual.end());
      const Index edge = to_index(complex.edge_count());
      edge_across[t][i] = edge;
      edge_across[u][local_corner(interior.tetrahedra[u], apex)] = edge;
      complex.edge_vertices.push_back({t, u});
      complex.edge_contacts.push_back(dual);
    }
  }
  complex.edge_facets.assign(complex.edge_count(), {kNone, kNone, kNone});
  return edge_across;
}

/// The tetrahedra around one Delaunay edge with the Voronoi edges between them.
struct EdgeRing {
  std::vector<Index> tetrahedra;
  std::vector<Index> crossed;
  bool closed = false;  ///< false: the ring met the boundary, so the edge has no facet
};

/// Walks round edge number `edge` of tetrahedron `start`, marking what it passes in `visited`
/// (a bit per local edge).
inline void walk_ring(const InteriorTetrahedra& interior,
                      const std::vector<std::array<Index, 4>>& edge_across, Index start,
                      std::size_t edge, std::vector<std::uint8_t>& visited, EdgeRing& ring) {
  ring.tetrahedra.clear();
  ring.crossed.clear();
  const auto [i, j, k, l] = kTetrahedronEdges[edge];
  const Tetrahedron& first = interior.tetrahedra[start];
  const Index x = first[i];
  const Index y = first[j];
  Index behind = first[k];  // the face opposite `behind` is crossed next
  Index ahead = first[l];
  Index t = start;
  do {
    const Tetrahedron& corners = interior.tetrahedra[t];
    visited[t] = static_cast<std::uint8_t>(
        visited[t] | (1U << local_edge(local_corner(corners, x), local_corner(corners, y))));
    const std::size_t face = local_corner(corners, behind);
    const Index next = interior.neighbours[t][face];
    if (next == kNone) {
      ring.closed = false;
      return;
    }
    ring.tetrahedra.push_back(t);
    ring.crossed.push_back(edge_across[t][face]);
    behind = std::exchange(ahead, fourth_corner(interior.tetrahedra[next], x, y, ahead));
    t = next;
  } while (t != start);
  ring.closed = true;
}

/// Adds the facet dual to edge xy with the given ring, right-handed about x → y.
inline void add_facet(Index x, Index y, const EdgeRing& ring, MedialComplex& complex) {
  const Index facet = to_index(complex.facet_count());
  const std::size_t n = ring.tetrahedra.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (x < y) {
      complex.facet_vertices.items.push_back(ring.tetrahedra[i]);
      complex.facet_edges.items.push_back(ring.crossed[i]);
    } else {  // about y → x the ring runs backwards
      complex.facet_vertices.items.push_back(ring.tetrahedra[n - 1 - i]);
      complex.facet_edges.items.push_back(ring.crossed[(2 * n - 2 - i) % n]);
    }
  }
  complex.facet_vertices.close_row();
  complex.facet_edges.close_row();
  complex.facet_contacts.push_back({std::min(x, y), std::max(x, y)});
  for (const Index edge : ring.crossed) {
    const Triangle& dual = complex.edge_contacts[edge];
    std::size_t apex = 0;
    while (dual[apex] == x || dual[apex] == y) ++apex;
    complex.edge_facets[edge][apex] = facet;
  }
}

/// Numbers the 3-cells: the stars of corners that meet no boundary face. `cell_of[4 t + i]` is that
/// of corner i of tetrahedron t, or kNone. Corners, not vertices: where overlaps were lifted, a
/// vertex has several stars.
inline std::vector<Index> number_cells(const InteriorTetrahedra& interior, Index& cell_count) {
  const std::size_t corner_count = 4 * interior.tetrahedra.size();
  DisjointSets stars(corner_count);
  std::vector<char> on_boundary(corner_count, 0);
  const auto corner_number = [](Index t, std::size_t i) {
    return to_index(std::size_t{4} * t + i);
  };
  for (Index t = 0; t < interior.tetrahedra.size(); ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Index u = interior.neighbours[t][i];
      for (std::size_t j = 0; j < 4; ++j) {
        if (j == i) continue;
        const Index vertex = interior.tetrahedra[t][j];
        if (u == kNone) {
          on_boundary[corner_number(t, j)] = 1;
        } else {
          stars.join(corner_number(t, j),
                     corner_number(u, local_corner(interior.tetrahedra[u], vertex)));
        }
      }
    }
  }
  std::vector<char> star_on_boundary(corner_count, 0);
  for (Index c = 0; c < corner_count; ++c) {
    if (on_boundary[c] != 0) star_on_boundary[stars.find(c)] = 1;
  }
  std::vector<Index> cell_of(corner_count, kNone);
  for (Index c = 0; c < corner_count; ++c) {
    const Index star = stars.find(c);  // the smallest corner, so it is numbered first
    if (star_on_boundary[star] == 0) cell_of[c] = star == c ? cell_count++ : cell_of[star];
  }
  return cell_of;
}

/// Fills in `facet_cells`.
inline void attach_cells(const InteriorTetrahedra& interior, MedialComplex& complex) {
  const std::vector<Index> cell_of = number_cells(interior, complex.cell_count);
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    const Index t = complex.facet_vertices[f].front();
    const Tetrahedron& corners = interior.tetrahedra[t];
    const VertexPair& contacts = complex.facet_contacts[f];
    const std::size_t first = std::size_t{4} * t;  // number of t's first corner
    complex.facet_cells[f] = {cell_of[first + local_corner(corners, contacts.a)],
                              cell_of[first + local_corner(corners, contacts.b)]};
  }
}

/// Centre of the sphere through four points; not finite where they lie in a plane. The caller
/// gives the corners in a fixed order so that equal tetrahedra get equal centres.
inline Vec3 circumcentre(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 a = q - p;
  const Vec3 b = r - p;
  const Vec3 c = s - p;
  const Vec3 bc = b.cross(c);
  const Vec3 sum =
      a.squaredNorm() * bc + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b);
  return p + sum / (2.0 * a.dot(bc));
}

}  // namespace detail

/// The circumcentre of tetrahedron t, the same for any order of its corners.
inline Vec3 tetrahedron_circumcentre(const InteriorTetrahedra& interior, Index t) {
  Tetrahedron corners = interior.tetrahedra[t];
  std::sort(corners.begin(), corners.end());
  return detail::circumcentre(interior.points[corners[0]], interior.points[corners[1]],
                              interior.points[corners[2]], interior.points[corners[3]]);
}

namespace detail {

/// Puts the Voronoi vertices at the circumcentres.
inline void place_at_circumcentres(const InteriorTetrahedra& interior, MedialComplex& complex) {
  for (Index t = 0; t < interior.tetrahedra.size(); ++t) {
    complex.position[t] = tetrahedron_circumcentre(interior, t);
    complex.radius[t] = (interior.points[interior.tetrahedra[t][0]] - complex.position[t]).norm();
  }
}

/// Fills in all that is combinatorics.
inline void connect_cells(const InteriorTetrahedra& interior, MedialComplex& complex) {
  const std::size_t count = interior.tetrahedra.size();
  complex.edge_vertices.reserve(2 * count);
  complex.edge_contacts.reserve(2 * count);
  const auto edge_across = number_voronoi_edges(interior, complex);
  for (const std::array<Index, 4>& around : edge_across) {
    const std::size_t first = complex.vertex_edges.items.size();
    for (const Index edge : around) {
      if (edge != kNone) complex.vertex_edges.items.push_back(edge);
    }
    std::sort(complex.vertex_edges.items.begin() + static_cast<std::ptrdiff_t>(first),
              complex.vertex_edges.items.end());
    complex.vertex_edges.close_row();
  }

  std::vector<std::uint8_t> visited(count, 0);
  EdgeRing ring;
  for (Index t = 0; t < count; ++t) {
    for (std::size_t e = 0; e < 6; ++e) {
      if ((visited[t] >> e & 1U) != 0) continue;
      walk_ring(interior, edge_across, t, e, visited, ring);
      if (!ring.closed) continue;
      const auto& local = kTetrahedronEdges[e];
      add_facet(interior.tetrahedra[t][local[0]], interior.tetrahedra[t][local[1]], ring, complex);
    }
  }
  complex.facet_cells.assign(complex.facet_count(), {kNone, kNone});
  if (interior.certificate.interior_vertices > 0) attach_cells(interior, complex);
}

}  // namespace detail

/// The dual complex of `interior`, Voronoi vertices at their circumcentres wherever these lie (not
/// finite for flat tetrahedra): `place_voronoi_vertices` mends that. `improve_places`, if given, is
/// called while cells are still being connected. Linear time. The same for any number of `threads`.
inline MedialComplex build_medial_complex(
    const InteriorTetrahedra& interior, unsigned threads = 1,
    const std::function<void(MedialComplex&)>& improve_places = {}) {
  MedialComplex complex;
  const std::size_t count = interior.tetrahedra.size();
  complex.position.resize(count);
  complex.radius.resize(count);
  complex.displaced.assign(count, 0);
  parallel_beside(
      threads,
      [&] {
        detail::place_at_circumcentres(interior, complex);
        if (improve_places) improve_places(complex);
      },
      [&] { detail::connect_cells(interior, complex); });
  return complex;
}

}  // namespace mgf
