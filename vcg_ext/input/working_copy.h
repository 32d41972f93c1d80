// SPDX-License-Identifier: GPL-3.0-or-later
// What the stages work on: the user's surface after the harmless repairs, outward oriented, and
// with faces parted that cross near each other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/cleaning.h"
#include "vcg_ext/input/diagnosis.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/input/finding.h"
#include "vcg_ext/input/shells.h"
#include "vcg_ext/input/untangling.h"

namespace mgf {

/// A closed manifold surface, every shell oriented outward, and its correspondence with the input.
/// Without need for repair `surface` is the input itself. Vertices are where the input has them,
/// but for those that `untangling` moved.
struct WorkingCopy {
  TriangleSurface surface;
  std::vector<Index> vertex_of_input;  ///< one per input vertex; kNone: in no face that stayed
  std::vector<Index> face_of_input;    ///< one per input face; kNone: taken out
  std::vector<Index> input_of_vertex;  ///< one per vertex
  std::vector<Index> input_of_face;    ///< one per face
  std::vector<Index> shell_of_vertex;  ///< one per vertex: its solid, 0 .. solids-1
  Index solids = 0;
  Index genus = 0;        ///< sum over the solids
  Untangling untangling;  ///< in the numbering of `surface`
  Warnings warnings;      ///< one per finding, harmless ones included

  /// Some faces still cross.
  bool self_intersecting() const { return !untangling.left.empty(); }
};

/// What is done to the working copy besides the harmless repairs.
struct PreparationOptions {
  bool mend_crossings = true;  ///< part faces that cross near each other, see `untangle`
  unsigned threads = 0;        ///< 0: all; the result is the same for any number
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

/// The pairs of `crossings`, in the input's numbering, whose faces are both in the working copy.
inline std::vector<std::array<Index, 2>> crossings_left(
    const std::vector<std::array<Index, 2>>& crossings, const std::vector<Index>& face_of_input) {
  std::vector<std::array<Index, 2>> result;
  for (const auto& pair : crossings) {
    const auto [f, g] = std::minmax(face_of_input[pair[0]], face_of_input[pair[1]]);
    if (g != kNone) result.push_back({f, g});
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// True if both are the boundary of the same solids: none is flat, turned inside out or swallowed.
inline bool same_solids(const Shells& before, const Shells& after) {
  for (std::size_t s = 0; s < before.shells.size(); ++s) {
    if (after.flat[s] != 0 || !(after.shells[s].signed_volume > 0.0) ||
        after.shells[s].inside_shell != before.shells[s].inside_shell) {
      return false;
    }
  }
  return true;
}

/// Parts what can be parted of the working copy's `crossings`.
inline void mend_crossings(std::vector<std::array<Index, 2>> crossings, unsigned threads,
                           WorkingCopy& copy) {
  TriangleSurface mended = copy.surface;
  Untangling untangling = untangle(mended, crossings, threads);
  if (!untangling.moved.empty()) {
    const EdgeTable edges = make_edge_table(mended.triangles);
    if (same_solids(find_shells(copy.surface, edges, crossings),
                    find_shells(mended, edges, untangling.left))) {
      copy.surface = std::move(mended);
      copy.untangling = std::move(untangling);
      return;
    }
  }
  copy.untangling.left = std::move(crossings);
}

/// "0.0123 %", of the diagonal.
inline std::string in_per_cent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100.0 * share);
  return text;
}

/// A warning for each finding on the input, as far as it holds for the working copy.
inline void add_warnings(const std::vector<Finding>& findings, WorkingCopy& copy) {
  const auto add = [&](const Finding& finding) {
    copy.warnings.push_back({finding.code, finding.meaning + " " + finding.remedy});
  };
  const Untangling& untangling = copy.untangling;
  for (const Finding& finding : findings) {
    if (finding.code != "self_intersections") {
      add(finding);
      continue;
    }
    if (untangling.pairs_mended > 0) {
      Finding mended =
          make_finding("crossings_mended", Severity::kWarning, untangling.pairs_mended);
      mended.meaning +=
          " Vertices moved: " + std::to_string(untangling.moved.size()) + ", by up to " +
          in_per_cent(untangling.largest_move / bounding_box_diagonal(copy.surface.points)) +
          " of the diagonal.";
      add(mended);
    }
    if (!untangling.left.empty()) {
      add(make_finding(finding.code, Severity::kWarning, untangling.left.size()));
    }
  }
}

}  // namespace detail

/// The working copy of `input`, whose diagnosis is `diagnosis`.
/// Throws InputError, with the code of the first fatal finding, if the mesh can't be served.
inline WorkingCopy prepare(const TriangleSurface& input, const Diagnosis& diagnosis,
                           const PreparationOptions& options = {}) {
  require_servable(diagnosis);
  CleanedSurface cleaned = clean_surface(input);
  Shells pieces = find_pieces(cleaned.surface, make_edge_table(cleaned.surface.triangles));
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
  copy.surface = std::move(cleaned.surface);
  copy.vertex_of_input = std::move(cleaned.vertex_of_input);
  copy.face_of_input = std::move(cleaned.face_of_input);
  copy.input_of_vertex = std::move(cleaned.input_of_vertex);
  copy.input_of_face = std::move(cleaned.input_of_face);

  auto crossings = detail::crossings_left(diagnosis.crossings, copy.face_of_input);
  if (options.mend_crossings && !crossings.empty()) {
    detail::mend_crossings(std::move(crossings), options.threads, copy);
  } else {
    copy.untangling.left = std::move(crossings);
  }
  detail::add_warnings(diagnosis.findings, copy);
  return copy;
}

}  // namespace mgf
