// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/reporting.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

FilterOutput make_curve_skeleton(const FilterInput& input) {
  using namespace parameters;
  const SkeletonOptions options = skeleton_options(input.values);
  const Study study = input.workbench.study(
      input.mesh, {medial_axis_options(input.values, input.mesh), {}, options}, Stage::kHierarchy,
      input.progress);
  const SkeletonLevel level = skeleton_level(study.result->hierarchy, options.theta, options.prune);
  const SmoothSkeleton smooth = smooth_level(study, level);

  const auto quality = static_cast<SkeletonQuality>(input.values.count(skeleton_quality()));
  const SkeletonPaint paint = paint_skeleton(level, quality);
  const SkeletonPaint smooth_paint = paint_smooth(smooth, paint, quality);
  FilterOutput output;
  output.layers.push_back(line_layer("curve skeleton", level.skeleton, paint));
  output.layers.push_back(line_layer("smooth curve skeleton", smooth, smooth_paint));
  output.layers.push_back(
      tube_layer("curve skeleton tubes", smooth, build_branches(smooth), smooth_paint));
  output.notes.push_back(paint.legend.sentence);
  output.notes.emplace_back(kHideNote);
  report_medial_axis(*study.axis, output);
  report_skeleton(*study.result, level, output);
  report_smooth(smooth, output);
  return output;
}

}  // namespace

Filter curve_skeleton_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Curve Skeleton (MGF)";
  filter.python_name = "generate_curve_skeleton_by_medial_geodesic_function";
  filter.effect = FilterEffect::kAddsLayers;
  filter.parameters =
      with_input_parameters({theta(), prune(), skeleton_quality(), marking_rule(), open_pockets()});
  filter.help =
      std::string(
          "Adds the <b>curve skeleton</b> of the solid that the mesh bounds: curves in the middle "
          "of its limbs, with the topology of the solid (as many loops as it has handles). They "
          "are where the gradient of the medial geodesic function diverges on the medial axis, "
          "joined by eroding the rest of it.<br>"
          "Three layers: the skeleton as lines, as smooth lines, and as tubes, on which colour "
          "shows the chosen quality. <i>Eccentricity</i> is 1 in round limbs and large in flat "
          "ones. <i>Curve Skeleton Level of Detail</i> changes threshold and pruning at once "
          "afterwards.") +
      kRequirement + kReference;
  filter.run = make_curve_skeleton;
  return filter;
}

}  // namespace mgf::plugin
