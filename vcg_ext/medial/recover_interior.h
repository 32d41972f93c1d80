// SPDX-License-Identifier: GPL-3.0-or-later
// From a closed surface to tetrahedra that fill it, with its topology.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/delaunay.h"
#include "vcg_ext/medial/betti.h"
#include "vcg_ext/medial/boundary_recovery.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/lawson_cleanup.h"
#include "vcg_ext/medial/spatial_order.h"
#include "vcg_ext/medial/surface_flips.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"
#include "vcg_ext/medial/topology_certificate.h"
#include "vcg_ext/medial/winding_flood.h"

namespace mgf {

/// How the interior is found.
struct RecoveryOptions {
  bool recover_input_surface = false;  ///< T' = T: no surface flips at all
  bool lift_overlaps = true;  ///< where the surface passes through itself, keep both copies
};

namespace recovery_detail {

// The surface's triangulation in a box, ready for recovery.
struct Workspace {
  TetrahedralMesh mesh;
  ConstrainedSurface surface;
  Index surface_flips = 0;
  Index points_added = 0;
};

// One way to try.
struct Attempt {
  bool flat_flips;
  bool guided_flips;
  double growth;  // points that may be added: 200 and this share of the vertices
  int recursive_attempts;
  std::uint64_t seed;
};

inline constexpr std::size_t kBoxCorners = 8;
inline constexpr std::size_t kHullFaces = 12;

inline constexpr Attempt kAttempts[] = {{true, true, 0.05, 400, 1},
                                        {true, false, 0.20, 400, 2},
                                        {false, false, 0.50, 400, 3},
                                        {true, true, 0.50, 1500, 4},
                                        {false, false, 0.50, 1500, 5}};

// Eight corners far outside, so that no face of the surface is on the hull. Slightly irregular,
// which spares the triangulation cospherical cases.
inline std::vector<Vec3> with_box(const std::vector<Vec3>& points) {
  constexpr double kFar = 6.0;
  constexpr double kIrregular[8] = {0.0, 0.031, 0.073, 0.011, 0.057, 0.097, 0.043, 0.083};
  std::vector<Vec3> result = points;
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double reach = kFar * (high - low).norm();
  for (unsigned i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0,
                      (i & 4U) != 0 ? 1.0 : -1.0);
    result.push_back(0.5 * (low + high) + reach * (1.0 + kIrregular[i]) * corner);
  }
  return result;
}

inline bool attempt(Workspace& work, const Attempt& way, const RecoveryOptions& options,
                    const Progress& progress) {
  if (!options.recover_input_surface) {
    if (way.flat_flips) {
      work.surface_flips += flip_coplanar_edges(work.mesh.points(), work.surface);
    }
    if (way.guided_flips) work.surface_flips += flip_towards(work.mesh, work.surface);
  }
  RecoveryLimits limits;
  limits.added_points =
      200 + static_cast<std::size_t>(way.growth * static_cast<double>(work.mesh.points().size()));
  limits.recursive_attempts = way.recursive_attempts;
  limits.seed = way.seed;
  BoundaryRecovery recovery(work.mesh, work.surface, limits);
  const bool complete = recovery.run(progress);
  work.points_added = recovery.points_added();
  if (complete) LawsonCleanup(work.mesh, work.surface).run();
  return complete;
}

// The tetrahedra with a mark, glued as in the mesh.
inline InteriorTetrahedra extract(const TetrahedralMesh& mesh, const std::vector<char>& inside) {
  InteriorTetrahedra result;
  result.points = mesh.points();
  std::vector<Index> number(mesh.slot_count(), kNone);
  for (Index t = 0; t < mesh.slot_count(); ++t) {
    if (inside[t] == 0) continue;
    number[t] = to_index(result.tetrahedra.size());
    result.tetrahedra.push_back(mesh.corners(t));
  }
  result.neighbours.reserve(result.tetrahedra.size());
  for (Index t = 0; t < mesh.slot_count(); ++t) {
    if (inside[t] == 0) continue;
    std::array<Index, 4> neighbours{};
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = mesh.neighbour(t, i);
      neighbours[i] = u == kNone ? kNone : number[u];
      if (neighbours[i] == kNone) result.boundary.push_back(face_of(mesh.corners(t), i));
    }
    result.neighbours.push_back(neighbours);
  }
  return result;
}

