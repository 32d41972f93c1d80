// SPDX-License-Identifier: GPL-3.0-or-later
// A self-intersecting surface cut along its crossings.
#pragma once

#include <optional>

#include "vcg_ext/core/types.h"

namespace mgf {

/// The surface with every triangle cut along the others that it meets: triangles that share points
/// and edges where sheets cross, four or more at a seam. Vertices keep their numbers; points on
/// seams come after them, rounded to doubles. None if CGAL gives up, as on overlapping coplanar
/// faces. Requires a closed, edge-manifold surface.
std::optional<TriangleSurface> autorefined(const TriangleSurface& surface);

}  // namespace mgf
