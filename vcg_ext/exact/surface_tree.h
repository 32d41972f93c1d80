// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about where a triangle surface is: nearest point, does a segment meet it, which side.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/box_tree.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/predicates.h"
#include "vcg_ext/exact/triangle_predicates.h"

namespace mgf {

/// A point on a surface.
struct SurfacePoint {
  Vec3 position;
  Index face = kNone;
  double distance = 0.0;  ///< from where the question was asked, mesh units
};

/// The point of segment ab nearest to p.
inline Vec3 nearest_point_of_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double share = (p - a).dot(along) / along.squaredNorm();
  // Written so that a segment of length 0 gives its end.
  if (share >= 1.0) return b;
  return share > 0.0 ? Vec3(a + share * along) : a;
}

/// The point of triangle abc nearest to p.
Vec3 nearest_point_of_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// A search tree on a triangle surface, which it refers to and which must outlive it. Immutable:
/// threads may share it. Yes-or-no answers are exact, positions are rounded; equal distances are
/// resolved to the face of least number. Requires finite points and no collinear face.
/// Built in O(n log n); a query near the surface costs about O(log n).
class SurfaceTree {
 public:
  explicit SurfaceTree(const TriangleSurface& surface)
      : SurfaceTree(surface, BoxTree(face_boxes(surface.points, surface.triangles))) {}
  /// With the tree of the boxes of the faces, made before.
  SurfaceTree(const TriangleSurface& surface, BoxTree boxes)
      : surface_(surface), tree_(std::move(boxes)) {}

  /// The surface point nearest to `point`; face kNone if the surface has no face.
  SurfacePoint nearest(const Vec3& point) const;

  /// True if the closed segment ab shares a point with the surface, touching included; faces
  /// with `skip(face)` don't count. Requires a != b.
  template <class Skip>
  bool segment_meets(const Vec3& a, const Vec3& b, const Skip& skip) const;
  bool segment_meets(const Vec3& a, const Vec3& b) const {
    return segment_meets(a, b, [](Index) { return false; });
  }

  /// The first point from `a` on where the closed segment ab meets the surface, found exactly when
  /// `segment_meets` is true; faces with `skip(face)` don't count. Where the segment runs within a
  /// face the point is only one that they share. A ray is a segment that ends outside the bounding
  /// box. Requires a != b.
  template <class Skip>
  std::optional<SurfacePoint> first_hit(const Vec3& a, const Vec3& b, const Skip& skip) const;
  std::optional<SurfacePoint> first_hit(const Vec3& a, const Vec3& b) const {
    return first_hit(a, b, [](Index) { return false; });
  }

  /// How often the surface winds round `point`: 1 inside an outward-oriented embedded closed
  /// surface, 0 outside. Exact for points off the surface; on it, one side's number.
  int winding_number(const Vec3& point) const {
    int winding = 0;
    visit_crossings(point, [&](Index, int sign) { winding += sign; });
    return winding;
  }
  bool inside(const Vec3& point) const { return winding_number(point) > 0; }

  /// Calls `visit(face, sign)` for each face that a ray going up (+z) from `point` crosses; sign is
  /// +1 where the ray leaves an outward-oriented surface. The ray is shifted by an infinitesimal
  /// (e, e^2), so that it meets no edge or vertex.
  template <class Visit>
  void visit_crossings(const Vec3& point, const Visit& visit) const;

 private:
  const Vec3& corner(Index face, std::size_t i) const {
    return surface_.points[surface_.triangles[face][i]];
  }

  const TriangleSurface& surface_;
  BoxTree tree_;
};

namespace detail {

/// A closed segment against boxes within `bounds`. May say yes to a box that it misses by a
/// rounding error, never no to one that it meets.
class SegmentBoxFilter {
 public:
  SegmentBoxFilter(const Vec3& a, const Vec3& b, const Box& bounds)
      : box_{a.cwiseMin(b), a.cwiseMax(b)},
        middle_(0.5 * (a + b)),
        half_(0.5 * (b - a)),
        half_size_(half_.cwiseAbs()) {
    const double scale = bounds.low.cwiseAbs().maxCoeff() + bounds.high.cwiseAbs().maxCoeff() +
                         middle_.cwiseAbs().maxCoeff() + half_size_.maxCoeff();
    slack_ = kSlack * scale * (scale + half_size_.maxCoeff());
  }

  bool operator()(const Box& box) const {
    if (!box_.meets(box)) return false;
    const Vec3 to_box = 0.5 * (box.low + box.high) - middle_;
    const Vec3 size = 0.5 * (box.high - box.low);
    const Vec3 normal = to_box.cross(half_).cwiseAbs();
    const Vec3& h = half_size_;
    return normal.x() <= size.y() * h.z() + size.z() * h.y() + slack_ &&
           normal.y() <= size.x() * h.z() + size.z() * h.x() + slack_ &&
           normal.z() <= size.x() * h.y() + size.y() * h.x() + slack_;
  }

