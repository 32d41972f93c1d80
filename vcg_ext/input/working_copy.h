// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages work on: the user's surface after the harmless repairs, outward oriented.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/cleaning.h"
#include "vcg_ext/input/diagnosis.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/input/shells.h"

namespace mgf {

/// A closed manifold surface, every shell oriented outward, and its correspondence with the input.
/// Without need for repair `surface` is the input itself.
struct WorkingCopy {
  TriangleSurface surface;
  std::vector<Index> vertex_of_input;  ///< one per input vertex; kNone: in no face that stayed
  std::vector<Index> face_of_input;    ///< one per input face; kNone: taken out
  std::vector<Index> input_of_vertex;  ///< one per vertex
  std::vector<Index> input_of_face;    ///< one per face
  std::vector<Index> shell_of_vertex;  ///< one per vertex: its solid, 0 .. solids-1
  Index solids = 0;
  Index genus = 0;    ///< sum over the solids
  Warnings warnings;  ///< one per finding, harmless ones included
};

namespace detail {

/// Leaves out the faces of cavities and the vertices that only they have.
inline void drop_cavities(const std::vector<Shell>& shells, std::vector<Index>& shell_of_face,
                          CleanedSurface& cleaned) {
  const std::size_t vertex_count = cleaned.surface.points.size();
  std::vector<Index> new_vertex(vertex_count, kNone);
  std::vector<Index> new_face(cleaned.surface.triangles.size(), kNone);
  CleanedSurface kept;
  for (Index f = 0; f < new_face.size(); ++f) {
    if (shells[shell_of_face[f]].inside_shell != kNone) continue;
    new_face[f] = to_index(kept.input_of_face.size());
    kept.input_of_face.push_back(cleaned.input_of_face[f]);
    shell_of_face[new_face[f]] = shell_of_face[f];
    for (const Index v : cleaned.surface.triangles[f]) new_vertex[v] = 0;
  }
  shell_of_face.resize(kept.input_of_face.size());
  for (Index v = 0; v < vertex_count; ++v) {
    if (new_vertex[v] == kNone) continue;
    new_vertex[v] = to_index(kept.input_of_vertex.size());
    kept.input_of_vertex.push_back(cleaned.input_of_vertex[v]);
    kept.surface.points.push_back(cleaned.surface.points[v]);
  }
  for (Index f = 0; f < new_face.size(); ++f) {
    if (new_face[f] == kNone) continue;
    Triangle t = cleaned.surface.triangles[f];
    for (Index& v : t) v = new_vertex[v];
    kept.surface.triangles.push_back(t);
  }
  const auto rename = [](std::vector<Index>& map, const std::vector<Index>& to) {
    for (Index& i : map) i = i == kNone ? kNone : to[i];
  };
  kept.vertex_of_input = std::move(cleaned.vertex_of_input);
  kept.face_of_input = std::move(cleaned.face_of_input);
  rename(kept.vertex_of_input, new_vertex);
  rename(kept.face_of_input, new_face);
  cleaned = std::move(kept);
}

}  // namespace detail

/// The working copy of `input`, whose diagnosis under the same options is `diagnosis`.
/// Throws InputError, with the code of the first fatal finding, if the mesh can't be served.
inline WorkingCopy prepare(const TriangleSurface& input, const Diagnosis& diagnosis,
                           const DiagnosisOptions& /*already in the diagnosis*/ = {}) {
  require_servable(diagnosis);
  CleanedSurface cleaned = clean_surface(input);
  Shells pieces;
  detail::find_pieces(cleaned.surface, make_edge_table(cleaned.surface.triangles), pieces);
  detail::drop_cavities(diagnosis.shells, pieces.of_face, cleaned);

  WorkingCopy copy;
  std::vector<Index> solid_of_shell(diagnosis.shells.size(), kNone);
  for (std::size_t s = 0; s < diagnosis.shells.size(); ++s) {
    if (diagnosis.shells[s].inside_shell == kNone) solid_of_shell[s] = copy.solids++;
  }
  copy.shell_of_vertex.resize(cleaned.surface.points.size());
  for (std::size_t f = 0; f < cleaned.surface.triangles.size(); ++f) {
    Triangle& t = cleaned.surface.triangles[f];
    const Index s = pieces.of_face[f];
    for (const Index v : t) copy.shell_of_vertex[v] = solid_of_shell[s];
    if (diagnosis.shells[s].signed_volume < 0.0) std::swap(t[1], t[2]);
  }
  copy.genus = diagnosis.genus;
  for (const Finding& finding : diagnosis.findings) {
    copy.warnings.push_back({finding.code, finding.meaning + " " + finding.remedy});
  }
  copy.surface = std::move(cleaned.surface);
  copy.vertex_of_input = std::move(cleaned.vertex_of_input);
  copy.face_of_input = std::move(cleaned.face_of_input);
  copy.input_of_vertex = std::move(cleaned.input_of_vertex);
  copy.input_of_face = std::move(cleaned.input_of_face);
  return copy;
}

}  // namespace mgf
