// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from a few landmarks to every vertex of a surface. By the triangle inequality they
// bound every other distance from below (Goldberg & Harrelson 2005), where the straight line says
// nothing: from one face of a thin wall to the other, the way leads round its rim.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_place.h"

namespace mgf {

/// What landmarks know of one mesh, on which no triangle is thin.
struct Landmarks {
  /// One row per landmark, one entry per vertex: the distance on the surface. 0 throughout on
  /// shells that the landmark isn't on, of whose distances it then says nothing.
  std::vector<std::vector<double>> distance;
};

/// Bounds of a distance.
struct DistanceRange {
  double least = 0.0;
  double most = 0.0;
};

/// Between what lies the distance of `place` from the landmark whose row this is.
inline DistanceRange distance_of_place(const HalfedgeMesh& mesh, const std::vector<double>& row,
                                       const SurfacePlace& place) {
  if (place.vertex != kNone) return {row[place.vertex], row[place.vertex]};
  DistanceRange range{0.0, std::numeric_limits<double>::infinity()};
  for (Index h = 3 * place.triangle; h < 3 * place.triangle + 3; ++h) {
    const double corner = row[mesh.tail(h)];
    const double way = norm(in_frame_of(mesh, h, place.at));
    range.least = std::max(range.least, corner - way);
    range.most = std::min(range.most, corner + way);
  }
  return range;
}

}  // namespace mgf
