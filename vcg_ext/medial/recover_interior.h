// SPDX-License-Identifier: GPL-3.0-or-later
// From a closed surface to tetrahedra that fill it, with its topology: the whole story.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/autorefine.h"
#include "vcg_ext/medial/betti.h"
#include "vcg_ext/medial/boxed_surface.h"
#include "vcg_ext/medial/interior_choice.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/recovery_attempt.h"

namespace mgf {

/// How the interior is found.
struct RecoveryOptions {
  bool recover_input_surface = false;  ///< T' = T: no surface flips at all
  bool lift_overlaps = true;        ///< where the surface passes through itself, keep both copies
  std::size_t known_crossings = 0;  ///< pairs of faces known to cross: if many, the surface is cut
                                    ///< there at once. 0 promises nothing, but hopes for none
  double effort = 1.0;   ///< scales the bounds on work beyond which a surface counts as one that
                         ///< can't be recovered; 0 or more, infinity: no bounds
  unsigned threads = 0;  ///< 0: all; the result is the same for any number
};

namespace recovery_detail {

// Of a surface that crosses itself: seed, spare points, growth, recursive attempts, flat flips,
// guided flips.
inline constexpr AttemptOptions kPlainAttempt = {1, 200, 0.05, 400, true, true};
inline constexpr AttemptOptions kSoupAttempts[] = {{2, 200, 0.20, 400, true, false},
                                                   {3, 200, 0.50, 1500, false, false}};

// Flips and splits serve a surface that crosses itself in no more pairs of faces.
inline constexpr std::size_t kFewCrossings = 32;

// Ways to recover one surface, tried in turn; the best of the results seen.
class Attempts {
 public:
  Attempts(const TriangleSurface& surface, const RecoveryOptions& options, DelaunayAhead* ahead,
           const Progress& progress)
      : surface_(surface),
        options_(options),
        ahead_(ahead),
        delaunay_progress_(progress.slice(0.0, 0.2)),
        progress_(progress.slice(0.2, 0.9)),
        threads_(thread_count(options.threads)) {
    parallel_beside(
        threads_, [&] { ordered_ = in_spatial_order(surface_); },
        [&] { expected_ = expected_betti_numbers(surface_); });
  }

  void run() {
    if (options_.known_crossings > kFewCrossings && cut_along_crossings()) return;
    const BoxedSurface plain = boxed(ordered_, threads_, delaunay_progress_, ahead_);
    if (options_.known_crossings == 0) {
      const RecoveredMesh exact = recover_exactly(plain, !options_.recover_input_surface,
                                                  bounds_for(plain), progress_, threads_);
      consider(exact);
      // More would come to nothing, as the bounds are the same.
      if (verdict() == TopologyVerdict::kProven || exact.gave_up) return;
    }
    attempt(plain, kPlainAttempt);
    if (verdict() == TopologyVerdict::kFailed) cut_along_crossings();
  }

  InteriorTetrahedra take_best() { return std::move(*best_); }

 private:
  TopologyVerdict verdict() const { return best_->certificate.topology; }

  // Gives whether every face was recovered.
  bool attempt(const BoxedSurface& boxed_surface, AttemptOptions way) {
    way.flat_flips = way.flat_flips && !options_.recover_input_surface;
    way.guided_flips = way.guided_flips && !options_.recover_input_surface;
    const RecoveredMesh recovered =
        attempt_recovery(boxed_surface, way, bounds_for(boxed_surface), progress_);
    consider(recovered);
    return recovered.complete;
  }

  WorkBounds bounds_for(const BoxedSurface& boxed_surface) const {
    return work_bounds(boxed_surface.points.size(), options_.effort);
  }

  void consider(const RecoveredMesh& recovered) {
    InteriorTetrahedra found =
        choose_interior(recovered, ordered_, surface_, expected_, options_.lift_overlaps, threads_);
    found.certificate.gave_up = recovered.gave_up;
    if (!best_ || shortfall(found) < shortfall(*best_)) best_ = std::move(found);
  }

  // False if that can't be done. A complete recovery has nothing to gain from another.
  bool cut_along_crossings() {
    const std::optional<TriangleSurface> refined = autorefined(ordered_.surface);
    if (!refined) return false;
    const BoxedSurface soup = boxed(ordered_, *refined, threads_, delaunay_progress_);
    for (const AttemptOptions& way : kSoupAttempts) {
      if (attempt(soup, way) || verdict() != TopologyVerdict::kFailed) return true;
    }
    return true;
  }

  const TriangleSurface& surface_;
  const RecoveryOptions& options_;
  DelaunayAhead* ahead_;
  Progress delaunay_progress_;
  Progress progress_;
  unsigned threads_;
  BettiNumbers expected_;
  OrderedSurface ordered_;
  std::optional<InteriorTetrahedra> best_;
};

}  // namespace recovery_detail

/// Fills the solid inside `surface` with tetrahedra that have its topology (docs/topology.md): T is
/// changed a little into T' by edge flips, T' is forced into the Delaunay tetrahedralisation of its
/// vertices by local flips and, where they get stuck, by points exactly on it; a flood tells inside
/// from outside. The certificate says how much of that has been proven: all, unless the surface
/// crosses itself. Then it is cut along the crossings if need be, and the result has the topology
/// of where the winding number is positive, or better, of the solid immersed. Requires `surface`
/// closed, oriented outward, edge- and vertex-manifold, finite, without duplicate points; several
/// disjoint shells may lie side by side. Vertices keep their numbers. `ahead`: begun with what
/// `boxed_vertices` gives for this surface, it is hoped, or nullptr. Throws `InputError` on
/// duplicate points and `Cancelled`. About 8 us a vertex.
inline InteriorTetrahedra recover_interior(const TriangleSurface& surface,
                                           const RecoveryOptions& options,
                                           const Progress& progress = {},
                                           DelaunayAhead* ahead = nullptr) {
  progress.report(0.0, "topology");
  recovery_detail::Attempts attempts(surface, options, ahead, progress);
  attempts.run();
  progress.report(1.0, "topology");
  return attempts.take_best();
}

}  // namespace mgf
