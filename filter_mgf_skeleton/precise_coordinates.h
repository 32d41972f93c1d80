// SPDX-License-Identifier: GPL-3.0-or-later
// The digits that MeshLab's layers lose.
#pragma once

#include <string>

#include "vcg_ext/core/types.h"

namespace mgf::plugin {

/// `mesh` with the coordinates of the PLY or OFF file at `path`, of which it is a copy in single
/// precision. Throws `InputError` (coordinates_file) if the file can't be read, has another number
/// of vertices, or differs from `mesh` by more than rounding.
TriangleSurface with_precise_coordinates(TriangleSurface mesh, const std::string& path);

}  // namespace mgf::plugin
