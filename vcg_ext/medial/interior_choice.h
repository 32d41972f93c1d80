// SPDX-License-Identifier: GPL-3.0-or-later
// From a recovered mesh to the interior: inside and outside, and the best reading of a surface that
// crosses itself.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/boxed_surface.h"
#include "vcg_ext/medial/interior_cleaning.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/overlap_lifting.h"
#include "vcg_ext/medial/ray_winding.h"
#include "vcg_ext/medial/recovery_attempt.h"
#include "vcg_ext/medial/topology_certificate.h"
#include "vcg_ext/medial/winding_flood.h"

namespace mgf {
namespace choice_detail {

// What all readings of one recovered mesh have in common.
struct Evidence {
  const RecoveredMesh& recovered;
  const OrderedSurface& ordered;
  const TriangleSurface& input;
  BettiNumbers expected;
  WindingNumbers winding;
  bool embedded;     // the mesh triangulates its box
  unsigned threads;  // how many to use
};

inline bool is_consistent(const WindingNumbers& winding) {
  return winding.faces_missing == 0 && winding.conflicts == 0;
}

// Where the flood contradicts itself or lacks walls, winding numbers at the tetrahedra's centroids
// about the surface as it was given.
inline std::vector<char> inside_marks(const Evidence& evidence) {
  const TetrahedralMesh& mesh = evidence.recovered.mesh;
  std::vector<char> inside(mesh.slot_count(), 0);
  if (is_consistent(evidence.winding)) {
    for (Index t = 0; t < inside.size(); ++t) {
      inside[t] = mesh.alive(t) && evidence.winding.winding[t] > 0 ? 1 : 0;
    }
    return inside;
  }
  const RayWinding ray(evidence.ordered.surface.points, evidence.ordered.surface.triangles);
  const std::size_t own = evidence.ordered.original.size();
  const auto is_box = [&](Index v) { return v >= own && v < own + kBoxCorners; };
  for (Index t = 0; t < inside.size(); ++t) {
    if (!mesh.alive(t)) continue;
    const auto [a, b, c, d] = mesh.corners(t);
    if (is_box(a) || is_box(b) || is_box(c) || is_box(d)) continue;
    const Vec3 centroid = 0.25 * (mesh.point(a) + mesh.point(b) + mesh.point(c) + mesh.point(d));
    inside[t] = ray(centroid) > 0 ? 1 : 0;
  }
  return inside;
}

inline InteriorTetrahedra certified(InteriorTetrahedra interior, const Evidence& evidence,
                                    bool embedded) {
  std::vector<Triangle> boundary = evidence.recovered.surface.faces();
  const TetrahedralMesh& mesh = evidence.recovered.mesh;
  interior.certificate.exact_points = to_index(mesh.exact_point_count());
  if (interior.certificate.exact_points != 0) {
    interior.certificate.tetrahedra_not_positive = to_index(static_cast<std::size_t>(std::count_if(
        interior.tetrahedra.begin(), interior.tetrahedra.end(),
        [&](const Tetrahedron& t) { return mesh.orientation(t[0], t[1], t[2], t[3]) <= 0; })));
  }
  restore_numbers(interior, boundary, evidence.ordered, evidence.input.points);
  collect_boundary(interior);
  interior.certificate.expected = evidence.expected;
  interior.certificate.winding_conflicts = evidence.winding.conflicts;
  interior.certificate.surface_flips = evidence.recovered.surface_flips;
  interior.certificate.points_added = to_index(interior.points.size()) - interior.input_points;
  certify(interior, boundary, embedded, evidence.threads);
  return interior;
}

inline InteriorTetrahedra cleaned(InteriorTetrahedra interior, const Evidence& evidence) {
  keep_largest_components(interior, evidence.expected.b0);
  carve_buried_vertices(interior);
  return certified(std::move(interior), evidence, false);
}

}  // namespace choice_detail

/// Orders results by how much of the topology is right: smaller is better.
inline std::tuple<int, std::int64_t, Index> shortfall(const InteriorTetrahedra& interior) {
  const TopologyCertificate& c = interior.certificate;
  const auto distance = [](Index a, Index b) {
    return std::abs(static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b));
  };
  return {static_cast<int>(c.topology),
          100 * distance(c.betti.b0, c.expected.b0) + distance(c.betti.b1, c.expected.b1) +
              10 * static_cast<std::int64_t>(c.betti.b2),
          c.interior_vertices};
}

/// The interior of `recovered`, certified: where the winding number is positive. Unless that is
/// proven to be the solid that the surface promised, pockets are filled, crumbs dropped and buried
/// vertices exposed, and with `lift_overlaps` overlaps are resolved into two copies if that brings
/// the Betti numbers nearer to `expected`.
inline InteriorTetrahedra choose_interior(const RecoveredMesh& recovered,
                                          const OrderedSurface& ordered,
                                          const TriangleSurface& input,
                                          const BettiNumbers& expected, bool lift_overlaps,
                                          unsigned threads) {
  using namespace choice_detail;
  const TetrahedralMesh& mesh = recovered.mesh;
  Evidence evidence{recovered, ordered, input, expected, {}, false, threads};
  parallel_beside(
      threads, [&] { evidence.winding = flood_winding_numbers(mesh, recovered.surface, threads); },
      [&] { evidence.embedded = is_triangulated_box(mesh, kBoxFaces); });
  std::vector<char> inside = inside_marks(evidence);
  OverlapColours none;
  none.lifted.assign(inside.size(), 0);
  InteriorTetrahedra best =
      certified(extract_lifted(mesh, inside, none), evidence, evidence.embedded);
  if (best.certificate.topology == TopologyVerdict::kProven) return best;
  fill_pockets(mesh, inside);
  InteriorTetrahedra tidy = cleaned(extract_lifted(mesh, inside, none), evidence);
  if (shortfall(tidy) <= shortfall(best) || best.certificate.interior_vertices != 0) {
    best = std::move(tidy);
  }
  if (!lift_overlaps || !is_consistent(evidence.winding)) return best;
  const OverlapColours colours = colour_overlaps(mesh, recovered.surface, evidence.winding);
  if (colours.regions == 0) return best;
  InteriorTetrahedra lifted = cleaned(extract_lifted(mesh, inside, colours), evidence);
  if (shortfall(lifted) < shortfall(best)) best = std::move(lifted);
  return best;
}

}  // namespace mgf
