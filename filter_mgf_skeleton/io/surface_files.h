// SPDX-License-Identifier: GPL-3.0-or-later
// segmentation.ply and parts.ply: the user's mesh with a label on each face.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "filter_mgf_skeleton/io/colour.h"
#include "filter_mgf_skeleton/io/ply_writer.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/surface/segmentation.h"
#include "vcg_ext/surface/surface_map.h"

namespace mgf::io {

/// Writes `mesh`, vertices and faces in their order, with face `quality` = 1 tubular, 0 flat, the
/// paper's colours, `eccentricity` and `confidence`. Requires one entry per face in `segmentation`.
/// Throws `FileError`.
inline void write_segmentation(const std::filesystem::path& path, const TriangleSurface& mesh,
                               const Segmentation& segmentation) {
  // Without a skeleton edge there is no evidence anywhere, so all faces or none lack a label.
  const bool labelled = segmentation.unlabelled_faces == 0;
  PlyElement faces = face_element(mesh.triangles);
  std::vector<Column>& columns = faces.table.columns;
  columns.push_back(real_column(
      "quality", [&](std::size_t f) { return segmentation.tubular.at(f) != 0 ? 1.0 : 0.0; }));
  add_colour_columns(
      [&](std::size_t f) {
        if (!labelled) return kUnlabelledColour;
        return segmentation.tubular.at(f) != 0 ? kTubularColour : kFlatColour;
      },
      columns);
  columns.push_back(measure_column("eccentricity", segmentation.eccentricity));
  columns.push_back(real_column("confidence", segmentation.confidence));
  write_ply(path, "tubular (quality 1) and flat (quality 0) regions",
            {vertex_element(mesh.points), faces});
}

/// Writes `mesh`, vertices and faces in their order, with face `quality` = branch and a colour per
/// branch, and where the face lies along it: `arc_length`, `distance`, `girth`. Requires one entry
/// per face in `faces_of`. Throws `FileError`.
inline void write_parts(const std::filesystem::path& path, const TriangleSurface& mesh,
                        const SkeletonCorrespondence& faces_of, const BranchGraph& graph) {
  const std::vector<Colour> colours = branch_colours(graph);
  PlyElement faces = face_element(mesh.triangles);
  std::vector<Column>& columns = faces.table.columns;
  columns.push_back(index_column("quality", faces_of.branch));
  columns.back().type = NumberType::kReal;  // what readers of `quality` expect
  add_colour_columns(
      [&](std::size_t f) {
        const Index branch = faces_of.branch.at(f);
        return branch == kNone ? kUnlabelledColour : colours.at(branch);
      },
      columns);
  columns.push_back(real_column("arc_length", faces_of.arc_length));
  columns.push_back(real_column("distance", faces_of.distance));
  columns.push_back(path_length_column("girth", faces_of.girth));
  write_ply(path, "parts by branch (quality), lengths in mesh units",
            {vertex_element(mesh.points), faces});
}

}  // namespace mgf::io
