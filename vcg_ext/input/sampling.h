// SPDX-License-Identifier: GPL-3.0-or-later
// More vertices on a surface that has too few for a medial axis, such as a box of 8.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/coarse_shells.h"
#include "vcg_ext/input/edge_lengths.h"
#include "vcg_ext/input/edge_splitter.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/input/surface_refiner.h"

namespace mgf {

struct SamplingOptions {
  /// Longest edge allowed, mesh units; 0: leave the surface as it is; none: choose by local
  /// thickness, for shells that are too coarse.
  std::optional<double> length;
  unsigned threads = 0;  ///< 0: all; the result is the same for any number
};

/// Splits edges of a closed, outward-oriented surface at their midpoints until they are short
/// enough, worst first, and keeps the parts of each face well shaped by flips within it. The point
/// set, the input's vertices and their numbers stay.
///
/// Automatic: a shell is too coarse if faces longer than it is thick beneath them make more than
/// a quarter of its area; its edges are then split while longer than 0.7 of the thickness there (a
/// rule measured on boxes, blocks, cylinders and scans; scans are left alone) and than 0.7 % of the
/// diagonal. Both lengths are multiplied by the least of 1, 3/2, 9/4, ... for which 2000 points
/// (8000 from 9/4 on), or as many as there are vertices, are enough: even sampling, though sparse,
/// is better than a part well sampled.
///
/// Throws InputError "sampling_too_fine" if a fixed length asks for more than 5 million points,
/// "sampling_negative" if it is negative or no number. O(n log n) in the vertices of the result.
RefinedSurface refine_sampling(const TriangleSurface& surface, const SamplingOptions& options,
                               const Progress& progress = {});

namespace detail {

/// Lengths are multiplied by powers of this.
inline constexpr double kLengthStep = 1.5;
/// The most points for lengths multiplied by less than `kSufficient`, and by more.
inline constexpr std::size_t kMostToRefine = 2000;
inline constexpr std::size_t kMostToSuffice = 8000;
inline constexpr double kSufficient = 2.0;
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

[[noreturn]] inline void refuse_fine_sampling() {
  throw InputError("sampling_too_fine",
                   "The sampling length asks for more than 5 million points. Choose a longer one.");
}

/// Splits by thickness, in steps of the lengths allowed, as far as the number of points lets it
/// come to the end of a step: rows of needles are hard to recover where only some of them are
/// split.
inline RefinedSurface split_by_thickness(const TriangleSurface& surface, const SurfaceTree& tree,
                                         const CoarseShells& coarse, unsigned threads,
                                         const Progress& progress) {
  const std::size_t count = surface.points.size();
  const LengthByThickness allowed(surface, tree, coarse, thread_count(threads));
  SurfaceRefiner refiner(unrefined(surface));
  WorstFirstSplitter splitter(refiner, allowed);
  std::vector<double> factors{1.0};
  while (factors.back() < splitter.worst_excess()) {
    factors.push_back(kLengthStep * factors.back());
  }
  RefinedSurface refined = refiner.surface();
  for (auto factor = factors.rbegin(); factor != factors.rend(); ++factor) {
    const std::size_t most = *factor < kSufficient ? kMostToRefine : kMostToSuffice;
    if (!splitter.run(*factor, count + std::max(count, most), progress)) break;
    if (refiner.surface().surface.points.size() > refined.surface.points.size()) {
      refined = refiner.surface();
    }
  }
  return refined;
}

}  // namespace detail

inline RefinedSurface refine_sampling(const TriangleSurface& surface,
                                      const SamplingOptions& options, const Progress& progress) {
  const std::size_t count = surface.points.size();
  if (!options.length) {
    const SurfaceTree tree(surface);
    const CoarseShells coarse = find_coarse_shells(
        surface, tree, find_pieces(surface, make_edge_table(surface.triangles)), options.threads);
    if (!coarse.any()) return unrefined(surface);
    return detail::split_by_thickness(surface, tree, coarse, options.threads, progress);
  }
  const double length = *options.length;
  if (!(length >= 0.0)) {
    throw InputError("sampling_negative", "The sampling length must be 0 or more.");
  }
  if (length == 0.0) return unrefined(surface);
  if (detail::least_points(surface, length) > static_cast<double>(detail::kMostFixed)) {
    detail::refuse_fine_sampling();
  }
  const std::size_t most = count + detail::kMostFixed;
  SurfaceRefiner refiner(unrefined(surface));
  const FixedLength allowed(length);
  if (!WorstFirstSplitter(refiner, allowed).run(1.0, most, progress)) {
    detail::refuse_fine_sampling();
  }
  return std::move(refiner).release();
}

}  // namespace mgf
