// SPDX-License-Identifier: GPL-3.0-or-later
// Every parameter that the filters know, described once, and the library's options read from them.
#pragma once

#include <vector>

#include "filter_mgf_skeleton/parameter.h"
#include "vcg_ext/mgf_skeleton.h"

namespace mgf::plugin::parameters {

/// Choices of `sampling_density`, by position.
enum class Sampling { kAutomatic = 0, kFixed = 1, kOff = 2 };

/// Choices of `skeleton_quality`, by position.
enum class SkeletonQuality { kEccentricity = 0, kMgf = 1, kRadius = 2, kBranch = 3 };

/// Choices of `segmentation_quality`, by position.
enum class SegmentationQuality { kLabel = 0, kEccentricity = 1, kConfidence = 2 };

const Parameter& theta();
const Parameter& theta_slider();
const Parameter& prune();
const Parameter& prune_slider();
const Parameter& eccentricity_threshold();
const Parameter& skeleton_quality();
const Parameter& segmentation_quality();
const Parameter& marking_rule();
const Parameter& open_pockets();
const Parameter& sampling_density();
const Parameter& sampling_length();
const Parameter& ignore_cavities();
const Parameter& lift_overlaps();
const Parameter& threads();
const Parameter& output_folder();
const Parameter& coordinates_file();

/// The parameters that say how the input is prepared, last in every filter that computes.
std::vector<Parameter> with_input_parameters(std::vector<Parameter> own);

/// The options for `mesh`. Throws `InputError` (parameter_out_of_range) for a sampling length that
/// is used and does not suit its size.
MedialAxisOptions medial_axis_options(const ParameterValues& values, const TriangleSurface& mesh);
SkeletonOptions skeleton_options(const ParameterValues& values);

}  // namespace mgf::plugin::parameters
