// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"

namespace mgf::plugin::parameters {
namespace {

Parameter as_slider(Parameter parameter) {
  parameter.kind = ParameterKind::kSlider;
  return parameter;
}

}  // namespace

const Parameter& theta() {
  static const Parameter parameter{
      "theta",
      ParameterKind::kNumber,
      SkeletonOptions{}.theta,
      -1.1,
      0.0,
      {},
      "Divergence threshold",
      "How sharply the gradient of the medial geodesic function must leave a Voronoi edge for the "
      "edge to be in the skeleton. Smaller gives less detail; below -1 only loops remain."};
  return parameter;
}

const Parameter& theta_slider() {
  static const Parameter parameter = as_slider(theta());
  return parameter;
}

const Parameter& prune() {
  static const Parameter parameter{
      "prune",
      ParameterKind::kNumber,
      SkeletonOptions{}.prune,
      0.0,
      10.0,
      {},
      "Pruning",
      "A branch that ends freely is dropped when it reaches out of the body it grows from by less "
      "than this many of the body's radii, or ends within three edges of the mesh. 0 keeps every "
      "branch, as in the paper."};
  return parameter;
}

const Parameter& prune_slider() {
  static const Parameter parameter = [] {
    Parameter slider = as_slider(prune());
    slider.high = 3.0;
    return slider;
  }();
  return parameter;
}

const Parameter& eccentricity_threshold() {
  static const Parameter parameter{
      "eccentricityThreshold",
      ParameterKind::kNumber,
      1.3,
      0.5,
      20.0,
      {},
      "Eccentricity threshold",
      "A cross-section is tubular when its geodesic circle is at most this many times as long as "
      "the circle through the contact points. Round: 1.00, square: 1.27, a 2:1 bar: 1.91."};
  return parameter;
}

const Parameter& skeleton_quality() {
  static const Parameter parameter{
      "quality", ParameterKind::kChoice,
      0,         0,
      3,         {"Eccentricity", "Medial geodesic function", "Radius", "Branch"},
      "Quality", "What is stored as quality and shown as colour on the skeleton."};
  return parameter;
}

const Parameter& segmentation_quality() {
  static const Parameter parameter{
      "quality",
      ParameterKind::kChoice,
      0,
      0,
      2,
      {"Label", "Eccentricity", "Confidence"},
      "Quality",
      "What is stored as face quality and shown as colour: the label (1 tubular, 0 flat), the "
      "eccentricity itself, or the confidence in the label."};
  return parameter;
}

const Parameter& marking_rule() {
  static const Parameter parameter{
      "markingRule",
      ParameterKind::kChoice,
      static_cast<double>(SkeletonOptions{}.marking_rule),
      0,
      1,
      {"Every qualifying edge", "One edge per facet"},
      "Marking rule",
      "Which of the Voronoi edges below the threshold are marked. The paper marks at most one per "
      "facet; marking all gives a smoother curve with fewer spurs."};
  return parameter;
}

const Parameter& open_pockets() {
  static const Parameter parameter{
      "openPockets",
      ParameterKind::kSwitch,
      SkeletonOptions{}.open_pockets ? 1.0 : 0.0,
      0,
      1,
      {},
      "Open closed pockets",
      "Where the medial axis encloses a void, which no collapse can reach, cut it open at its "
      "lowest medial geodesic function, so that the result is a curve. This changes its topology."};
  return parameter;
}

const Parameter& sampling_density() {
  static const Parameter parameter{
      "samplingDensity",
      ParameterKind::kChoice,
      0,
      0,
      2,
      {"Automatic", "Fixed length", "Off"},
      "Sampling",
      "Where points are added on the surface before the medial axis is computed. Automatic: where "
      "it is too coarse for its thickness. Fixed length: no edge longer than the length below. "
      "Off: nowhere."};
  return parameter;
}

const Parameter& sampling_length() {
  static const Parameter parameter{
      "samplingLength",
      ParameterKind::kLength,
      0.02,
      0.002,
      1.0,
      {},
      "Sampling length",
      "Longest edge of the sampled surface. Used only when the sampling is of fixed length."};
  return parameter;
}

const Parameter& ignore_cavities() {
  static const Parameter parameter{
      "ignoreCavities",
      ParameterKind::kSwitch,
      DiagnosisOptions{}.ignore_cavities ? 1.0 : 0.0,
      0,
      1,
      {},
      "Ignore cavities",
      "Leave out shells that lie inside another. Without it a mesh with a cavity is refused: its "
      "medial axis encloses the cavity and has no curve skeleton."};
  return parameter;
}

const Parameter& lift_overlaps() {
  static const Parameter parameter{
      "liftOverlaps",
      ParameterKind::kSwitch,
      RecoveryOptions{}.lift_overlaps ? 1.0 : 0.0,
      0,
      1,
      {},
      "Lift overlaps",
      "Where parts of the surface pass through each other, treat them as apart, so that no "
      "junction appears where they only overlap."};
  return parameter;
}

const Parameter& threads() {
  static const Parameter parameter{
      "threads", ParameterKind::kCount,
      0,         0,
      1024,      {},
      "Threads", "How many threads to use; 0 uses all. The result is the same for any number."};
  return parameter;
}

const Parameter& output_folder() {
  static const Parameter parameter{
      "outputFolder",
      ParameterKind::kText,
      0,
      0,
      0,
      {},
      "Output folder",
      "Folder for the files; made if it does not exist. Files of an earlier run are replaced."};
  return parameter;
}

const Parameter& coordinates_file() {
  static const Parameter parameter{
      "coordinatesFile",
      ParameterKind::kText,
      0,
      0,
      0,
      {},
      "Coordinates file",
      "Optional PLY or OFF file of the same mesh with coordinates in double precision, which the "
      "layer has lost. It is used when it agrees with the layer to single precision."};
  return parameter;
}

std::vector<Parameter> with_input_parameters(std::vector<Parameter> own) {
  for (const auto& common : {sampling_density, sampling_length, ignore_cavities, lift_overlaps}) {
    own.push_back(common());
  }
  return own;
}

MedialAxisOptions medial_axis_options(const ParameterValues& values, const TriangleSurface& mesh) {
  MedialAxisOptions options;
  switch (static_cast<Sampling>(values.count(sampling_density()))) {
    case Sampling::kAutomatic:
      options.sampling.length.reset();
      break;
    case Sampling::kFixed:
      check_range(sampling_length(), values.number(sampling_length()),
                  bounding_box_diagonal(mesh.points));
      options.sampling.length = values.number(sampling_length());
      break;
    case Sampling::kOff:
      options.sampling.length = 0.0;
      break;
  }
  options.diagnosis.ignore_cavities = values.yes(ignore_cavities());
  options.recovery.lift_overlaps = values.yes(lift_overlaps());
  return options;
}

SkeletonOptions skeleton_options(const ParameterValues& values) {
  SkeletonOptions options;
  options.theta = values.number(theta());
  options.prune = values.number(prune());
  options.marking_rule = static_cast<MarkingRule>(values.count(marking_rule()));
  options.open_pockets = values.yes(open_pockets());
  return options;
}

}  // namespace mgf::plugin::parameters
