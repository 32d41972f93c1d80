// SPDX-License-Identifier: GPL-3.0-or-later
// medial_axis.ply: the Voronoi facets as polygons, with MGF and contact points.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "filter_mgf_skeleton/io/ply_writer.h"
#include "filter_mgf_skeleton/io/vertex_numbers.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf::io {

/// Writes vertices with `radius`, and facets with `contact_a contact_b` (the ends of the dual
/// Delaunay edge, numbered by `numbers`), `mgf` and `gradient_x gradient_y gradient_z`. Lengths in
/// mesh units. Requires `mgf` and `gradient` to hold one entry per facet. Throws `FileError`.
inline void write_medial_axis(const std::filesystem::path& path, const MedialComplex& complex,
                              const std::vector<double>& mgf, const std::vector<Vec3>& gradient,
                              const VertexNumbers& numbers) {
  PlyElement vertices = vertex_element(complex.position);
  vertices.table.columns.push_back(real_column("radius", complex.radius));

  PlyElement facets{
      {"face", complex.facet_count(), {}},
      ListColumn{"vertex_indices", [&](std::size_t f) { return complex.facet_vertices[f]; }}};
  facets.table.columns = {
      index_column("contact_a",
                   [&](std::size_t f) { return numbers[complex.facet_contacts[f].a]; }),
      index_column("contact_b",
                   [&](std::size_t f) { return numbers[complex.facet_contacts[f].b]; }),
      path_length_column("mgf", mgf),
  };
  add_vector_columns("gradient_", gradient, facets.table.columns);
  write_ply(path, "medial axis and medial geodesic function, lengths in mesh units",
            {vertices, facets});
}

}  // namespace mgf::io
