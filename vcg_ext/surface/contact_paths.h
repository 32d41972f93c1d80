// SPDX-License-Identifier: GPL-3.0-or-later
// The paths on the surface between the corners of dual triangles, to draw geodesic circles from.
#pragma once

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_path.h"
#include "vcg_ext/medial/medial_geodesic_function.h"

namespace mgf {

/// Draws the path between two corners a < b of a dual triangle: the geodesic where the field has
/// one, else the surface's own edge between them. Refers to the field, which must outlive it.
class ContactPaths {
 public:
  ContactPaths(const TriangleSurface& surface, const MedialGeodesicField& field)
      : mesh_(make_halfedge_mesh(surface)), field_(field) {}

  SurfacePath operator()(Index a, Index b) const {
    const Index pair = field_.table.find(a, b);
    if (pair != kNone) return path_of_pair(mesh_, field_.table.pairs(), field_.geodesics, pair);
    return {{mesh_.points[a], mesh_.points[b]}, {triangle_of(find_halfedge(mesh_, a, b))}};
  }

 private:
  HalfedgeMesh mesh_;
  const MedialGeodesicField& field_;
};

}  // namespace mgf
