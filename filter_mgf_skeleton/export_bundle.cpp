// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/export_bundle.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "filter_mgf_skeleton/io/branches_csv.h"
#include "filter_mgf_skeleton/io/circles_file.h"
#include "filter_mgf_skeleton/io/graphml_file.h"
#include "filter_mgf_skeleton/io/medial_axis_file.h"
#include "filter_mgf_skeleton/io/skeleton_file.h"
#include "filter_mgf_skeleton/io/surface_files.h"
#include "filter_mgf_skeleton/io/swc_file.h"
#include "filter_mgf_skeleton/io/tubes_file.h"
#include "filter_mgf_skeleton/io/vtp_file.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

constexpr std::array kFiles{"medial_axis.ply", "skeleton.ply",     "skeleton_smooth.ply",
                            "skeleton.swc",    "skeleton.graphml", "skeleton.vtp",
                            "branches.csv",    "circles.ply",      "segmentation.ply",
                            "parts.ply",       "tubes.ply"};

/// `values` of the faces that speak for the user's, `missing` where none does.
template <class T>
std::vector<T> spread(const std::vector<T>& values, const std::vector<Index>& speaking, T missing) {
  std::vector<T> result;
  result.reserve(speaking.size());
  for (const Index f : speaking) result.push_back(f == kNone ? missing : values[f]);
  return result;
}

Segmentation on_user_faces(const Segmentation& segmentation, const std::vector<Index>& speaking) {
  Segmentation result = segmentation;
  result.tubular = spread(segmentation.tubular, speaking, char{0});
  result.eccentricity = spread(segmentation.eccentricity, speaking, 0.0);
  result.confidence = spread(segmentation.confidence, speaking, 0.0);
  return result;
}

SkeletonCorrespondence on_user_faces(const SkeletonCorrespondence& faces,
                                     const std::vector<Index>& speaking) {
  return {spread(faces.branch, speaking, kNone), spread(faces.edge, speaking, kNone),
          spread(faces.arc_length, speaking, 0.0), spread(faces.distance, speaking, 0.0),
          spread(faces.girth, speaking, 0.0)};
}

void write_skeleton_files(const std::filesystem::path& folder, const ExportBundle& bundle) {
  const CurveSkeleton& skeleton = bundle.level.skeleton;
  const BranchGraph& graph = bundle.analysis.graph;
  io::write_skeleton(folder / "skeleton.ply", skeleton, graph);
  io::write_skeleton_smooth(folder / "skeleton_smooth.ply", bundle.smooth, graph);
  io::write_swc(folder / "skeleton.swc", skeleton, graph);
  io::write_graphml(folder / "skeleton.graphml", skeleton, graph);
  io::write_vtp(folder / "skeleton.vtp", skeleton, graph);
  io::write_branches_csv(folder / "branches.csv", graph);
}

// `mesh` with numbers only: the diagnosis asks for them at the vertices in use, files at all.
TriangleSurface with_numbers_only(const TriangleSurface& mesh) {
  TriangleSurface result = mesh;
  for (Vec3& point : result.points) {
    if (!point.allFinite()) point.setZero();
  }
  return result;
}

void write_surface_files(const std::filesystem::path& folder, const ExportBundle& bundle) {
  const TriangleSurface mesh = with_numbers_only(bundle.mesh);
  const std::vector<Index> speaking = faces_speaking_for(bundle.mesh, bundle.study.axis->working);
  io::write_circles(folder / "circles.ply", bundle.analysis.circles);
  io::write_segmentation(folder / "segmentation.ply", mesh,
                         on_user_faces(bundle.analysis.segmentation, speaking));
  io::write_parts(folder / "parts.ply", mesh, on_user_faces(bundle.analysis.map.faces, speaking),
                  bundle.analysis.graph);
}