// The surface with its vertices in spatial order and its faces sorted, so that nothing depends on
// how the caller numbered them.
struct OrderedSurface {
  TriangleSurface surface;
  std::vector<Index> original;  // number of each vertex before
};

inline OrderedSurface in_spatial_order(const TriangleSurface& surface) {
  std::vector<char> used(surface.points.size(), 0);
  for (const Triangle& face : surface.triangles) {
    for (const Index v : face) used[v] = 1;
  }
  std::vector<Index> vertices;
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v] != 0) vertices.push_back(v);
  }
  OrderedSurface result;
  result.original = spatial_order(surface.points, std::move(vertices));
  std::vector<Index> number(surface.points.size(), kNone);
  for (Index i = 0; i < result.original.size(); ++i) {
    number[result.original[i]] = i;
    result.surface.points.push_back(surface.points[result.original[i]]);
  }
  for (const Triangle& face : surface.triangles) {
    result.surface.triangles.push_back({number[face[0]], number[face[1]], number[face[2]]});
  }
  result.surface.triangles =
      certificate_detail::canonical_sorted(std::move(result.surface.triangles));
  return result;
}

// Back to the caller's numbers: its points, then the added ones; the box is dropped.
inline void restore_numbers(InteriorTetrahedra& interior, const OrderedSurface& ordered,
                            const std::vector<Vec3>& caller_points,
                            std::vector<Triangle>& boundary) {
  const std::size_t own = ordered.original.size();
  std::vector<Index> number(interior.points.size(), kNone);
  std::vector<Vec3> points = caller_points;
  for (Index v = 0; v < number.size(); ++v) {
    if (v < own) {
      number[v] = ordered.original[v];
    } else if (v >= own + kBoxCorners) {
      number[v] = to_index(points.size());
      points.push_back(interior.points[v]);
    }
  }
  const auto renumber = [&](auto& cells) {
    for (auto& cell : cells) {
      for (Index& v : cell) v = number[v];
    }
  };
  renumber(interior.tetrahedra);
  renumber(interior.boundary);
  renumber(boundary);
  interior.points = std::move(points);
  interior.input_points = to_index(caller_points.size());
}

}  // namespace recovery_detail

/// Fills the solid inside `surface` with tetrahedra that have its topology (docs/topology.md): T is
/// changed a little into T' by edge flips, T' is forced into the Delaunay tetrahedralisation of its
/// vertices by local flips and, where they get stuck, by points added on it; a flood tells inside
/// from outside. The certificate says how much of that has been proven.
/// Requires `surface` closed, oriented outward, edge- and vertex-manifold, finite, without
/// duplicate points; several disjoint shells may lie side by side. Vertices keep their numbers.
/// Throws `InputError` on duplicate points and `Cancelled`. About 25 us a vertex.
inline InteriorTetrahedra recover_interior(const TriangleSurface& surface,
                                           const RecoveryOptions& options,
                                           const Progress& progress = {}) {
  using namespace recovery_detail;
  progress.report(0.0, "topology");
  const OrderedSurface ordered = in_spatial_order(surface);
  const std::vector<Vec3> points = with_box(ordered.surface.points);
  TetrahedronArrays delaunay = delaunay_tetrahedra(points);
  std::optional<Workspace> work;
  for (const Attempt& way : kAttempts) {
    work.emplace(Workspace{TetrahedralMesh(points, delaunay.corners, delaunay.neighbours),
                           ConstrainedSurface(points.size(), ordered.surface.triangles), 0, 0});
    if (attempt(*work, way, options, progress.slice(0.2, 0.9))) break;
  }
  const WindingNumbers winding = flood_winding_numbers(work->mesh, work->surface);
  std::vector<char> inside(work->mesh.slot_count(), 0);
  for (Index t = 0; t < inside.size(); ++t) {
    inside[t] = work->mesh.alive(t) && winding.winding[t] > 0 ? 1 : 0;
  }
  InteriorTetrahedra interior = extract(work->mesh, inside);
  std::vector<Triangle> boundary = work->surface.faces();
  restore_numbers(interior, ordered, surface.points, boundary);
  interior.certificate.expected = expected_betti_numbers(surface);
  interior.certificate.winding_conflicts = winding.conflicts;
  interior.certificate.surface_flips = work->surface_flips;
  interior.certificate.points_added = work->points_added;
  certify(interior, boundary, is_triangulated_box(work->mesh, kHullFaces));
  progress.report(1.0, "topology");
  return interior;
}

}  // namespace mgf
