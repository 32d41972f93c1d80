// SPDX-License-Identifier: GPL-3.0-or-later
// skeleton.ply: the curve skeleton as vertices and edges with their measures.
#pragma once

#include <filesystem>
#include <optional>

#include "filter_mgf_skeleton/io/ply_writer.h"
#include "filter_mgf_skeleton/io/skeleton_tables.h"

namespace mgf::io {

/// Writes the elements `vertex` and `edge`, in this order: readers that know no edges stop in time.
/// Throws `FileError`.
inline void write_skeleton(const std::filesystem::path& path, const GraphTables& tables) {
  write_ply(path, "curve skeleton, lengths in mesh units",
            {{tables.nodes, std::nullopt}, {tables.edges, std::nullopt}});
}

}  // namespace mgf::io
