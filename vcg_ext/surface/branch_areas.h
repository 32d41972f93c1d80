// SPDX-License-Identifier: GPL-3.0-or-later
// What the surface says about each branch: its share of the area, and whether it is tubular.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/surface/segmentation.h"
#include "vcg_ext/surface/surface_map.h"

namespace mgf {

/// `graph` with `area_share`, `tubular_share` and `tubular` filled in: the area that the map gives
/// each branch over that of all of `input`, how much of it the segmentation calls tubular, and
/// whether that is half of it or more. A branch without surface of its own is tubular if its
/// `eccentricity_median` is below `eccentricity_threshold`. Linear time.
inline BranchGraph with_surface_measures(BranchGraph graph, const TriangleSurface& input,
                                         const SurfaceMap& map, const Segmentation& segmentation,
                                         double eccentricity_threshold) {
  std::vector<double> area(graph.branches.size(), 0.0);
  std::vector<double> tubular_area(graph.branches.size(), 0.0);
  double total = 0.0;
  for (Index f = 0; f < input.triangles.size(); ++f) {
    const Triangle& t = input.triangles[f];
    const Vec3& a = input.points[t[0]];
    const double face_area = 0.5 * (input.points[t[1]] - a).cross(input.points[t[2]] - a).norm();
    total += face_area;
    const Index b = map.faces.branch[f];
    if (b == kNone) continue;
    area[b] += face_area;
    if (segmentation.tubular[f]) tubular_area[b] += face_area;
  }
  for (Index b = 0; b < graph.branches.size(); ++b) {
    Branch& branch = graph.branches[b];
    branch.area_share = total > 0.0 ? area[b] / total : 0.0;
    branch.tubular_share = area[b] > 0.0 ? tubular_area[b] / area[b] : 0.0;
    branch.tubular = area[b] > 0.0 ? branch.tubular_share >= 0.5
                                   : branch.eccentricity_median > 0.0 &&
                                         branch.eccentricity_median < eccentricity_threshold;
  }
  return graph;
}

}  // namespace mgf
