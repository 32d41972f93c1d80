// SPDX-License-Identifier: GPL-3.0-or-later
// All files of one run in one folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/analysis.h"
#include "filter_mgf_skeleton/io/report.h"

namespace mgf::plugin {

/// Everything that is computed of a mesh for its files.
struct ExportBundle {
  const TriangleSurface& mesh;  ///< the user's
  Study study;
  SkeletonLevel level;
  SmoothSkeleton smooth;
  SurfaceAnalysis analysis;  ///< per face and vertex of the working copy
};

/// Writes all files but the report into `folder`. Throws `io::FileError`.
void write_bundle(const std::filesystem::path& folder, const ExportBundle& bundle);

/// Removes what `write_bundle` may have written there in an earlier run.
void remove_bundle(const std::filesystem::path& folder);

/// What the report says of the results, times of the stages included; status, threads, memory and
/// total are the caller's.
io::Report report_of(const ExportBundle& bundle);

}  // namespace mgf::plugin
