// SPDX-License-Identifier: GPL-3.0-or-later
// Geodesic circles (paper, section 4.1): the closed curve of three shortest paths between the
// contact points of a skeleton edge.
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf {

/// One circle per edge of a curve skeleton, in the skeleton's order.
struct GeodesicCircles {
  Rows<Vec3> polyline;               ///< points of the closed curve; the last repeats the first;
                                     ///< empty where there is no path between two contacts
  Rows<Index> faces;                 ///< triangles of the surface that the curve runs through or
                                     ///< along, ascending, each once
  std::vector<double> eccentricity;  ///< e(E)
};

/// The geodesic circle of each skeleton edge: a to b, b to c, c to a for its contacts a < b < c.
/// `path_of(a, b)` returns the shortest path between two contacts a < b as `points`, from a to b,
/// and `faces`, the triangles it runs through or along; it is asked only for sides of dual
/// triangles. Cost: three paths an edge.
template <class PathOf>
GeodesicCircles trace_geodesic_circles(const CurveSkeleton& skeleton, const PathOf& path_of) {
  GeodesicCircles circles;
  circles.eccentricity = skeleton.eccentricity;
  for (const Triangle& contact : skeleton.contacts) {
    const auto ab = path_of(contact[0], contact[1]);
    const auto bc = path_of(contact[1], contact[2]);
    const auto ac = path_of(contact[0], contact[2]);

    std::vector<Index> faces;
    if (!ab.points.empty() && !bc.points.empty() && !ac.points.empty()) {
      std::vector<Vec3>& points = circles.polyline.items;
      points.insert(points.end(), ab.points.begin(), ab.points.end());
      points.insert(points.end(), bc.points.begin() + 1, bc.points.end());
      points.insert(points.end(), ac.points.rbegin() + 1, ac.points.rend());
      faces = ab.faces;
      faces.insert(faces.end(), bc.faces.begin(), bc.faces.end());
      faces.insert(faces.end(), ac.faces.begin(), ac.faces.end());
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    }
    circles.polyline.close_row();
    circles.faces.items.insert(circles.faces.items.end(), faces.begin(), faces.end());
    circles.faces.close_row();
  }
  return circles;
}

}  // namespace mgf
