// SPDX-License-Identifier: GPL-3.0-or-later
// More vertices on a surface that has too few for a medial axis, such as a box of 8.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/input/shells.h"
#include "vcg_ext/input/surface_refiner.h"
#include "vcg_ext/input/thickness.h"

namespace mgf {

struct SamplingOptions {
  /// Longest edge allowed, mesh units; 0: leave the surface as it is; none: choose by local
  /// thickness, for shells that are too coarse.
  std::optional<double> length;
};

/// Splits edges of a closed, outward-oriented surface at their midpoints until they are short
/// enough, worst first, and keeps the parts of each face well shaped by flips within it. The point
/// set, the input's vertices and their numbers stay.
///
/// Automatic: a shell is too coarse if faces longer than it is thick beneath them make more than
/// half of its area; its edges are then split while longer than 0.7 of the thickness there (a rule
/// measured on boxes, blocks, cylinders and scans; scans are left alone) and than 0.7 % of the
/// diagonal. If that takes more than 4000 points and more than there are vertices, all lengths
/// grow until it doesn't: even sampling, though sparse, is better than a part well sampled.
///
/// Throws InputError "sampling_too_fine" if a fixed length asks for more than 5 million points,
/// "sampling_negative" if it is negative or no number. O(n log n) in the vertices of the result.
RefinedSurface refine_sampling(const TriangleSurface& surface, const SamplingOptions& options,
                               const Progress& progress = {});

/// The faces of shells that automatic sampling refines which are too coarse; ascending.
std::vector<Index> too_coarse_faces(const TriangleSurface& surface);

namespace detail {

/// Edges are at most this share of the thickness: about two sample spacings across.
inline constexpr double kEdgePerThickness = 0.70710678118654752;
/// Share of the diagonal below which no edge is split.
inline constexpr double kShortest = 0.70710678118654752 / 100.0;
/// An edge is at most this many times as long as the other sides of its faces may be, so that a
/// narrow face beside a thin plate doesn't end up in needles.
inline constexpr double kGrading = 2.0;
inline constexpr std::size_t kMostAutomatic = 4000;
inline constexpr std::size_t kMostFixed = 5000000;

/// A lower bound, but for the genus, on the points of a triangulation of the surface with edges up
/// to `length`: an equilateral triangle is the largest, and faces are twice as many as points.
inline double least_points(const TriangleSurface& surface, double length) {
  double area = 0.0;
  for (const Triangle& t : surface.triangles) {
    area += 0.5 * (surface.points[t[1]] - surface.points[t[0]])
                      .cross(surface.points[t[2]] - surface.points[t[0]])
                      .norm();
  }
  return 0.5 * area / (std::sqrt(3.0) / 4.0 * length * length);
}

/// Which shells automatic sampling refines, and why.
struct CoarseShells {
  Shells shells;
  std::vector<char> coarse_face;   ///< longer than the thickness
  std::vector<char> coarse_shell;  ///< coarse faces make more than half of its area
};

inline CoarseShells find_coarse_shells(const TriangleSurface& surface, const SurfaceTree& tree) {
  CoarseShells result;
  find_pieces(surface, make_edge_table(surface.triangles), result.shells);
  result.coarse_face = faces_coarser_than_thickness(surface, tree);
  std::vector<double> excess(result.shells.shells.size(), 0.0);  // coarse area minus the rest
  for (Index f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    const double area = (surface.points[t[1]] - surface.points[t[0]])
                            .cross(surface.points[t[2]] - surface.points[t[0]])
                            .norm();
    excess[result.shells.of_face[f]] += result.coarse_face[f] != 0 ? area : -area;
  }
  for (const double e : excess) result.coarse_shell.push_back(e > 0.0 ? 1 : 0);
  return result;
}

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
    shortest_ = kShortest * bounding_box_diagonal(surface.points);
    const Thickness thickness(surface, tree);
    for (Index f = 0; f < surface.triangles.size(); ++f) {
      if (coarse.coarse_shell[coarse.shells.of_face[f]] == 0) continue;
      field_of_face_[f] = to_index(fields_.size());
      // Thickness beyond that asks for no split of this face's edges.
      fields_.emplace_back(thickness, f, 1.01 * longest_side(surface, f) / kEdgePerThickness);
    }
  }

  double operator()(const SurfaceRefiner& refiner, Index side) const {
    double allowed = by_thickness(refiner, side);
    for (const Index from : {side, refiner.twin(side)}) {
      const Index second = SurfaceRefiner::next(from);
      const Index third = SurfaceRefiner::next(second);
      allowed = std::min({allowed, kGrading * by_thickness(refiner, second),
                          kGrading * by_thickness(refiner, third)});
    }
    return scale * std::max(shortest_, allowed);
  }

