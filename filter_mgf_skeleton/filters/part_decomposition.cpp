// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/reporting.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

/// Branch as quality of faces and vertices; -1 where there is none.
Paint part_paint(const TriangleSurface& mesh, const WorkingCopy& working,
                 const SurfaceAnalysis& analysis) {
  const std::vector<Colour> colours = io::branch_colours(analysis.graph);
  const std::vector<Index>& branch_of_face = analysis.map.faces.branch;
  const std::vector<Index>& branch_of_vertex = analysis.map.vertices.branch;
  const auto number = [](Index branch) { return branch == kNone ? -1.0 : double{1.0} * branch; };
  Paint paint;
  for (const Index f : faces_speaking_for(mesh, working)) {
    const Index branch = f == kNone ? kNone : branch_of_face[f];
    paint.face_quality.push_back(number(branch));
    paint.face_colour.push_back(branch == kNone ? io::kUnlabelledColour : colours[branch]);
  }
  for (const Index v : working.vertex_of_input) {
    paint.point_quality.push_back(number(v == kNone ? kNone : branch_of_vertex[v]));
  }
  return paint;
}

FilterOutput decompose_into_parts(const FilterInput& input) {
  using namespace parameters;
  const Study study =
      input.workbench.study(input.mesh, {medial_axis_options(input.values, input.mesh), {}, {}},
                            Stage::kHierarchy, input.progress);
  const SkeletonLevel level = skeleton_level(study.result->hierarchy, input.values.number(theta()),
                                             input.values.number(prune()));
  const SurfaceAnalysis analysis =
      analyse_surface(study, level, input.values.number(eccentricity_threshold()));
  FilterOutput output;
  output.paint = part_paint(input.mesh, study.axis->working, analysis);
  output.notes.emplace_back("Colours: one per branch; quality is the branch's number.");
  report_branches(analysis.graph, output);
  report_medial_axis(*study.axis, output);
  report_skeleton(*study.result, level, output);
  return output;
}

}  // namespace

Filter part_decomposition_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Part Decomposition by Curve Skeleton";
  filter.python_name = "compute_scalar_by_curve_skeleton_branch_per_face";
  filter.effect = FilterEffect::kPaintsInput;
  filter.parameters = with_input_parameters({theta(), prune(), eccentricity_threshold()});
  filter.help =
      std::string(
          "Cuts the surface into its <b>parts</b>, one for each branch of the curve skeleton: "
          "fingers and palm, legs, ears. Borders run along geodesic circles. The number of the "
          "branch becomes face and vertex quality, with a colour for each part, different from "
          "its neighbours'.<br>"
          "The log lists the branches with length, radius, girth, eccentricity and share of the "
          "area; branches are numbered by falling length.") +
      kRequirement + kReference;
  filter.run = decompose_into_parts;
  return filter;
}

}  // namespace mgf::plugin
