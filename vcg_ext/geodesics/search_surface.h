// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that paths are proven on: the surface itself, or one of the same shape without its
// flat vertices.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/flat_vertices.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_place.h"

namespace mgf {

/// The surface that searches run on, with each vertex of the fine surface located on it.
struct SearchSurface {
  HalfedgeMesh mesh;
  bool is_fine = true;               ///< `mesh` is the fine surface itself
  std::vector<SurfacePlace> places;  ///< one per vertex of the fine surface
  Rows<Index> parts;                 ///< one row per triangle of `mesh`: fine triangles in it
};

/// The surface `fine`, whose mesh is `mesh`, or, if a tenth of its vertices or more are flat and
/// `skip_flat_vertices` is set, one without them. O(n log n).
inline SearchSurface make_search_surface(const TriangleSurface& fine, const HalfedgeMesh& mesh,
                                         bool skip_flat_vertices = true) {
  SearchSurface search;
  const CoarseSurface coarse = skip_flat_vertices ? without_flat_vertices(fine) : CoarseSurface{};
  constexpr double kWorthIt = 0.9;  // paths on a coarse surface have to be found again on the fine
  if (skip_flat_vertices && static_cast<double>(coarse.surface.points.size()) <
                                kWorthIt * static_cast<double>(fine.points.size())) {
    search.is_fine = false;
    search.mesh = make_halfedge_mesh(coarse.surface);
    search.places = places_on_coarse(fine, coarse, search.mesh);
    search.parts = group_by_key(coarse.parent, coarse.surface.triangles.size());
    return search;
  }
  search.mesh = mesh;
  for (Index v = 0; v < fine.points.size(); ++v) {
    search.places.push_back(place_of_vertex(search.mesh, v));
  }
  for (Index t = 0; t < fine.triangles.size(); ++t) {
    search.parts.items.push_back(t);
    search.parts.close_row();
  }
  return search;
}

}  // namespace mgf
