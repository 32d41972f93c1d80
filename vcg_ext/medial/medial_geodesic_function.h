// SPDX-License-Identifier: GPL-3.0-or-later
// The medial geodesic function and its gradient, one value per Voronoi facet (paper, section 5.2).
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/pair_geodesics.h"

namespace mgf {

/// The MGF on the medial complex, and the geodesics it comes from.
struct MedialGeodesicField {
  std::vector<double> mgf;     ///< f(F), one per facet, mesh units
  std::vector<Vec3> gradient;  ///< v(F), one per facet: unit, in the facet's plane, towards larger
                               ///< f; zero where the two tangents cancel

  std::vector<VertexPair> pairs;  ///< all pairs with a geodesic: those of the facets, then the sides
                                  ///< of dual triangles that lie on T' but are no edge of the surface
  std::vector<Index> facet_pair;  ///< one per facet: its entry in `pairs`
  PairGeodesics geodesics;        ///< one per pair
};

}  // namespace mgf
