// SPDX-License-Identifier: GPL-3.0-or-later
// The medial complex M_T (paper, section 5.1): the dual cell complex of the interior tetrahedra.
#pragma once

#include <array>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/medial/interior_tetrahedra.h"

namespace mgf {

/// The Voronoi cells inside the shape as flat arrays. A Voronoi vertex is dual to an interior
/// tetrahedron, a Voronoi edge to a triangle between two of them, a Voronoi facet to a Delaunay
/// edge all of whose tetrahedra are inside. Cells are never derived from coordinates.
struct MedialComplex {
  // Voronoi vertices, numbered as the tetrahedra.
  std::vector<Vec3> position;   ///< circumcentre, or a point nearby inside the shape (see placement)
  std::vector<double> radius;   ///< distance from `position` to the nearest of its four contacts
  std::vector<char> displaced;  ///< 1 where the circumcentre lies outside and was replaced
  Rows<Index> vertex_edges;     ///< incident Voronoi edges, ascending

  // Voronoi edges.
  std::vector<std::array<Index, 2>> edge_vertices;
  std::vector<Triangle> edge_contacts;  ///< corners a < b < c of the dual triangle
  std::vector<std::array<Index, 3>> edge_facets;  ///< dual to the sides bc, ca, ab; kNone for a
                                                  ///< side on the surface

  // Voronoi facets.
  std::vector<VertexPair> facet_contacts;  ///< ends a < b of the dual Delaunay edge
  Rows<Index> facet_edges;                 ///< the bounding Voronoi edges, in cyclic order
  Rows<Index> facet_vertices;  ///< vertex i lies between edges i-1 and i of the same row

  std::size_t vertex_count() const { return position.size(); }
  std::size_t edge_count() const { return edge_vertices.size(); }
  std::size_t facet_count() const { return facet_contacts.size(); }
};

}  // namespace mgf
