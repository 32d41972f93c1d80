// SPDX-License-Identifier: GPL-3.0-or-later
// A surface with points inserted on it: the same point set, more vertices.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// The input surface T with vertices inserted on its edges and faces. Distances on it are those on
/// T; the input's vertices come first and keep their numbers.
struct RefinedSurface {
  TriangleSurface surface;
  std::vector<Index> parent_face;  ///< one per triangle: the face of T that it is part of
  Index input_points = 0;          ///< how many of the points are T's vertices
};

/// T as it is.
inline RefinedSurface unrefined(const TriangleSurface& surface) {
  RefinedSurface result;
  result.surface = surface;
  result.parent_face.resize(surface.triangles.size());
  for (Index f = 0; f < result.parent_face.size(); ++f) result.parent_face[f] = f;
  result.input_points = to_index(surface.points.size());
  return result;
}

}  // namespace mgf
