// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at recovery, from the Delaunay tetrahedralisation to a mesh that has the surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/boundary_recovery.h"
#include "vcg_ext/medial/boxed_surface.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/exact_recovery.h"
#include "vcg_ext/medial/face_lookup.h"
#include "vcg_ext/medial/lawson_cleanup.h"
#include "vcg_ext/medial/surface_flips.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// One way to try.
struct AttemptOptions {
  std::uint64_t seed;
  Index spare_points;      ///< points that may be added: so many
  double growth;           ///< and this share of the vertices
  int recursive_attempts;  ///< per missing edge or face
  bool flat_flips;
  bool guided_flips;
};

/// How far an attempt came.
struct RecoveredMesh {
  TetrahedralMesh mesh;
  ConstrainedSurface surface;  ///< T'
  bool complete = false;       ///< every face of T' is a face of the mesh
  bool gave_up = false;        ///< the bounds on work kept it from being complete
  Index surface_flips = 0;
  Index points_added = 0;  ///< by recovery and before it
};

/// The Delaunay tetrahedralisation beside T, or T with its flat edges flipped.
inline RecoveredMesh recovery_start(const BoxedSurface& boxed, bool flat_flips) {
  return {TetrahedralMesh(boxed.points, boxed.delaunay.corners, boxed.delaunay.neighbours),
          flat_flips ? boxed.flat.surface : ConstrainedSurface(boxed.points.size(), boxed.faces),
          false, false, flat_flips ? boxed.flat.flips : 0};
}

/// How much work one recovery may take, counted so that it is the same on any machine.
struct WorkBounds {
  int recursive_attempts;  ///< in all
  std::uint64_t steps;     ///< tetrahedra looked at
};

/// The bounds for a surface of `points` vertices, times `effort`, which is 0 or more; infinity: no
/// bounds. Where they come from is in docs/topology.md.
inline WorkBounds work_bounds(std::size_t points, double effort) {
  const auto scaled = [&](double spare, double per_point, auto most) {
    const double bound = effort * (spare + per_point * static_cast<double>(points));
    return bound < static_cast<double>(most) ? static_cast<decltype(most)>(bound) : most;
  };
  return {scaled(7.5e4, 3.0, std::numeric_limits<int>::max()),
          scaled(3e7, 3e3, std::numeric_limits<std::uint64_t>::max())};
}

/// Flips T towards the mesh and recovers it. Bounded work; incomplete if the bounds didn't do.
inline RecoveredMesh attempt_recovery(const BoxedSurface& boxed, const AttemptOptions& options,
                                      const WorkBounds& bounds, const Progress& progress) {
  RecoveredMesh result = recovery_start(boxed, options.flat_flips);
  if (options.guided_flips) {
    result.surface_flips += SurfaceFlipper(boxed.points, result.surface).flip_towards(result.mesh);
  }
  RecoveryLimits limits;
  limits.attempts_in_all = bounds.recursive_attempts;
  limits.steps = bounds.steps;
  limits.added_points =
      options.spare_points +
      static_cast<std::size_t>(options.growth * static_cast<double>(boxed.points.size()));
  limits.recursive_attempts = options.recursive_attempts;
  limits.seed = options.seed;
  BoundaryRecovery recovery(result.mesh, result.surface, limits);
  result.complete = recovery.run(progress);
  result.points_added = recovery.points_added();
  if (result.complete) LawsonCleanup(result.mesh, result.surface).run();
  return result;
}

/// Flips T towards the mesh, which is an isotopy, if `flip_surface`; then as many points exactly on
/// T' as it takes. Complete for each surface that doesn't cross itself (docs/topology.md), if the
/// bounds on steps do.
inline RecoveredMesh recover_exactly(const BoxedSurface& boxed, bool flip_surface,
                                     const WorkBounds& bounds, const Progress& progress,
                                     unsigned threads = 1) {
  RecoveredMesh result = recovery_start(boxed, flip_surface);
  std::vector<Index> missing;
  if (flip_surface) {
    SurfaceFlipper flipper(boxed.points, result.surface);
    result.surface_flips += flipper.flip_towards(result.mesh, threads);
    missing = flipper.missing();
  } else {
    missing = missing_faces(result.mesh, boxed.faces, threads);
  }
  const std::vector<Triangle> faces = result.surface.faces();
  ExactRecovery recovery(result.mesh, faces, std::move(missing),
                         {bounds.recursive_attempts, bounds.steps});
  const auto parts = recovery.run(progress);
  result.gave_up = !parts && recovery.spent();
  result.points_added = to_index(result.mesh.exact_point_count());
  if (!parts) return result;
  result.complete = true;
  result.surface = ConstrainedSurface(result.mesh.points().size(), *parts);
  LawsonCleanup(result.mesh, result.surface).run();
  return result;
}

}  // namespace mgf
