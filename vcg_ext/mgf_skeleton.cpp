// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mgf_skeleton.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/exact/delaunay_ahead.h"
#include "vcg_ext/input/point_insertion.h"
#include "vcg_ext/medial/boxed_surface.h"
#include "vcg_ext/medial/face_lookup.h"
#include "vcg_ext/medial/placement.h"

namespace mgf {
namespace {

// Measures the stages of one function.
class StageClock {
 public:
  // The seconds since the last call (or since construction) belong to `stage`.
  void finish(const char* stage, StageTimes& times) {
    const auto now = Clock::now();
    times.push_back({stage, std::chrono::duration<double>(now - start_).count()});
    start_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

std::string to_text(const BettiNumbers& betti) {
  return std::to_string(betti.b0) + "/" + std::to_string(betti.b1) + "/" + std::to_string(betti.b2);
}

void warn_of_topology(const TopologyCertificate& certificate, Warnings& warnings) {
  const std::string numbers = "The interior has Betti numbers " + to_text(certificate.betti) +
                              ", the surface's genus asks for " + to_text(certificate.expected) +
                              ".";
  if (certificate.gave_up) {
    warnings.push_back(
        {"recovery_gave_up",
         "The surface could not be made part of the tetrahedra within the bounds on work, so that "
         "inside and outside were told by winding numbers. Remesh it to triangles that are less "
         "long, as with 'Remeshing: Isotropic Explicit Remeshing'. In the library, the recovery's "
         "effort can be raised."});
  }
  if (certificate.topology == TopologyVerdict::kFailed) {
    warnings.push_back(
        {"topology_failed", "The skeleton does not have the topology of the surface. " + numbers +
                                " Remove self-intersections or remesh."});
  } else if (certificate.topology == TopologyVerdict::kCounted) {
    warnings.push_back(
        {"topology_counted", "The topology agrees by count but is not proven. " + numbers});
  }
}

// Treats as displaced the Voronoi vertices that lie outside T because flips have put T' there.
// Only tetrahedra at faces of T' that are none of T can hold such a vertex's centroid.
void discard_vertices_outside(const SurfaceTree& tree, const TriangleSurface& surface,
                              const InteriorTetrahedra& interior, unsigned threads,
                              MedialComplex& complex) {
  constexpr std::size_t kChunk = 512;
  const FaceLookup lookup(surface.triangles, surface.points.size());
  const auto has_new_face = [&](Index t) {
    for (unsigned i = 0; i < 4; ++i) {
      if (interior.neighbours[t][i] != kNone) continue;
      if (!lookup.has(face_of(interior.tetrahedra[t], i))) return true;
    }
    return false;
  };
  parallel_for(interior.tetrahedra.size(), threads, kChunk, [&](std::size_t i, unsigned) {
    const Index t = to_index(i);
    if (!has_new_face(t)) return;
    if (!tree.inside(complex.position[t]) || !tree.inside(tetrahedron_centroid(interior, t))) {
      complex.displaced[t] = 1;
    }
  });
}

}  // namespace

ShapeInterior shape_interior(const SurfaceTree& tree, bool self_intersecting) {
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

MedialAxis compute_medial_axis(const TriangleSurface& input, const MedialAxisOptions& options,
                               const Progress& progress) {
  MedialAxis axis;
  StageClock clock;
  progress.report(0.0, "Checking the mesh");
  // Few meshes need repair or sampling, so the tetrahedra are begun beside the check.
  const unsigned threads = thread_count(options.recovery.threads);
  std::optional<DelaunayAhead> ahead;
  if (threads > 1) {
    ahead.emplace([&input] {
      return has_usable_points(input) ? boxed_vertices(input) : std::vector<Vec3>();
    });
  }
  axis.diagnosis = diagnose(input, options.diagnosis, [&ahead] {
    if (ahead) ahead->stop();  // as parting them moves vertices
  });
  axis.working = prepare(input, axis.diagnosis, options.preparation);
  axis.warnings = axis.working.warnings;
  clock.finish("check", axis.times);

  // The diagnosis has found out whether automatic sampling has anything to do.
  const bool dense = !options.sampling.length && axis.diagnosis.find("too_coarse") == nullptr;
  RefinedSurface sampled =
      dense ? unrefined(axis.working.surface)
            : refine_sampling(axis.working.surface, options.sampling, progress.slice(0.15, 0.3));
  clock.finish("sampling", axis.times);

  RecoveryOptions recovery = options.recovery;
  recovery.known_crossings = axis.working.untangling.left.size();
  axis.interior = recover_interior(sampled.surface, recovery, progress.slice(0.3, 0.9),
                                   ahead ? &*ahead : nullptr);
  ahead.reset();
  clock.finish("topology", axis.times);

  progress.report(0.9, "Medial complex");
  const std::vector<Vec3> added(
      axis.interior.points.begin() + static_cast<std::ptrdiff_t>(axis.interior.input_points),
      axis.interior.points.end());
  axis.surface = added.empty() ? std::move(sampled) : insert_points(sampled, added);
  axis.samples_added = to_index(axis.surface.surface.points.size()) - axis.surface.input_points;
  axis.complex = build_medial_complex(axis.interior, threads, [&](MedialComplex& complex) {
    const SurfaceTree tree(axis.working.surface);
    place_voronoi_vertices(axis.interior, complex, threads);
    discard_vertices_outside(tree, axis.surface.surface, axis.interior, threads, complex);
  });
  warn_of_topology(axis.interior.certificate, axis.warnings);
  clock.finish("medial_complex", axis.times);
  progress.report(1.0, "Medial complex");
  return axis;
}

MedialGeodesicFunction compute_medial_geodesic_function(const MedialAxis& axis,
                                                        const GeodesicOptions& options,
                                                        const Progress& progress) {
  MedialGeodesicFunction result;
  StageClock clock;
  result.field =
      evaluate_medial_geodesic_function(axis.surface.surface, axis.complex, options, progress);
  clock.finish("medial_geodesic_function", result.times);
  return result;
}

CurveSkeletonResult compute_skeleton_hierarchy(const MedialAxis& axis,
                                               const MedialGeodesicField& field,
                                               const SkeletonOptions& options,
                                               const Progress& progress) {
  CurveSkeletonResult result;
  StageClock clock;
  progress.report(0.0, "Erosion");
  std::optional<SurfaceTree> tree;
  result.hierarchy =
      build_skeleton_hierarchy(axis.interior, axis.complex, field, axis.surface.surface,
                               bounding_box_diagonal(axis.interior.points), options, [&] {
                                 tree.emplace(axis.working.surface);
                                 return shape_interior(*tree, axis.working.self_intersecting());
                               });
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
                              to_text(hierarchy.betti) + ", the interior's are " +
                              to_text(axis.interior.certificate.betti) + "."});
  }
  progress.report(1.0, "Erosion");
  return result;
}

}  // namespace mgf
