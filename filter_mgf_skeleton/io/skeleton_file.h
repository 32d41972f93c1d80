// SPDX-License-Identifier: GPL-3.0-or-later
// skeleton.ply, skeleton_smooth.ply, and any other graph in space as vertices and edges.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "filter_mgf_skeleton/io/ply_writer.h"
#include "filter_mgf_skeleton/io/skeleton_tables.h"

namespace mgf::io {

/// Writes the elements `vertex` and `edge`, in this order: readers that know no edges stop in time.
/// Throws `FileError`.
inline void write_graph_ply(const std::filesystem::path& path, const std::string& comment,
                            const GraphTables& tables) {
  write_ply(path, comment, {{tables.nodes, std::nullopt}, {tables.edges, std::nullopt}});
}

/// Writes the skeleton with its branches. Throws `FileError`.
inline void write_skeleton(const std::filesystem::path& path, const CurveSkeleton& skeleton,
                           const BranchGraph& graph) {
  const SkeletonLabels labels = labels_of(graph);
  write_graph_ply(path, "curve skeleton, lengths in mesh units", skeleton_tables(skeleton, labels));
}

/// Writes the smooth skeleton with the same properties and the same branches as the raw one, whose
/// `graph` it takes. Throws `FileError`.
inline void write_skeleton_smooth(const std::filesystem::path& path, const SmoothSkeleton& smooth,
                                  const BranchGraph& graph) {
  const SkeletonLabels labels = labels_of(smooth, graph);
  write_graph_ply(path, "smooth curve skeleton, lengths in mesh units",
                  skeleton_tables(smooth, labels));
}

}  // namespace mgf::io
