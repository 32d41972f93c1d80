// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/reporting.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

using parameters::SegmentationQuality;

/// One value per face of the working copy.
std::vector<double> chosen_values(const Segmentation& segmentation, SegmentationQuality quality) {
  if (quality == SegmentationQuality::kEccentricity) return segmentation.eccentricity;
  if (quality == SegmentationQuality::kConfidence) return segmentation.confidence;
  return {segmentation.tubular.begin(), segmentation.tubular.end()};
}

Legend legend_of(const std::vector<double>& values, SegmentationQuality quality) {
  if (quality == SegmentationQuality::kEccentricity) return make_legend("eccentricity", values);
  if (quality == SegmentationQuality::kConfidence) {
    return {{0.0, 1.0}, "Colours: confidence, blue 0, green 0.5, red 1."};
  }
  return {{}, "Colours: blue tubular (quality 1), white flat (quality 0)."};
}

Paint label_paint(const TriangleSurface& mesh, const WorkingCopy& working,
                  const Segmentation& segmentation, SegmentationQuality quality,
                  std::string& sentence) {
  const std::vector<double> values = chosen_values(segmentation, quality);
  const Legend legend = legend_of(values, quality);
  sentence = legend.sentence;
  const bool labelled = segmentation.unlabelled_faces == 0;
  Paint paint;
  for (const Index f : faces_speaking_for(mesh, working)) {
    paint.face_quality.push_back(f == kNone ? 0.0 : values[f]);
    if (f == kNone || !labelled) {
      paint.face_colour.push_back(io::kUnlabelledColour);
    } else if (quality == SegmentationQuality::kLabel) {
      paint.face_colour.push_back(values[f] != 0.0 ? io::kTubularColour : io::kFlatColour);
    } else {
      paint.face_colour.push_back(legend.scale(values[f]));
    }
  }
  return paint;
}

FilterOutput segment_mesh(const FilterInput& input) {
  using namespace parameters;
  const double threshold = input.values.number(eccentricity_threshold());
  const Study study =
      input.workbench.study(input.mesh, {medial_axis_options(input.values, input.mesh), {}, {}},
                            Stage::kHierarchy, input.progress);
  const SkeletonLevel level = skeleton_level(study.result->hierarchy, input.values.number(theta()),
                                             input.values.number(prune()));
  const SurfaceAnalysis analysis = analyse_surface(study, level, threshold);

  FilterOutput output;
  std::string sentence;
  output.paint = label_paint(
      input.mesh, study.axis->working, analysis.segmentation,
      static_cast<SegmentationQuality>(input.values.count(segmentation_quality())), sentence);
  output.notes.push_back(sentence);
  const Legend circles = make_legend("eccentricity", analysis.circles.eccentricity);
  output.layers.push_back(circle_layer("geodesic circles", analysis.circles, circles));
  report_medial_axis(*study.axis, output);
  report_skeleton(*study.result, level, output);
  report_segmentation(analysis.segmentation, output);
  report_branches(analysis.graph, output);
  return output;
}

}  // namespace

Filter segmentation_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Tubular and Flat Segmentation (Geodesic Circles)";
  filter.python_name = "compute_scalar_by_tubular_and_flat_segmentation_per_face";
  filter.effect = FilterEffect::kPaintsAndAddsLayers;
  filter.parameters =
      with_input_parameters({eccentricity_threshold(), segmentation_quality(), theta(), prune()});
  filter.help =
      std::string(
          "Cuts the surface into <b>tubular</b> and <b>flat</b> regions. Around each edge of the "
          "curve skeleton runs a geodesic circle, the shortest closed curve through its three "
          "contact points. Its length over that of the plain circle through them is the "
          "eccentricity: 1 for a round limb, 1.27 for a square bar, 1.91 for a 2:1 bar. A face is "
          "tubular when most of the circles through it, or those nearest to it, are below the "
          "threshold.<br>"
          "Face quality is 1 for tubular and 0 for flat (or the eccentricity, or the confidence), "
          "with blue and white as colours. The geodesic circles become a layer.") +
      kRequirement + kReference;
  filter.run = segment_mesh;
  return filter;
}

}  // namespace mgf::plugin
