// SPDX-License-Identifier: GPL-3.0-or-later
// What a run tells about itself: the contents of report.json.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/skeleton/branches.h"

namespace mgf::io {

/// How a run ended.
enum class ReportStatus {
  kOk,       ///< everything delivered, nothing to say
  kWarning,  ///< everything delivered, see the warnings
  kFailed,   ///< nothing delivered, see the error
};

/// The user's mesh.
struct InputReport {
  std::string file;  ///< as the user named it; empty if there is no file
  Index vertices = 0;
  Index faces = 0;
  Index components = 0;
  Index genus = 0;
};

/// Faces that crossed each other, and what was done about it on the working copy.
struct CrossingsReport {
  std::size_t pairs_mended = 0;
  std::size_t pairs_left = 0;
  std::size_t vertices_moved = 0;
  double largest_move = 0.0;  ///< mesh units
};

/// The medial complex; Betti numbers are those of the complex.
struct MedialAxisReport {
  Index samples_added = 0;
  Index vertices = 0;
  Index edges = 0;
  Index facets = 0;
  BettiNumbers betti;
};

/// The medial geodesic function.
struct MgfReport {
  Index facets = 0;
  Index certified = 0;  ///< facets whose geodesic is proven shortest
};

/// The delivered skeleton.
struct SkeletonReport {
  double theta = 0.0;
  double prune = 0.0;
  Index nodes = 0;
  Index edges = 0;
  Index b0 = 0;
  Index b1 = 0;
  Index leaves = 0;
  Index junctions = 0;
  Index residual_facets = 0;
  Index outside_edges = 0;
};

/// Tubular and flat.
struct SegmentationReport {
  double eccentricity_threshold = 0.0;
  double tubular_area_share = 0.0;
  Index unlabelled_faces = 0;
};

/// Wall-clock time of a stage.
struct StageReport {
  std::string stage;  ///< snake_case
  double seconds = 0.0;
};

/// The whole report. What a run did not reach stays empty and is left out of the file.
struct Report {
  ReportStatus status = ReportStatus::kOk;
  std::optional<Warning> error;  ///< why it failed
  InputReport input;
  std::optional<CrossingsReport> crossings;
  std::optional<MedialAxisReport> medial_axis;
  std::optional<TopologyCertificate> certificate;
  std::optional<MgfReport> mgf;
  std::optional<SkeletonReport> skeleton;
  std::optional<BranchGraph> branches;
  std::optional<SegmentationReport> segmentation;
  std::vector<StageReport> stages;
  double total_seconds = 0.0;
  unsigned threads = 0;
  double peak_memory_mb = 0.0;
  Warnings warnings;
};

}  // namespace mgf::io
