// SPDX-License-Identifier: GPL-3.0-or-later
// tubes.ply: the skeleton as a coloured surface.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "filter_mgf_skeleton/io/colour.h"
#include "filter_mgf_skeleton/io/ply_writer.h"
#include "filter_mgf_skeleton/io/tube_mesh.h"

namespace mgf::io {

/// Writes `tubes` with vertex `quality` and the colour that `colour` gives to it: vertex colours,
/// since most programs keep those. Throws `FileError`.
inline void write_tubes(const std::filesystem::path& path, const TubeMesh& tubes,
                        const std::function<Colour(double)>& colour) {
  PlyElement vertices = vertex_element(tubes.surface.points);
  vertices.table.columns.push_back(real_column("quality", tubes.quality));
  add_colour_columns([&](std::size_t v) { return colour(tubes.quality.at(v)); },
                     vertices.table.columns);
  write_ply(path, "curve skeleton as tubes, lengths in mesh units",
            {vertices, face_element(tubes.surface.triangles)});
}

}  // namespace mgf::io
