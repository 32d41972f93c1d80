// SPDX-License-Identifier: GPL-3.0-or-later
// What the input doctor can find: every code with its meaning and remedy, in one table.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// What a finding means for the run.
enum class Severity {
  kHarmless,  ///< needs nothing, or is repaired on the working copy; said all the same
  kWarning,   ///< the mesh is served, but the result may suffer
  kFatal,     ///< the mesh can't be served
};

/// One kind of trouble in a mesh.
struct Finding {
  std::string code;  ///< stable, snake_case
  Severity severity = Severity::kHarmless;
  std::size_t count = 0;
  std::string meaning;          ///< sentences for the mesh's owner; the first one has the count
  std::string remedy;           ///< sentences; filters by their name in MeshLab 2020.09
  std::vector<Index> faces;     ///< culprits, ascending, in the input's numbering
  std::vector<Index> vertices;  ///< culprits, ascending, in the input's numbering
};

/// An entry of the doctor's book.
struct FindingText {
  const char* code;
  Severity severity;
  const char* one;   ///< the first sentence after the count, if the count is 1
  const char* many;  ///< and if it's more; empty: `one` is a sentence of its own, without count
  const char* meaning;
  const char* remedy;
};

// clang-format off
/// All that can be found; a code may be harmless in one mesh and fatal in another.
inline constexpr std::array<FindingText, 25> kFindingTexts{{
    {"empty", Severity::kFatal, "The mesh has no vertices.", "",
     "There is nothing to work on.", "Choose a layer that has a surface."},
    {"no_faces", Severity::kFatal, "The mesh has no face with an area.", "",
     "A cloud of points has no inside.",
     "Make a surface first, for example with 'Surface Reconstruction: Screened Poisson'."},
    {"too_large", Severity::kFatal, "The mesh has more vertices or faces than 32-bit numbers can count.", "", "",
     "Reduce it with 'Simplification: Quadric Edge Collapse Decimation'."},
    {"index_out_of_range", Severity::kFatal, "face names a vertex that doesn't exist.",
     "faces name vertices that don't exist.", "The file or the program that made it is broken.",
     "Delete the selected faces with 'Delete Selected Faces', then use 'Close Holes'."},
    {"non_finite", Severity::kFatal, "vertex has a coordinate that isn't a finite number.",
     "vertices have coordinates that aren't finite numbers.", "Nothing can be measured with them.",
     "Delete the selected vertices with 'Delete Selected Vertices', then use 'Close Holes'."},
    {"unreferenced_vertices", Severity::kHarmless, "vertex belongs to no face.",
     "vertices belong to no face.", "They are left out.",
     "'Remove Unreferenced Vertices' takes them away for good."},
    {"duplicate_vertices", Severity::kHarmless, "vertex has the position of another one.",
     "vertices have the position of another one.", "Each such group is taken as one vertex.",
     "'Remove Duplicate Vertices' merges them for good."},
    {"degenerate_faces", Severity::kHarmless, "face has no area.", "faces have no area.",
     "They are taken out without moving the surface.",
     "'Remove Duplicate Vertices', 'Remove Zero Area Faces' and 'Remove T-Vertices by Edge Flip' "
     "mend the mesh itself."},
    {"degenerate_faces", Severity::kFatal, "face has no area and can't be taken out.",
     "faces have no area and can't be taken out.",
     "Without them the surface would no longer be closed.",
     "Try 'Remove T-Vertices by Edge Flip', or 'Remove Zero Area Faces' and then 'Close Holes'."},
    {"duplicate_faces", Severity::kHarmless, "face repeats another one.",
     "faces repeat another one.", "Each is taken once.",
     "'Remove Duplicate Faces' takes the others away for good."},
    {"non_manifold_edges", Severity::kFatal, "edge belongs to more than two faces.",
     "edges belong to more than two faces.",
     "Sheets that meet there leave open what is inside.",
     "Use 'Repair non Manifold Edges by removing faces', then 'Close Holes'."},
    {"boundary_loops", Severity::kFatal, "hole.", "holes.",
     "An open surface has no inside, and so no medial axis.",
     "Use 'Close Holes', or rebuild the surface with "
     "'Surface Reconstruction: Screened Poisson'."},
    {"inconsistent_orientation", Severity::kFatal, "face looks the other way than its neighbours.",
     "faces look the other way than their neighbours.", "It is unclear which side is outside.",
     "Use 'Re-Orient all faces coherentely'. If that doesn't help, the surface is one-sided like "
     "a Klein bottle and bounds no solid."},
    {"non_manifold_vertices", Severity::kFatal, "vertex is a point where sheets merely touch.",
     "vertices are points where sheets merely touch.",
     "The surface is pinched there (vertices of equal position count as one), so that its inside is no solid with a boundary.",
     "Use 'Repair non Manifold Vertices by splitting' with a Vertex Displacement Ratio above 0, "
     "which parts the sheets."},
    {"flat", Severity::kFatal, "closed piece encloses no volume.",
     "closed pieces enclose no volume.", "There is no inside to thin.",
     "Remove such pieces with 'Remove Isolated pieces (wrt Face Num.)', or give them thickness."},
    {"huge_or_tiny_coordinates", Severity::kFatal,
     "The size of the mesh or of its coordinates lies outside 1e-40 to 1e40.", "",
     "Its areas and volumes can't be represented.",
     "Rescale it with 'Transform: Scale, Normalize'."},
    {"huge_or_tiny_coordinates", Severity::kWarning,
     "The size of the mesh or of its coordinates lies outside 1e-12 to 1e12.", "",
     "Programs that store coordinates with single precision may spoil the results.",
     "Rescale it with 'Transform: Scale, Normalize'."},
    {"far_from_origin", Severity::kWarning, "The mesh is far from the origin for its size.", "",
     "Coordinates have a fixed number of digits, so that little is left for the shape itself.",
     "Centre it with 'Transform: Translate, Center, set Origin' before it is stored with single "
     "precision."},
    {"several_shells", Severity::kHarmless, "solid.", "separate solids.",
     "Each has its own skeleton.", "'Split in Connected Components' makes a layer of each."},
    {"cavities", Severity::kFatal, "piece lies inside another one.",
     "pieces lie inside another one.",
     "Distances along the surface are not defined between separate pieces, so the medial geodesic "
     "function isn't defined round a cavity.",
     "Delete the selected faces, or let cavities be ignored."},
    {"cavities", Severity::kWarning, "piece lies inside another one.",
     "pieces lie inside another one.", "Such cavities are ignored: the solid is taken as filled.",
     "Delete the selected faces if they are not meant to be there."},
    {"inside_out", Severity::kHarmless, "closed piece is turned inside out.",
     "closed pieces are turned inside out.", "They are taken the other way round.",
     "'Invert Faces Orientation' turns them for good."},
    {"self_intersections", Severity::kWarning,
     "pair of faces intersects.", "pairs of faces intersect.",
     "The surface cuts through itself. Faces that cross near each other are parted on the working "
     "copy; with others left, the skeleton may have loops that the shape hasn't.",
     "Find them with 'Select Self Intersecting Faces'; delete the selected faces and use "
     "'Close Holes', or rebuild the surface with 'Surface Reconstruction: Screened Poisson'."},
    {"crossings_mended", Severity::kWarning,
     "pair of intersecting faces was parted.", "pairs of intersecting faces were parted.",
     "For that, vertices near them were moved on the working copy: the results are those of the "
     "moved surface.",
     "To mend the mesh itself, smooth it where 'Select Self Intersecting Faces' finds faces, for "
     "example with 'Laplacian Smooth' of the selection."},
    {"too_coarse", Severity::kWarning,
     "face is large for the thickness of the shape.",
     "faces are large for the thickness of the shape.",
     "The medial axis is made from the vertices, of which there are too few: points are added on "
     "the surface unless that is switched off.",
     "'Subdivision Surfaces: Midpoint' adds vertices to the mesh itself."},
}};
// clang-format on

/// A finding with its texts. Throws std::logic_error if the table has no such entry.
inline Finding make_finding(const std::string& code, Severity severity, std::size_t count,
                            std::vector<Index> faces = {}, std::vector<Index> vertices = {}) {
  for (const FindingText& text : kFindingTexts) {
    if (text.code != code || text.severity != severity) continue;
    const std::string many = text.many;
    std::string meaning = many.empty() ? std::string(text.one)
                          : count == 1 ? "1 " + std::string(text.one)
                                       : std::to_string(count) + " " + many;
    if (*text.meaning != '\0') meaning.append(" ").append(text.meaning);
    return {code,
            severity,
            count,
            std::move(meaning),
            text.remedy,
            std::move(faces),
            std::move(vertices)};
  }
  throw std::logic_error("no text for the finding " + code);
}

}  // namespace mgf