 private:
  double by_thickness(const SurfaceRefiner& refiner, Index side) const {
    return kEdgePerThickness *
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

/// Splits edges longer than `allowed(refiner, side)`, worst first, until none is left or
/// `most_points` are there. Ties go to the edge of least ends.
template <class Allowed>
class WorstFirstSplitter {
 public:
  WorstFirstSplitter(SurfaceRefiner& refiner, const Allowed& allowed, std::size_t most_points)
      : refiner_(refiner), allowed_(allowed), most_points_(most_points) {}

  void run(const Progress& progress) {
    const std::size_t first = refiner_.surface().surface.points.size();
    for (Index side = 0; side < refiner_.side_count(); ++side) {
      if (side < refiner_.twin(side)) consider(side);
    }
    while (!queue_.empty()) {
      const std::size_t count = refiner_.surface().surface.points.size();
      if (count >= most_points_) return;
      if (count % kReportEvery == 0) {
        progress.report(
            static_cast<double>(count - first) / static_cast<double>(most_points_ - first),
            "sampling");
      }
      const Candidate worst = queue_.top();
      queue_.pop();
      const Candidate now = candidate(worst.side);
      if (now.low != worst.low || now.high != worst.high) continue;  // the side is another edge's
      if (now.excess == worst.excess) {
        split(worst.side);
      } else if (now.excess > 1.0) {
        queue_.push(now);
      }
    }
  }

 private:
  static constexpr std::size_t kReportEvery = 1000;

  struct Candidate {
    double excess;  // length divided by the length allowed
    Index low;
    Index high;
    Index side;
    bool operator<(const Candidate& other) const {  // so that the top is worst
      if (excess != other.excess) return excess < other.excess;
      return std::pair(low, high) > std::pair(other.low, other.high);
    }
  };

  Candidate candidate(Index side) const {
    const Index a = refiner_.start(side);
    const Index b = refiner_.end(side);
    return {refiner_.length(side) / allowed_(refiner_, side), std::min(a, b), std::max(a, b), side};
  }

  void consider(Index side) {
    const Candidate fresh = candidate(side);
    if (fresh.excess > 1.0) queue_.push(fresh);
  }

  void split(Index side) {
    const Vec3 middle =
        0.5 * refiner_.point(refiner_.start(side)) + 0.5 * refiner_.point(refiner_.end(side));
    const Index m = refiner_.split_edge(side, middle);
    // The four new faces have m once each; walk round it for the sides opposite.
    changed_.clear();
    Index spoke = 3 * (side / 3) + 1;  // from m to the apex
    const Index first = spoke;
    do {
      changed_.push_back(spoke / 3);
      suspects_.push_back(opposite_side(spoke / 3, m));
      spoke = refiner_.twin(SurfaceRefiner::next(SurfaceRefiner::next(spoke)));
    } while (spoke != first);
    flip_suspects();
    for (const Index face : changed_) {
      for (Index i = 0; i < 3; ++i) consider(3 * face + i);
    }
  }

  Index opposite_side(Index face, Index corner) const {
    for (Index i = 0; i < 3; ++i) {
      if (refiner_.opposite(3 * face + i) == corner) return 3 * face + i;
    }
    return kNone;
  }

  /// Lawson's flips, starting from the suspects.
  void flip_suspects() {
    while (!suspects_.empty()) {
      const Index side = suspects_.back();
      suspects_.pop_back();
      const Index other = refiner_.twin(side);
      if (!refiner_.flip_if_better(side)) continue;
      for (const Index face : {side / 3, other / 3}) {
        changed_.push_back(face);
        suspects_.push_back(3 * face + 1);
        suspects_.push_back(3 * face + 2);
      }
    }
  }

  SurfaceRefiner& refiner_;
  const Allowed& allowed_;
  std::size_t most_points_;
  std::priority_queue<Candidate> queue_;
  std::vector<Index> changed_;   // faces of the present split
  std::vector<Index> suspects_;  // sides that may have to be flipped
};

template <class Allowed>
RefinedSurface split_long_edges(const TriangleSurface& surface, const Allowed& allowed,
                                std::size_t most_points, const Progress& progress) {
  SurfaceRefiner refiner(unrefined(surface));
  WorstFirstSplitter<Allowed>(refiner, allowed, most_points).run(progress);
  return std::move(refiner).release();
}

/// Splits by thickness, with all lengths multiplied by the least power of 3/2 that keeps the number
/// of points within bounds.
inline RefinedSurface split_by_thickness(const TriangleSurface& surface, const SurfaceTree& tree,
                                         const CoarseShells& coarse, const Progress& progress) {
  const std::size_t count = surface.points.size();
  const std::size_t most = count + std::max(count, kMostAutomatic);
  LengthByThickness allowed(surface, tree, coarse);
  RefinedSurface refined = split_long_edges(surface, allowed, most, progress);
  while (refined.surface.points.size() >= most) {
    allowed.scale *= 1.5;
    refined = split_long_edges(surface, allowed, most, progress);
  }
  return refined;
}

}  // namespace detail

inline std::vector<Index> too_coarse_faces(const TriangleSurface& surface) {
  const detail::CoarseShells coarse = detail::find_coarse_shells(surface, SurfaceTree(surface));
  std::vector<Index> faces;
  for (Index f = 0; f < surface.triangles.size(); ++f) {
    if (coarse.coarse_face[f] != 0 && coarse.coarse_shell[coarse.shells.of_face[f]] != 0) {
      faces.push_back(f);
    }
  }
  return faces;
}

inline RefinedSurface refine_sampling(const TriangleSurface& surface,
                                      const SamplingOptions& options, const Progress& progress) {
  const std::size_t count = surface.points.size();
  if (!options.length) {
    const SurfaceTree tree(surface);
    const detail::CoarseShells coarse = detail::find_coarse_shells(surface, tree);
    const auto& chosen = coarse.coarse_shell;
    if (std::find(chosen.begin(), chosen.end(), 1) == chosen.end()) return unrefined(surface);
    return detail::split_by_thickness(surface, tree, coarse, progress);
  }
  const double length = *options.length;
  if (!(length >= 0.0)) {
    throw InputError("sampling_negative", "The sampling length must be 0 or more.");
  }
  if (length == 0.0) return unrefined(surface);
  const InputError too_fine("sampling_too_fine",
                            "The sampling length asks for more than 5 million points. Choose a "
                            "longer one.");
  if (detail::least_points(surface, length) > static_cast<double>(detail::kMostFixed)) {
    throw too_fine;
  }
  const std::size_t most = count + detail::kMostFixed;
  RefinedSurface refined =
      detail::split_long_edges(surface, detail::FixedLength(length), most, progress);
  if (refined.surface.points.size() >= most) throw too_fine;
  return refined;
}

}  // namespace mgf