void write_tubes_file(const std::filesystem::path& folder, const ExportBundle& bundle) {
  constexpr auto kQuality = parameters::SkeletonQuality::kEccentricity;
  const SkeletonPaint paint =
      paint_smooth(bundle.smooth, paint_skeleton(bundle.level, kQuality), kQuality);
  const std::vector<io::TubePath> paths =
      io::tube_paths(bundle.smooth, build_branches(bundle.smooth), paint.of_edge, 0.0);
  io::write_tubes(folder / "tubes.ply",
                  io::make_tubes(paths, io::default_tube_radius(bundle.smooth)),
                  paint.legend.scale);
}

io::SkeletonReport skeleton_report(const ExportBundle& bundle) {
  const auto count = [&](NodeKind kind) {
    const auto& kinds = bundle.level.graph.node_kind;
    return static_cast<Index>(std::count(kinds.begin(), kinds.end(), kind));
  };
  const BettiNumbers betti = betti_numbers(bundle.level.skeleton);
  io::SkeletonReport report;
  report.nodes = to_index(bundle.level.skeleton.node_count());
  report.edges = to_index(bundle.level.skeleton.edge_count());
  report.b0 = betti.b0;
  report.b1 = betti.b1;
  report.leaves = count(NodeKind::kTip);
  report.junctions = count(NodeKind::kJunction);
  report.residual_facets = bundle.study.result->hierarchy.residual_facets;
  report.outside_edges = count_outside_edges(bundle.level.skeleton);
  return report;
}

}  // namespace

void write_bundle(const std::filesystem::path& folder, const ExportBundle& bundle) {
  const MedialAxis& axis = *bundle.study.axis;
  const MedialGeodesicField& field = bundle.study.function->field;
  const io::VertexNumbers numbers{axis.working.input_of_vertex,
                                  to_index(bundle.mesh.points.size())};
  io::write_medial_axis(folder / "medial_axis.ply", axis.complex, field.mgf, field.gradient,
                        numbers);
  write_skeleton_files(folder, bundle);
  write_surface_files(folder, bundle);
  write_tubes_file(folder, bundle);
}

void remove_bundle(const std::filesystem::path& folder) {
  for (const char* name : kFiles) {
    std::error_code absent;  // the file need not be there
    std::filesystem::remove(folder / name, absent);
  }
}

io::Report report_of(const ExportBundle& bundle) {
  const MedialAxis& axis = *bundle.study.axis;
  const MedialGeodesicFunction& function = *bundle.study.function;
  const std::vector<Certification>& proofs = function.field.geodesics.certification;
  io::Report report;
  report.input = {{},
                  to_index(bundle.mesh.points.size()),
                  to_index(bundle.mesh.triangles.size()),
                  axis.working.solids,
                  axis.working.genus};
  const Untangling& untangling = axis.working.untangling;
  report.crossings = io::CrossingsReport{untangling.pairs_mended, untangling.left.size(),
                                         untangling.moved.size(), untangling.largest_move};
  report.medial_axis =
      io::MedialAxisReport{axis.samples_added, to_index(axis.complex.vertex_count()),
                           to_index(axis.complex.edge_count()),
                           to_index(axis.complex.facet_count()), axis.interior.certificate.betti};
  report.certificate = axis.interior.certificate;
  Index certified = 0;
  for (const VertexPair& contacts : axis.complex.facet_contacts) {
    const Index pair = function.field.table.find(contacts.a, contacts.b);
    if (proofs[pair] == Certification::kProven) ++certified;
  }
  report.mgf = io::MgfReport{to_index(axis.complex.facet_count()), certified};
  report.skeleton = skeleton_report(bundle);
  report.branches = bundle.analysis.graph;
  report.segmentation = io::SegmentationReport{0.0, bundle.analysis.segmentation.tubular_area_share,
                                               bundle.analysis.segmentation.unlabelled_faces};
  for (const StageTimes& times : {axis.times, function.times, bundle.study.result->times}) {
    for (const StageTime& time : times) report.stages.push_back({time.stage, time.seconds});
  }
  for (const Warnings& warnings :
       {axis.warnings, bundle.study.result->warnings, warnings_of(bundle.level)}) {
    report.warnings.insert(report.warnings.end(), warnings.begin(), warnings.end());
  }
  return report;
}

}  // namespace mgf::plugin
