// SPDX-License-Identifier: GPL-3.0-or-later
// How thick the shape is beneath its surface: the length of inward normal rays.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"

namespace mgf {

/// Local thickness of a shape: the distance from a point of a face along the inward normal to the
/// surface. Unlike the radius of the medial ball it doesn't go to 0 at convex edges.
class Thickness {
 public:
  /// Refers to both, which must outlive it. Requires an outward-oriented surface without
  /// collinear faces.
  Thickness(const TriangleSurface& surface, const SurfaceTree& tree)
      : surface_(surface), tree_(tree) {}

  /// The thickness at barycentric coordinates `at` of a face, mesh units; infinite if it's more
  /// than `limit`.
  double at(Index face, const Vec3& at, double limit) const {
    const auto [from, to] = ray(face, at, limit);
    const auto hit = tree_.first_hit(from, to, [face](Index other) { return other == face; });
    return hit ? hit->distance : std::numeric_limits<double>::infinity();
  }

  /// True if the thickness there is `limit` at most.
  bool is_within(Index face, const Vec3& at, double limit) const {
    const auto [from, to] = ray(face, at, limit);
    return tree_.segment_meets(from, to, [face](Index other) { return other == face; });
  }

 private:
  std::array<Vec3, 2> ray(Index face, const Vec3& at, double length) const {
    const Triangle& t = surface_.triangles[face];
    const Vec3& a = surface_.points[t[0]];
    const Vec3& b = surface_.points[t[1]];
    const Vec3& c = surface_.points[t[2]];
    const Vec3 from = at[0] * a + at[1] * b + at[2] * c;
    return {from, from - length * (b - a).cross(c - a).normalized()};
  }

  const TriangleSurface& surface_;
  const SurfaceTree& tree_;
};

/// The longest side of a face.
inline double longest_side(const TriangleSurface& surface, Index face) {
  const Triangle& t = surface.triangles[face];
  const Vec3& a = surface.points[t[0]];
  const Vec3& b = surface.points[t[1]];
  const Vec3& c = surface.points[t[2]];
  return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

/// True if the face's longest side is more than the shape's thickness beneath its centre: balls
/// through its corners then reach through the shape, and no medial axis can be made from them.
/// Cost: a short ray.
inline bool is_coarser_than_thickness(const TriangleSurface& surface, const SurfaceTree& tree,
                                      Index face) {
  const Vec3 centre = Vec3::Constant(1.0 / 3.0);
  return Thickness(surface, tree).is_within(face, centre, longest_side(surface, face));
}

/// The thickness of one face at the centres of the 16 like triangles that it can be cut into. Fixed
/// points bound it from below, so that refining at an acute edge, where it goes to 0, ends.
class FaceThickness {
 public:
  FaceThickness() = default;

  /// Thickness beyond `limit` counts as infinite.
  FaceThickness(const TriangleSurface& surface, const Thickness& thickness, Index face,
                double limit) {
    const Triangle& t = surface.triangles[face];
    origin_ = surface.points[t[0]];
    const Vec3 ab = surface.points[t[1]] - origin_;
    const Vec3 ac = surface.points[t[2]] - origin_;
    const Vec3 normal = ab.cross(ac);
    to_b_ = ac.cross(normal) / normal.squaredNorm();
    to_c_ = normal.cross(ab) / normal.squaredNorm();
    for (int i = 0; i < kParts; ++i) {
      for (int j = 0; i + j < kParts; ++j) {
        at_[cell(i, j, false)] = thickness.at(face, centre(i, j, 1.0 / 3.0), limit);
        if (i + j < kParts - 1) {
          at_[cell(i, j, true)] = thickness.at(face, centre(i, j, 2.0 / 3.0), limit);
        }
      }
    }
  }

  /// The thickness at a point of the face.
  double near(const Vec3& p) const {
    const double v = to_b_.dot(p - origin_);
    const double w = to_c_.dot(p - origin_);
    const auto part = [](double share) {
      return std::clamp(static_cast<int>(std::floor(share * kParts)), 0, kParts - 1);
    };
    const int i = part(1.0 - v - w);
    const int j = std::min(part(v), kParts - 1 - i);
    const int k = part(w);
    return at_[cell(i, j, i + j + k < kParts - 1 && i + j < kParts - 1)];
  }

 private:
  static constexpr int kParts = 4;  // along a side

  static Vec3 centre(int i, int j, double shift) {
    const double u = (i + shift) / kParts;
    const double v = (j + shift) / kParts;
    return {u, v, 1.0 - u - v};
  }
  /// Row i has 7 - 2 i parts, upright and upside-down in turn.
  static std::size_t cell(int i, int j, bool upside_down) {
    const int number = i * (2 * kParts - i) + 2 * j + (upside_down ? 1 : 0);
    return static_cast<std::size_t>(number);
  }

  Vec3 origin_ = Vec3::Zero();  // of the face's barycentric coordinates: its first corner
  Vec3 to_b_ = Vec3::Zero();    // gradient of the second corner's
  Vec3 to_c_ = Vec3::Zero();    // and of the third's
  std::array<double, static_cast<std::size_t>(kParts) * kParts> at_{};
};

}  // namespace mgf
