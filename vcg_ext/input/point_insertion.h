// SPDX-License-Identifier: GPL-3.0-or-later
// Given points become vertices of a surface.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/input/surface_refiner.h"

namespace mgf {

namespace detail {

/// Inserts points one by one into the faces of a surface, which itself stays as the reference of
/// where the nearest place is.
class PointInserter {
 public:
  explicit PointInserter(const RefinedSurface& surface)
      : original_(surface),
        tree_(surface.surface),
        refiner_(surface),
        tolerance_(kTolerance * bounding_box_diagonal(surface.surface.points)) {}

  void insert(const Vec3& point) {
    const SurfacePoint place = tree_.nearest(point);
    const Vec3& p = place.position;
    const Index part = part_at(place.face, p);
    const Index side = nearest_side(part, p);
    const Index first_new_face = to_index(refiner_.triangles().size());
    if (distance_to_side(side, p) > tolerance_) {
      refiner_.split_face(part, p);
      add_parts(place.face, first_new_face, 2);
      return;
    }
    const Index chosen = at_corner(side, p) ? longer_side_at_corner(side, p) : side;
    const Index other_face = refiner_.twin(chosen) / 3;
    const Index other_original = original_face(other_face);
    refiner_.split_edge(chosen, p);
    add_parts(place.face, first_new_face, 1);
    add_parts(other_original, first_new_face + 1, 1);
  }

  RefinedSurface release() && { return std::move(refiner_).release(); }

 private:
  /// Share of the diagonal within which a point counts as on an edge or at a vertex.
  static constexpr double kTolerance = 1e-12;

  /// The faces that an original face consists of by now, itself first.
  std::vector<Index>& parts(Index face) {
    std::vector<Index>& list = parts_[face];
    if (list.empty()) list.push_back(face);
    return list;
  }

  Index original_face(Index part) const {
    const std::size_t original_count = original_.surface.triangles.size();
    return part < original_count ? part : original_of_new_[part - original_count];
  }

  void add_parts(Index face, Index first, Index count) {
    for (Index i = 0; i < count; ++i) {
      parts(face).push_back(first + i);
      original_of_new_.push_back(face);
    }
  }

  /// The part of an original face nearest to p, which lies in one or on a border.
  Index part_at(Index face, const Vec3& p) {
    Index best = kNone;
    double best_distance = std::numeric_limits<double>::infinity();
    for (const Index part : parts(face)) {
      const Triangle& t = refiner_.triangles()[part];
      const double distance =
          (nearest_point_of_triangle(p, refiner_.point(t[0]), refiner_.point(t[1]),
                                     refiner_.point(t[2])) -
           p)
              .squaredNorm();
      if (distance < best_distance) {
        best_distance = distance;
        best = part;
      }
    }
    return best;
  }

  double distance_to_side(Index side, const Vec3& p) const {
    const Vec3& a = refiner_.point(refiner_.start(side));
    const Vec3& b = refiner_.point(refiner_.end(side));
    return (nearest_point_of_segment(p, a, b) - p).norm();
  }

  Index nearest_side(Index face, const Vec3& p) const {
    Index best = 3 * face;
    for (const Index side : {3 * face + 1, 3 * face + 2}) {
      if (distance_to_side(side, p) < distance_to_side(best, p)) best = side;
    }
    return best;
  }

  bool is_at(Index vertex, const Vec3& p) const {
    return (refiner_.point(vertex) - p).norm() <= tolerance_;
  }
  bool at_corner(Index side, const Vec3& p) const {
    return is_at(refiner_.start(side), p) || is_at(refiner_.end(side), p);
  }

  /// Of the two sides of the face at the corner where p is, the longer one.
  Index longer_side_at_corner(Index side, const Vec3& p) const {
    const bool at_start = is_at(refiner_.start(side), p);
    const Index leaving = at_start ? side : SurfaceRefiner::next(side);
    const Index arriving = SurfaceRefiner::next(SurfaceRefiner::next(leaving));
    return refiner_.length(arriving) > refiner_.length(leaving) ? arriving : leaving;
  }

  const RefinedSurface& original_;
  SurfaceTree tree_;
  SurfaceRefiner refiner_;
  double tolerance_;
  std::unordered_map<Index, std::vector<Index>> parts_;  // of the original faces that were split
  std::vector<Index> original_of_new_;                   // one per face added
};

}  // namespace detail

/// Inserts each point at the nearest place of the surface, ties to the face of least number, by
/// splitting the face there in three, or the edge if it is within 1e-12 of the diagonal. Point i
/// gets the number surface.points.size() + i and the position of that place; nothing moves.
///
/// A point within 1e-12 of the diagonal of a vertex gets a vertex of its own all the same, where it
/// is: the longer side there of the face that it lies in is split. The two vertices are then joined
/// by an edge that may have length 0, between two faces that may have no area; distances along the
/// surface are unaffected.
///
/// Requires a closed manifold surface without collinear faces. O((n + k) log n) for k points, if
/// few share a face.
inline RefinedSurface insert_points(const RefinedSurface& surface,
                                    const std::vector<Vec3>& points) {
  if (points.empty()) return surface;
  detail::PointInserter inserter(surface);
  for (const Vec3& point : points) inserter.insert(point);
  return std::move(inserter).release();
}

}  // namespace mgf
