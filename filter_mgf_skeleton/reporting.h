// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the library's results, as the log and a host's script see them.
#pragma once

#include "filter_mgf_skeleton/analysis.h"
#include "filter_mgf_skeleton/layer.h"

namespace mgf::plugin {

/// Each appends the numbers and warnings of one result.
void report_medial_axis(const MedialAxis& axis, FilterOutput& output);
void report_medial_geodesic_function(const MedialGeodesicField& field, FilterOutput& output);
void report_skeleton(const CurveSkeletonResult& result, const SkeletonLevel& level,
                     FilterOutput& output);
void report_smooth(const SmoothSkeleton& smooth, FilterOutput& output);
void report_segmentation(const Segmentation& segmentation, FilterOutput& output);

/// One line per branch.
void report_branches(const BranchGraph& graph, FilterOutput& output);

/// A sentence on how far the topology is known to be right.
std::string sentence_on_topology(const TopologyCertificate& certificate);

}  // namespace mgf::plugin
