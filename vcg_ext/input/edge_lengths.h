// SPDX-License-Identifier: GPL-3.0-or-later
// How long an edge may be: rules for the sampling.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/coarse_shells.h"
#include "vcg_ext/input/surface_refiner.h"
#include "vcg_ext/input/thickness.h"

namespace mgf {

namespace detail {

/// Edges are at most this share of the thickness: about two sample spacings across.
inline constexpr double kEdgePerThickness = 0.70710678118654752;
/// Share of the diagonal below which no edge is split.
inline constexpr double kShortest = 0.70710678118654752 / 100.0;
/// An edge is at most this many times as long as the other sides of its faces may be, so that a
/// narrow face beside a thin plate doesn't end up in needles.
inline constexpr double kGrading = 2.0;

}  // namespace detail

/// The longest that an edge may be: the same everywhere.
class FixedLength {
 public:
  explicit FixedLength(double length) : length_(length) {}
  double operator()(const SurfaceRefiner&, Index /*side*/) const { return length_; }

 private:
  double length_;
};

/// The longest that an edge may be, by the thickness beneath the two faces at it.
class LengthByThickness {
 public:
  /// Lengths are multiplied by this.
  double scale = 1.0;

  LengthByThickness(const TriangleSurface& surface, const SurfaceTree& tree,
                    const CoarseShells& coarse)
      : surface_(surface), field_of_face_(surface.triangles.size(), kNone) {
    shortest_ = detail::kShortest * bounding_box_diagonal(surface.points);
    const Thickness thickness(surface, tree);
    for (Index f = 0; f < surface.triangles.size(); ++f) {
      if (!coarse.has_face(f)) continue;
      field_of_face_[f] = to_index(fields_.size());
      // Thickness beyond that asks for no split of this face's edges.
      fields_.emplace_back(thickness, f,
                           1.01 * longest_side(surface, f) / detail::kEdgePerThickness);
    }
  }

  double operator()(const SurfaceRefiner& refiner, Index side) const {
    double allowed = by_thickness(refiner, side);
    for (const Index from : {side, refiner.twin(side)}) {
      const Index second = SurfaceRefiner::next(from);
      const Index third = SurfaceRefiner::next(second);
      allowed = std::min({allowed, detail::kGrading * by_thickness(refiner, second),
                          detail::kGrading * by_thickness(refiner, third)});
    }
    return scale * std::max(shortest_, allowed);
  }

 private:
  double by_thickness(const SurfaceRefiner& refiner, Index side) const {
    return detail::kEdgePerThickness *
           std::min(beneath(refiner, side), beneath(refiner, refiner.twin(side)));
  }

  /// The least thickness at three points beside the edge, within the face of `side`.
  double beneath(const SurfaceRefiner& refiner, Index side) const {
    const Index face = refiner.parent(side / 3);
    if (field_of_face_[face] == kNone) return std::numeric_limits<double>::infinity();
    const Vec3& a = refiner.point(refiner.start(side));
    const Vec3& b = refiner.point(refiner.end(side));
    const Vec3& c = refiner.point(refiner.opposite(side));
    double least = std::numeric_limits<double>::infinity();
    for (const double share : {1.0 / 6.0, 0.5, 5.0 / 6.0}) {
      const Vec3 beside = 0.8 * ((1.0 - share) * a + share * b) + 0.2 * c;
      least = std::min(least, fields_[field_of_face_[face]].near(barycentric(face, beside)));
    }
    return least;
  }

  Vec3 barycentric(Index face, const Vec3& p) const {
    const Triangle& t = surface_.triangles[face];
    const Vec3& a = surface_.points[t[0]];
    const Vec3 ab = surface_.points[t[1]] - a;
    const Vec3 ac = surface_.points[t[2]] - a;
    const Vec3 normal = ab.cross(ac);
    const double v = normal.dot((p - a).cross(ac)) / normal.squaredNorm();
    const double w = normal.dot(ab.cross(p - a)) / normal.squaredNorm();
    return {1.0 - v - w, v, w};
  }

  const TriangleSurface& surface_;
  double shortest_ = 0.0;
  std::vector<Index> field_of_face_;
  std::vector<FaceThickness> fields_;
};

}  // namespace mgf
