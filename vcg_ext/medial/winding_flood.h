// SPDX-License-Identifier: GPL-3.0-or-later
// Which tetrahedra lie inside: winding numbers by crossing the surface's faces one at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/face_lookup.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Winding number of the surface about each tetrahedron.
struct WindingNumbers {
  std::vector<int> winding;                       ///< one per slot of the mesh
  std::vector<std::array<std::int8_t, 4>> walls;  ///< times that the surface has the face opposite
                                                  ///< corner i, outward from the tetrahedron minus
                                                  ///< inward
  Index faces_missing = 0;  ///< faces of the surface that are no face of the mesh
  Index conflicts = 0;      ///< faces whose two sides contradict each other: 0 unless faces miss
};

namespace winding_detail {

inline bool same_orientation(const Triangle& f, const Triangle& g) {
  return f == g || f == Triangle{g[1], g[2], g[0]} || f == Triangle{g[2], g[0], g[1]};
}

inline void find_walls(const TetrahedralMesh& mesh, const std::vector<Triangle>& faces,
                       unsigned threads, WindingNumbers& result) {
  std::vector<char> found(faces.size(), 0);
  const auto add = [](std::int8_t& turns, int sign) {
    turns = static_cast<std::int8_t>(turns + sign);
  };
  visit_common_faces(mesh, faces, threads, [&](Index f, Index t, unsigned i) {
    found[f] = 1;
    const int sign = same_orientation(faces[f], face_of(mesh.corners(t), i)) ? 1 : -1;
    add(result.walls[t][i], sign);
    const Index u = mesh.neighbour(t, i);
    if (u == kNone) return;
    for (unsigned j = 0; j < 4; ++j) {
      if (mesh.neighbour(u, j) == t && is_glued(mesh.corners(t), i, mesh.corners(u), j)) {
        add(result.walls[u][j], -sign);
      }
    }
  });
  result.faces_missing =
      to_index(static_cast<std::size_t>(std::count(found.begin(), found.end(), 0)));
}

}  // namespace winding_detail

/// Floods the mesh from its hull, which has winding number 0. Linear time. The same for any number
/// of `threads`.
inline WindingNumbers flood_winding_numbers(const TetrahedralMesh& mesh,
                                            const ConstrainedSurface& surface,
                                            unsigned threads = 1) {
  constexpr int kUnknown = 1 << 30;
  WindingNumbers result;
  result.winding.assign(mesh.slot_count(), kUnknown);
  result.walls.assign(mesh.slot_count(), {});
  winding_detail::find_walls(mesh, surface.faces(), threads, result);
  std::vector<Index> queue;
  for (Index t = 0; t < mesh.slot_count(); ++t) {
    if (!mesh.alive(t)) continue;
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh.neighbour(t, i) != kNone || result.winding[t] != kUnknown) continue;
      result.winding[t] = 0;
      queue.push_back(t);
    }
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Index t = queue[next];
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = mesh.neighbour(t, i);
      if (u == kNone) continue;
      // Leaving through a face that points out of t takes one turn away.
      const int winding = result.winding[t] - result.walls[t][i];
      if (result.winding[u] == kUnknown) {
        result.winding[u] = winding;
        queue.push_back(u);
      } else if (result.winding[u] != winding && t < u) {
        ++result.conflicts;
      }
    }
  }
  return result;
}

}  // namespace mgf