 private:
  static constexpr double kSlack = 64.0 * std::numeric_limits<double>::epsilon();
  Box box_;
  Vec3 middle_;
  Vec3 half_;  // from there to an end
  Vec3 half_size_;
  double slack_ = 0.0;  // what rounding may make of it in any box
};

/// Sign of the orientation of a, b, p + (e, e^2) seen from above, for an infinitesimal e > 0;
/// 0 only if a and b lie one above the other.
inline int perturbed_orientation_from_above(const Vec3& a, const Vec3& b, const Vec3& p) {
  const int sign = orient2d_from_above(a, b, p);
  if (sign != 0) return sign;
  if (a.y() != b.y()) return b.y() < a.y() ? 1 : -1;
  if (a.x() != b.x()) return b.x() > a.x() ? 1 : -1;
  return 0;
}

}  // namespace detail

inline Vec3 nearest_point_of_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const bool within = normal.dot((b - a).cross(p - a)) >= 0.0 &&
                      normal.dot((c - b).cross(p - b)) >= 0.0 &&
                      normal.dot((a - c).cross(p - c)) >= 0.0;
  if (within && normal.squaredNorm() > 0.0) {
    return p - (p - a).dot(normal) / normal.squaredNorm() * normal;
  }
  Vec3 best = nearest_point_of_segment(p, a, b);
  for (const Vec3& other : {nearest_point_of_segment(p, b, c), nearest_point_of_segment(p, c, a)}) {
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  }
  return best;
}

inline SurfacePoint SurfaceTree::nearest(const Vec3& point) const {
  SurfacePoint best{point, kNone, std::numeric_limits<double>::infinity()};
  double best_squared = std::numeric_limits<double>::infinity();
  tree_.visit_near(point, best_squared, [&](Index face, double& bound) {
    const Vec3 candidate =
        nearest_point_of_triangle(point, corner(face, 0), corner(face, 1), corner(face, 2));
    const double squared = (candidate - point).squaredNorm();
    if (squared < best_squared || (squared == best_squared && face < best.face)) {
      best_squared = squared;
      bound = squared;
      best.position = candidate;
      best.face = face;
    }
  });
  best.distance = std::sqrt(best_squared);
  return best;
}

template <class Skip>
bool SurfaceTree::segment_meets(const Vec3& a, const Vec3& b, const Skip& skip) const {
  bool meets = false;
  const detail::SegmentBoxFilter filter(a, b, tree_.bounds());
  tree_.visit([&](const Box& box) { return !meets && filter(box); },
              [&](Index face) {
                if (meets || skip(face)) return;
                meets = exact::segment_meets_triangle(a, b, corner(face, 0), corner(face, 1),
                                                      corner(face, 2));
              });
  return meets;
}

template <class Skip>
std::optional<SurfacePoint> SurfaceTree::first_hit(const Vec3& a, const Vec3& b,
                                                   const Skip& skip) const {
  std::optional<SurfacePoint> first;
  double first_share = 1.0;
  const detail::SegmentBoxFilter filter(a, b, tree_.bounds());
  tree_.visit(filter, [&](Index face) {
    const Vec3& p = corner(face, 0);
    const Vec3& q = corner(face, 1);
    const Vec3& r = corner(face, 2);
    if (skip(face) || !exact::segment_meets_triangle(a, b, p, q, r)) return;
    const Vec3 normal = (q - p).cross(r - p);
    const double height_a = std::abs(normal.dot(a - p));
    const double height_b = std::abs(normal.dot(b - p));
    const double height = height_a + height_b;
    const double share = height > 0.0 ? height_a / height : 0.0;
    if (!first || share < first_share || (share == first_share && face < first->face)) {
      first_share = share;
      first = SurfacePoint{a + share * (b - a), face, share * (b - a).norm()};
    }
  });
  return first;
}

template <class Visit>
void SurfaceTree::visit_crossings(const Vec3& point, const Visit& visit) const {
  const Box above{point, {point.x(), point.y(), std::numeric_limits<double>::infinity()}};
  tree_.visit([&](const Box& box) { return box.meets(above); },
              [&](Index face) {
                const Vec3& a = corner(face, 0);
                const Vec3& b = corner(face, 1);
                const Vec3& c = corner(face, 2);
                const int sign = detail::perturbed_orientation_from_above(a, b, point);
                if (sign == 0 || sign != detail::perturbed_orientation_from_above(b, c, point) ||
                    sign != detail::perturbed_orientation_from_above(c, a, point)) {
                  return;
                }
                // The face seen from above is anticlockwise if sign > 0; then the point is below
                // it if it lies on the inner side.
                if (orient3d(a, b, c, point) * sign < 0) visit(face, sign);
              });
}

}  // namespace mgf
