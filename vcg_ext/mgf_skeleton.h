// SPDX-License-Identifier: GPL-3.0-or-later
// The whole story: from a closed surface to its medial axis, medial geodesic function and curve
// skeleton (Dey & Sun 2006). Each function is a stage; each takes the results before it and changes
// none of them. What is made from a skeleton (branches, smoothing, circles, segmentation, parts) is
// in skeleton/ and surface/.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/input/diagnosis.h"
#include "vcg_ext/input/point_insertion.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/input/sampling.h"
#include "vcg_ext/input/working_copy.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/medial/placement.h"
#include "vcg_ext/medial/recover_interior.h"
#include "vcg_ext/skeleton/skeleton_hierarchy.h"

namespace mgf {

/// Seconds of wall time that a stage took.
struct StageTime {
  std::string stage;  ///< snake_case
  double seconds = 0.0;
};
using StageTimes = std::vector<StageTime>;

/// How the input is prepared and its medial axis made.
struct MedialAxisOptions {
  DiagnosisOptions diagnosis;
  SamplingOptions sampling;
  RecoveryOptions recovery;
};

/// The medial axis with everything it stands on.
struct MedialAxis {
  Diagnosis diagnosis;     ///< of the user's mesh
  WorkingCopy working;     ///< that mesh repaired, with the way back to its numbering
  RefinedSurface surface;  ///< `working` with all added points on it: what geodesics run on
  InteriorTetrahedra interior;
  MedialComplex complex;
  Index samples_added = 0;  ///< vertices of `surface` that are none of `working`
  Warnings warnings;
  StageTimes times;
};

/// The MGF with its time.
struct MedialGeodesicFunction {
  MedialGeodesicField field;
  StageTimes times;
};

/// The skeleton at every theta, with what there is to say about it.
struct CurveSkeletonResult {
  SkeletonHierarchy hierarchy;
  Warnings warnings;
  StageTimes times;
};

namespace detail {

/// Measures the stages of one function.
class StageClock {
 public:
  /// The seconds since the last call (or since construction) belong to `stage`.
  void finish(const char* stage, StageTimes& times) {
    const auto now = Clock::now();
    times.push_back({stage, std::chrono::duration<double>(now - start_).count()});
    start_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

inline std::string to_text(const BettiNumbers& betti) {
  return std::to_string(betti.b0) + "/" + std::to_string(betti.b1) + "/" + std::to_string(betti.b2);
}

inline void warn_of_topology(const TopologyCertificate& certificate, Warnings& warnings) {
  const std::string numbers = "The interior has Betti numbers " + to_text(certificate.betti) +
                              ", the surface's genus asks for " + to_text(certificate.expected) +
                              ".";
  if (certificate.topology == TopologyVerdict::kFailed) {
    warnings.push_back(
        {"topology_failed", "The skeleton does not have the topology of the surface. " + numbers +
                                " Remove self-intersections or remesh."});
  } else if (certificate.topology == TopologyVerdict::kCounted) {
    warnings.push_back(
        {"topology_counted", "The topology agrees by count but is not proven. " + numbers});
  }
}

/// Treats as displaced the Voronoi vertices that lie outside T because flips have put T' there.
/// Only tetrahedra at faces of T' that are none of T can hold such a vertex's centroid.
inline void discard_vertices_outside(const SurfaceTree& tree, const TriangleSurface& surface,
                                     const InteriorTetrahedra& interior, MedialComplex& complex) {
  const PairTable edges = surface_edges(surface.triangles);
  for (Index t = 0; t < interior.tetrahedra.size(); ++t) {
    const Tetrahedron& corners = interior.tetrahedra[t];
    for (std::size_t i = 0; i < 4; ++i) {
      if (interior.neighbours[t][i] != kNone) continue;
      const Index a = corners[(i + 1) % 4];
      const Index b = corners[(i + 2) % 4];
      const Index c = corners[(i + 3) % 4];
      const bool of_input =
          edges.find(a, b) != kNone && edges.find(b, c) != kNone && edges.find(c, a) != kNone;
      if (of_input) continue;
      if (!tree.inside(complex.position[t]) || !tree.inside(tetrahedron_centroid(interior, t))) {
        complex.displaced[t] = 1;
      }
    }
  }
}

/// The region of positive winding number of a surface.
inline ShapeInterior shape_interior(const SurfaceTree& tree, bool self_intersecting) {
  const auto stays_inside = [&tree, self_intersecting](const Vec3& a, const Vec3& b) {
    if (a == b || !tree.segment_meets(a, b)) return true;
    if (!self_intersecting) return false;
    // The segment may pass through a sheet that lies inside the shape: look on both sides of it.
    constexpr int kSamples = 16;
    for (int i = 0; i <= kSamples; ++i) {
      if (!tree.inside(a + (b - a) * (static_cast<double>(i) / kSamples))) return false;
    }
    return true;
  };
  return {[&tree](const Vec3& point) { return tree.inside(point); }, stays_inside};
}

}  // namespace detail

/// Whether the diagnosis has a finding of that code.
inline bool has_finding(const Diagnosis& diagnosis, const std::string& code) {
  for (const Finding& finding : diagnosis.findings) {
    if (finding.code == code) return true;
  }
  return false;
}

/// Stage 1 (paper, section 5.1): the medial complex of a closed surface.
/// Throws `InputError` for a mesh that can't be served, with the diagnosis as its message.
inline MedialAxis compute_medial_axis(const TriangleSurface& input,
                                      const MedialAxisOptions& options = {},
                                      const Progress& progress = {}) {
  MedialAxis axis;
  detail::StageClock clock;
  progress.report(0.0, "Checking the mesh");
  axis.diagnosis = diagnose(input, options.diagnosis);
  axis.working = prepare(input, axis.diagnosis, options.diagnosis);
  axis.warnings = axis.working.warnings;
  clock.finish("check", axis.times);

  const RefinedSurface sampled =
      refine_sampling(axis.working.surface, options.sampling, progress.slice(0.15, 0.3));
  clock.finish("sampling", axis.times);

  axis.interior = recover_interior(sampled.surface, options.recovery, progress.slice(0.3, 0.9));
  clock.finish("topology", axis.times);

  progress.report(0.9, "Medial complex");
  const std::vector<Vec3> added(
      axis.interior.points.begin() + static_cast<std::ptrdiff_t>(axis.interior.input_points),
      axis.interior.points.end());
  axis.surface = added.empty() ? sampled : insert_points(sampled, added);
  axis.samples_added = to_index(axis.surface.surface.points.size()) - axis.surface.input_points;
  axis.complex = build_medial_complex(axis.interior);
  place_voronoi_vertices(axis.interior, axis.complex);
  const SurfaceTree tree(axis.working.surface);
  detail::discard_vertices_outside(tree, axis.surface.surface, axis.interior, axis.complex);
  detail::warn_of_topology(axis.interior.certificate, axis.warnings);
  clock.finish("medial_complex", axis.times);
  progress.report(1.0, "Medial complex");
  return axis;
}

/// Stage 2 (paper, section 5.2): the MGF and its gradient on the facets of the medial axis.
inline MedialGeodesicFunction compute_medial_geodesic_function(const MedialAxis& axis,
                                                               const GeodesicOptions& options = {},
                                                               const Progress& progress = {}) {
  MedialGeodesicFunction result;
  detail::StageClock clock;
  result.field =
      evaluate_medial_geodesic_function(axis.surface.surface, axis.complex, options, progress);
  clock.finish("medial_geodesic_function", result.times);
  return result;
}

/// Stage 3 (paper, sections 5.3 to 5.5): marking and erosion, the skeleton at every theta.
inline CurveSkeletonResult compute_skeleton_hierarchy(const MedialAxis& axis,
                                                      const MedialGeodesicField& field,
                                                      const SkeletonOptions& options = {},
                                                      const Progress& progress = {}) {
  CurveSkeletonResult result;
  detail::StageClock clock;
  progress.report(0.0, "Erosion");
  const SurfaceTree tree(axis.working.surface);
  const bool self_intersecting = has_finding(axis.diagnosis, "self_intersections");
  result.hierarchy =
      build_skeleton_hierarchy(axis.interior, axis.complex, field, axis.surface.surface.points,
                               bounding_box_diagonal(axis.interior.points), options,
                               detail::shape_interior(tree, self_intersecting));
  clock.finish("skeleton", result.times);

  const SkeletonHierarchy& hierarchy = result.hierarchy;
  if (hierarchy.residual_facets > 0) {
    result.warnings.push_back(
        {"closed_pocket", "The medial axis contains a closed surface that no erosion can open; " +
                              std::to_string(hierarchy.residual_facets) +
                              " facets are left. The curves around it are delivered; ask for "
                              "pockets to be opened to get curves only."});
  }
  if (hierarchy.pockets_opened > 0) {
    result.warnings.push_back(
        {"pocket_opened", std::to_string(hierarchy.pockets_opened) +
                              " facets of closed pockets were opened: the skeleton's Betti numbers "
                              "are now " +
                              detail::to_text(hierarchy.betti) + ", the interior's are " +
                              detail::to_text(axis.interior.certificate.betti) + "."});
  }
  progress.report(1.0, "Erosion");
  return result;
}

}  // namespace mgf
