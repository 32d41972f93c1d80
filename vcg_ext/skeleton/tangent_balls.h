// SPDX-License-Identifier: GPL-3.0-or-later
// Where the surface's vertices are dense enough for the Voronoi diagram to stand for the medial
// axis: there the ball round a Voronoi vertex is tangent to the surface at its contacts.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Tells balls that touch the surface at their contacts from balls that cut through it. Refers to
/// the surface, which must outlive it.
class BallTangency {
 public:
  /// `surface` looks outward. Linear time.
  explicit BallTangency(const TriangleSurface& surface) : points_(surface.points) {
    std::vector<Index> corner;
    corner.reserve(3 * surface.triangles.size());
    normal_.reserve(surface.triangles.size());
    for (const Triangle& t : surface.triangles) {
      corner.insert(corner.end(), t.begin(), t.end());
      const Vec3& a = points_[t[0]];
      normal_.push_back((points_[t[1]] - a).cross(points_[t[2]] - a).normalized());
    }
    faces_ = group_by_key(corner, points_.size());
    for (Index& item : faces_.items) item /= 3;
  }

  /// Whether the ball round `centre` whose sphere passes through the vertex `contact` is tangent
  /// to a face there, within 60 degrees: loose enough for any corner of a well-sampled shape.
  bool tangent(const Vec3& centre, Index contact) const {
    constexpr double kLeastCosine = 0.5;
    const Vec3 outward = (points_[contact] - centre).normalized();
    const Row<Index> faces = faces_[contact];
    return std::any_of(faces.begin(), faces.end(),
                       [&](Index f) { return outward.dot(normal_[f]) >= kLeastCosine; });
  }

 private:
  const std::vector<Vec3>& points_;
  std::vector<Vec3> normal_;  ///< one per face, outward, unit
  Rows<Index> faces_;         ///< round each vertex
};

}  // namespace mgf
