// SPDX-License-Identifier: GPL-3.0-or-later
// The surface that paths are proven on: the surface itself, or one of the same shape without its
// flat vertices.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/flat_vertices.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_place.h"

namespace mgf {

/// The surface that searches run on, with each vertex of the fine surface located on it.
class SearchSurface {
 public:
  /// The surface `fine`, whose mesh is `mesh` and must outlive this object, or, if a tenth of its
  /// vertices or more are flat and `skip_flat_vertices` is set, one without them. O(n log n).
  SearchSurface(const TriangleSurface& fine, const HalfedgeMesh& mesh,
                bool skip_flat_vertices = true)
      : fine_(mesh) {
    if (!skip_flat_vertices) return;
    // Paths on a coarse surface have to be found again on the fine one.
    constexpr double kWorthIt = 0.9;
    const CoarseSurface without = without_flat_vertices(fine);
    if (!(static_cast<double>(without.surface.points.size()) <
          kWorthIt * static_cast<double>(fine.points.size()))) {
      return;
    }
    Coarse coarse;
    coarse.mesh = make_halfedge_mesh(without.surface);
    coarse.places = places_on_coarse(fine, without, coarse.mesh);
    coarse.parts = group_by_key(without.parent, without.surface.triangles.size());
    coarse_ = std::move(coarse);
  }

  /// Whether it is the fine surface itself.
  bool is_fine() const { return !coarse_; }
  const HalfedgeMesh& mesh() const { return coarse_ ? coarse_->mesh : fine_; }

  /// Where a vertex of the fine surface is.
  SurfacePlace place(Index vertex) const {
    return coarse_ ? coarse_->places[vertex] : place_of_vertex(fine_, vertex);
  }

  /// Calls `visit` for the fine triangles in a triangle of `mesh()`.
  template <class Visit>
  void visit_parts(Index triangle, const Visit& visit) const {
    if (!coarse_) {
      visit(triangle);
      return;
    }
    for (const Index part : coarse_->parts[triangle]) visit(part);
  }

 private:
  struct Coarse {
    HalfedgeMesh mesh;
    std::vector<SurfacePlace> places;  ///< one per vertex of the fine surface
    Rows<Index> parts;                 ///< one row per triangle of `mesh`: fine triangles in it
  };

  const HalfedgeMesh& fine_;
  std::optional<Coarse> coarse_;
};

}  // namespace mgf
