// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/reporting.h"

#include <algorithm>
#include <cstdio>

namespace mgf::plugin {
namespace {

/// The log is no place for thousands of lines; files have them all.
constexpr std::size_t kBranchesListed = 40;

void add_warnings(const Warnings& warnings, FilterOutput& output) {
  output.warnings.insert(output.warnings.end(), warnings.begin(), warnings.end());
}

std::size_t count_kind(const BranchGraph& graph, NodeKind kind) {
  return static_cast<std::size_t>(std::count(graph.node_kind.begin(), graph.node_kind.end(), kind));
}

class MeasurementList {
 public:
  explicit MeasurementList(FilterOutput& output) : output_(output) {}
  template <class Number>
  void add(const char* key, const char* text, Number value) {
    output_.measures.push_back({key, text, static_cast<double>(value)});
  }

 private:
  FilterOutput& output_;
};

}  // namespace

std::string sentence_on_topology(const TopologyCertificate& certificate) {
  switch (certificate.topology) {
    case TopologyVerdict::kProven:
      return "Topology: proven to be that of the shape.";
    case TopologyVerdict::kCounted:
      return "Topology: the Betti numbers are those of the shape, without a proof of more.";
    case TopologyVerdict::kFailed:
      return "Topology: NOT that of the shape, see the warning.";
  }
  return {};
}

void report_medial_axis(const MedialAxis& axis, FilterOutput& output) {
  output.notes.push_back(sentence_on_topology(axis.interior.certificate));
  const BettiNumbers& betti = axis.interior.certificate.betti;
  MeasurementList list(output);
  list.add("components", "Solids", axis.working.solids);
  list.add("genus", "Genus", axis.working.genus);
  list.add("crossings_mended", "Pairs of crossing faces parted",
           axis.working.untangling.pairs_mended);
  list.add("crossings_left", "Pairs of crossing faces left", axis.working.untangling.left.size());
  list.add("vertices_moved", "Vertices moved for that", axis.working.untangling.moved.size());
  list.add("largest_move", "Largest such move", axis.working.untangling.largest_move);
  list.add("samples_added", "Points added on the surface", axis.samples_added);
  list.add("voronoi_vertices", "Voronoi vertices inside", axis.complex.vertex_count());
  list.add("voronoi_edges", "Voronoi edges inside", axis.complex.edge_count());
  list.add("voronoi_facets", "Voronoi facets inside", axis.complex.facet_count());
  list.add("medial_b0", "Pieces of the medial axis (b0)", betti.b0);
  list.add("medial_b1", "Loops of the medial axis (b1)", betti.b1);
  list.add("medial_b2", "Voids of the medial axis (b2)", betti.b2);
  add_warnings(axis.warnings, output);
}

void report_medial_geodesic_function(const MedialGeodesicField& field, FilterOutput& output) {
  MeasurementList list(output);
  if (!field.mgf.empty()) {
    const auto [least, most] = std::minmax_element(field.mgf.begin(), field.mgf.end());
    list.add("mgf_min", "Smallest medial geodesic function", *least);
    list.add("mgf_max", "Largest medial geodesic function", *most);
  }
  const std::vector<Certification>& proofs = field.geodesics.certification;
  list.add("geodesics", "Geodesics", proofs.size());
  list.add("geodesics_certified", "Geodesics proven shortest",
           std::count(proofs.begin(), proofs.end(), Certification::kProven));
}

void report_skeleton(const CurveSkeletonResult& result, const SkeletonLevel& level,
                     FilterOutput& output) {
  const BettiNumbers betti = betti_numbers(level.skeleton);
  double length = 0.0;
  for (const Branch& branch : level.graph.branches) length += branch.length;
  MeasurementList list(output);
  list.add("skeleton_nodes", "Skeleton nodes", level.skeleton.node_count());
  list.add("skeleton_edges", "Skeleton edges", level.skeleton.edge_count());
  list.add("skeleton_length", "Skeleton length", length);
  list.add("skeleton_b0", "Skeleton pieces (b0)", betti.b0);
  list.add("skeleton_b1", "Skeleton loops (b1)", betti.b1);
  list.add("skeleton_tips", "Skeleton tips", count_kind(level.graph, NodeKind::kTip));
  list.add("skeleton_junctions", "Skeleton junctions",
           count_kind(level.graph, NodeKind::kJunction));
  list.add("skeleton_branches", "Skeleton branches", level.graph.branches.size());
  list.add("residual_facets", "Voronoi facets left in closed pockets",
           result.hierarchy.residual_facets);
  list.add("outside_edges", "Skeleton edges that leave the shape",
           count_outside_edges(level.skeleton));
  add_warnings(result.warnings, output);
}

void report_smooth(const SmoothSkeleton& smooth, FilterOutput& output) {
  constexpr double kDegrees = 57.295779513082320877;
  MeasurementList list(output);
  list.add("smooth_turning", "Mean turning of the smooth skeleton a step, degrees",
           smooth.mean_turning * kDegrees);
  list.add("smooth_outside_edges", "Smooth skeleton edges that leave the shape",
           smooth.outside_edges);
}

void report_segmentation(const Segmentation& segmentation, FilterOutput& output) {
  MeasurementList list(output);
  list.add("tubular_area_share", "Tubular share of the area", segmentation.tubular_area_share);
  list.add("unlabelled_faces", "Faces without a label", segmentation.unlabelled_faces);
}

void report_branches(const BranchGraph& graph, FilterOutput& output) {
  const std::size_t listed = std::min(kBranchesListed, graph.branches.size());
  for (std::size_t b = 0; b < listed; ++b) {
    const Branch& branch = graph.branches[b];
    char line[256];
    std::snprintf(line, sizeof line,
                  "Branch %zu: %s, length %.4g, radius %.4g, girth %.4g, eccentricity %.3g, "
                  "%.1f %% of the area%s",
                  b, branch.tubular ? "tubular" : "flat", branch.length, branch.radius_mean,
                  branch.girth_mean, branch.eccentricity_median, 100.0 * branch.area_share,
                  branch.on_cycle ? ", on a loop" : "");
    output.notes.emplace_back(line);
  }
  if (listed < graph.branches.size()) {
    output.notes.push_back(std::to_string(graph.branches.size() - listed) +
                           " smaller branches are not listed; Export Curve Skeleton Files writes "
                           "them all.");
  }
}

}  // namespace mgf::plugin
