// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesic circles (paper, section 4.1): the closed curve of three shortest paths between the
// contact points of a skeleton edge.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// One circle per edge of a curve skeleton, in the skeleton's order.
struct GeodesicCircles {
  Rows<Vec3> polyline;               ///< points of the closed curve; the last repeats the first
  Rows<Index> faces;                 ///< triangles of the surface that the curve runs through
  std::vector<double> eccentricity;  ///< e(E)
};

}  // namespace mgf
