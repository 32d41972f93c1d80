// SPDX-License-Identifier: GPL-3.0-or-later
// From a closed surface to tetrahedra that fill it, with its topology: the whole story.
#pragma once

#include <optional>
#include <utility>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/autorefine.h"
#include "vcg_ext/exact/self_intersections.h"
#include "vcg_ext/medial/betti.h"
#include "vcg_ext/medial/boxed_surface.h"
#include "vcg_ext/medial/interior_choice.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/recovery_attempt.h"

namespace mgf {

/// How the interior is found.
struct RecoveryOptions {
  bool recover_input_surface = false;  ///< T' = T: no surface flips at all
  bool lift_overlaps = true;  ///< where the surface passes through itself, keep both copies
};

namespace recovery_detail {

// flat flips, guided flips, growth, recursive attempts, seed
inline constexpr AttemptOptions kFirstAttempt = {true, true, 0.05, 400, 1};
inline constexpr AttemptOptions kMoreAttempts[] = {{true, false, 0.20, 400, 2},
                                                   {false, false, 0.50, 400, 3},
                                                   {true, true, 0.50, 1500, 4},
                                                   {false, false, 0.50, 1500, 5}};
inline constexpr AttemptOptions kSoupAttempts[] = {{true, false, 0.20, 400, 6},
                                                   {false, false, 0.50, 1500, 7}};

// The best of the results seen.
class Best {
 public:
  explicit Best(InteriorTetrahedra first) : best_(std::move(first)) {}
  void offer(InteriorTetrahedra next) {
    if (shortfall(next) < shortfall(best_)) best_ = std::move(next);
  }
  TopologyVerdict verdict() const { return best_.certificate.topology; }
  InteriorTetrahedra take() { return std::move(best_); }

 private:
  InteriorTetrahedra best_;
};

}  // namespace recovery_detail

/// Fills the solid inside `surface` with tetrahedra that have its topology (docs/topology.md): T is
/// changed a little into T' by edge flips, T' is forced into the Delaunay tetrahedralisation of its
/// vertices by local flips and, where they get stuck, by points added on it; a flood tells inside
/// from outside. The certificate says how much of that has been proven. A surface that crosses
/// itself is cut along the crossings; then the result has the topology of where the winding number
/// is positive, or better, of the solid immersed.
/// Requires `surface` closed, oriented outward, edge- and vertex-manifold, finite, without
/// duplicate points; several disjoint shells may lie side by side. Vertices keep their numbers.
/// Throws `InputError` on duplicate points and `Cancelled`. About 25 us a vertex.
inline InteriorTetrahedra recover_interior(const TriangleSurface& surface,
                                           const RecoveryOptions& options,
                                           const Progress& progress = {}) {
  using namespace recovery_detail;
  progress.report(0.0, "topology");
  const BettiNumbers expected = expected_betti_numbers(surface);
  const OrderedSurface ordered = in_spatial_order(surface);
  const auto attempt = [&](const BoxedSurface& boxed_surface, AttemptOptions way) {
    way.flat_flips = way.flat_flips && !options.recover_input_surface;
    way.guided_flips = way.guided_flips && !options.recover_input_surface;
    const RecoveredMesh recovered = attempt_recovery(boxed_surface, way, progress.slice(0.2, 0.9));
    return choose_interior(recovered, ordered, surface, expected, options.lift_overlaps);
  };
  const BoxedSurface plain = boxed(ordered);
  Best best(attempt(plain, kFirstAttempt));
  if (best.verdict() != TopologyVerdict::kProven) {
    if (exact::self_intersections(ordered.surface).empty()) {
      for (const AttemptOptions& way : kMoreAttempts) {
        best.offer(attempt(plain, way));
        if (best.verdict() == TopologyVerdict::kProven) break;
      }
    } else if (best.verdict() == TopologyVerdict::kFailed) {
      const std::optional<TriangleSurface> refined = autorefined(ordered.surface);
      if (refined) {
        const BoxedSurface soup = boxed(ordered, *refined);
        for (const AttemptOptions& way : kSoupAttempts) {
          best.offer(attempt(soup, way));
          if (best.verdict() != TopologyVerdict::kFailed) break;
        }
      }
    }
  }
  progress.report(1.0, "topology");
  return best.take();
}

}  // namespace mgf
