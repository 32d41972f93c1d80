// SPDX-License-Identifier: GPL-3.0-or-later
// The filters, one per file of this folder.
#pragma once

#include "filter_mgf_skeleton/filter.h"

namespace mgf::plugin {

Filter medial_axis_filter();
Filter medial_geodesic_function_filter();
Filter curve_skeleton_filter();
Filter level_of_detail_filter();
Filter segmentation_filter();
Filter part_decomposition_filter();
Filter check_mesh_filter();
Filter export_files_filter();

/// The papers' reference, last in every help text.
inline const char* const kReference =
    "<br><br>See:<br><i>Tamal K. Dey, Jian Sun</i><br>"
    "<b>\"Defining and Computing Curve-skeletons with Medial Geodesic Function\"</b><br>"
    "Symposium on Geometry Processing 2006, pages 143-152";

/// What every filter that computes asks of its input, for the help text.
inline const char* const kRequirement =
    "<br><br>The mesh must be closed, manifold and consistently oriented, without self-crossings; "
    "<i>Check Mesh for Curve Skeleton</i> tells what is wrong with one that is refused. It is "
    "never changed but for the quality and colour said above.";

/// For the log of filters whose layers lie within the input.
inline const char* const kHideNote =
    "The new layers lie inside the mesh: hide it (the eye in the list of layers) to see them.";

}  // namespace mgf::plugin
