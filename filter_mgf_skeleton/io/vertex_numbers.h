// SPDX-License-Identifier: GPL-3.0-or-later
// From the numbers of the working copy back to those of the user's mesh.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf::io {

/// The number of each vertex in the user's file. Points that the algorithm added have none there;
/// they are numbered on from the user's last vertex, in their own order.
struct VertexNumbers {
  std::vector<Index> user_vertex;  ///< one per vertex of the working copy of the input
  Index user_vertices = 0;         ///< vertices in the user's mesh

  Index operator[](Index vertex) const {
    const Index own = to_index(user_vertex.size());
    return vertex < own ? user_vertex[vertex] : user_vertices + (vertex - own);
  }
};

/// The numbering of a working copy that kept the user's `vertices` as they were.
inline VertexNumbers same_numbers(Index vertices) {
  VertexNumbers numbers;
  numbers.user_vertices = vertices;
  numbers.user_vertex.resize(vertices);
  for (Index v = 0; v < vertices; ++v) numbers.user_vertex[v] = v;
  return numbers;
}

}  // namespace mgf::io
