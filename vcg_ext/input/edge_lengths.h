// SPDX-License-Identifier: GPL-3.0-or-later
// How long an edge may be: rules for the sampling.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcg_ext/core/parallel.h"
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
/// Share of the diagonal that the surface counts as thick where it is thinner, or touches itself,
/// so that allowing a multiple of the thickness always means longer edges.
inline constexpr double kThinnest = 1e-5;
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
  /// The same for any number of `threads`.
  LengthByThickness(const TriangleSurface& surface, const SurfaceTree& tree,
                    const CoarseShells& coarse, unsigned threads)
      : field_of_face_(surface.triangles.size(), kNone) {
    const double diagonal = bounding_box_diagonal(surface.points);
    shortest_ = detail::kShortest * diagonal;
    thinnest_ = detail::kThinnest * diagonal;
    std::vector<Index> faces;
    for (Index f = 0; f < surface.triangles.size(); ++f) {
      if (!coarse.has_face(f)) continue;
      field_of_face_[f] = to_index(faces.size());
      faces.push_back(f);
    }
    const Thickness thickness(surface, tree);
    constexpr std::size_t kChunk = 16;
    fields_.resize(faces.size());
    parallel_for(faces.size(), threads, kChunk, [&](std::size_t i, unsigned) {
      // Thickness beyond that asks for no split of this face's edges.
      const double limit = 1.01 * longest_side(surface, faces[i]) / detail::kEdgePerThickness;
      fields_[i] = FaceThickness(surface, thickness, faces[i], limit);
    });
  }

  double operator()(const SurfaceRefiner& refiner, Index side) const {
    double allowed = by_thickness(refiner, side);
    for (const Index from : {side, refiner.twin(side)}) {
      const Index second = SurfaceRefiner::next(from);
      const Index third = SurfaceRefiner::next(second);
      allowed = std::min({allowed, detail::kGrading * by_thickness(refiner, second),
                          detail::kGrading * by_thickness(refiner, third)});
    }
    return std::max(shortest_, allowed);
  }

 private:
  double by_thickness(const SurfaceRefiner& refiner, Index side) const {
    return detail::kEdgePerThickness *
           std::max(thinnest_,
                    std::min(beneath(refiner, side), beneath(refiner, refiner.twin(side))));
  }

  /// The least thickness at three points beside the edge, within the face of `side`.
  double beneath(const SurfaceRefiner& refiner, Index side) const {
    const Index face = refiner.parent(side / 3);
    if (field_of_face_[face] == kNone) return std::numeric_limits<double>::infinity();
    if (known_.size() <= side) known_.resize(refiner.side_count());
    const Index a = refiner.start(side);
    const Index b = refiner.end(side);
    const Index c = refiner.opposite(side);
    Known& known = known_[side];
    if (known.a != a || known.b != b || known.c != c) {
      const FaceThickness& field = fields_[field_of_face_[face]];
      known = {a, b, c, beneath(field, refiner.point(a), refiner.point(b), refiner.point(c))};
    }
    return known.thickness;
  }

  /// The same beside ab in the face abc.
  static double beneath(const FaceThickness& field, const Vec3& a, const Vec3& b, const Vec3& c) {
    double least = std::numeric_limits<double>::infinity();
    for (const double share : {1.0 / 6.0, 0.5, 5.0 / 6.0}) {
      least = std::min(least, field.near(0.8 * ((1.0 - share) * a + share * b) + 0.2 * c));
    }
    return least;
  }

  struct Known {
    Index a = kNone;  // corners of the face, from the side on
    Index b = kNone;
    Index c = kNone;
    double thickness = 0.0;
  };

  double shortest_ = 0.0;
  double thinnest_ = 0.0;
  std::vector<Index> field_of_face_;
  std::vector<FaceThickness> fields_;
  mutable std::vector<Known> known_;  // one per side: asked for often, changed rarely
};

}  // namespace mgf
