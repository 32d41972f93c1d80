// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/reporting.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

FilterOutput change_level_of_detail(const FilterInput& input) {
  using namespace parameters;
  const Study study = input.workbench.latest_study(input.mesh, input.progress);
  const SkeletonLevel level =
      skeleton_level(study.result->hierarchy, input.values.number(theta_slider()),
                     input.values.number(prune_slider()));
  const auto quality = static_cast<SkeletonQuality>(input.values.count(skeleton_quality()));
  const SkeletonPaint paint = paint_skeleton(level, quality);
  FilterOutput output;
  output.layers.push_back(line_layer("level of detail", level.skeleton, paint));
  const SmoothSkeleton smooth = smooth_level(study, level);
  output.layers.push_back(tube_layer("level of detail tubes", smooth, build_branches(smooth),
                                     paint_smooth(smooth, paint, quality)));
  for (Layer& layer : output.layers) layer.replaces_former = true;
  output.notes.push_back(paint.legend.sentence);
  report_skeleton(*study.result, level, output);
  return output;
}

}  // namespace

Filter level_of_detail_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Curve Skeleton Level of Detail";
  filter.python_name = "generate_curve_skeleton_level_of_detail";
  filter.effect = FilterEffect::kReplacesLayers;
  filter.parameters = {theta_slider(), prune_slider(), skeleton_quality()};
  filter.help =
      std::string(
          "Shows the curve skeleton at another threshold and pruning <b>without computing it "
          "again</b>: tick Preview and drag the sliders. It takes the skeleton last computed for "
          "this mesh, and computes one with the standard settings if there is none yet, or if the "
          "mesh has changed. The mesh, or a layer made from it, must be the current layer.<br>"
          "The skeleton at a smaller threshold is always part of that at a larger one; below -1 "
          "only loops are left, or a point. The result stands in two layers of its own, lines and "
          "tubes, which this filter replaces each time.") +
      kReference;
  filter.run = change_level_of_detail;
  return filter;
}

}  // namespace mgf::plugin
