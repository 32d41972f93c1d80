// SPDX-License-Identifier: GPL-3.0-or-later
// A new vertex in a tetrahedral mesh: an edge, face or tetrahedron split, with all that has it.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// The tetrahedra that have the simplex whose corners are the first `size` of `simplex`, an edge, a
/// face or all of tetrahedron t; none if it is on the hull.
inline std::vector<Index> tetrahedra_round(const TetrahedralMesh& mesh, Index t,
                                           const std::array<Index, 4>& simplex, unsigned size) {
  if (size == 4) return {t};
  if (size == 3) {
    unsigned i = 0;
    while (std::find(simplex.begin(), simplex.begin() + 3, mesh.corners(t)[i]) !=
           simplex.begin() + 3) {
      ++i;
    }
    const Index u = mesh.neighbour(t, i);
    return u == kNone ? std::vector<Index>{} : std::vector<Index>{t, u};
  }
  EdgeRing ring;
  const bool closed = mesh.ring_of(t, simplex[0], simplex[1], mesh.slot_count(), ring);
  return closed ? ring.tetrahedra : std::vector<Index>{};
}

/// Splits that simplex, whose tetrahedra are `old`, at the point m, which need not lie on it.
/// False, and nothing done, unless all new tetrahedra are positive.
inline bool split_simplex(TetrahedralMesh& mesh, const std::vector<Index>& old,
                          const std::array<Index, 4>& simplex, unsigned size, Index m) {
  std::vector<Tetrahedron> made;
  for (const Index o : old) {
    for (unsigned k = 0; k < size; ++k) {
      Tetrahedron corners = mesh.corners(o);
      corners[corner_index(corners, simplex[k])] = m;
      if (mesh.orientation(corners[0], corners[1], corners[2], corners[3]) <= 0) return false;
      made.push_back(corners);
    }
  }
  mesh.replace(old, made);
  return true;
}

/// Splits that simplex at the point that `add(bits)` adds to the mesh, the nearer to a point inside
/// the simplex the more bits it is given; takes as few as do. Returns the point. Ends, as all new
/// tetrahedra are positive for all points that are near enough.
template <class Add>
Index split_simplex_near(TetrahedralMesh& mesh, const std::vector<Index>& old,
                         const std::array<Index, 4>& simplex, unsigned size, const Add& add) {
  constexpr unsigned kFirstBits = 4;
  for (unsigned bits = kFirstBits;; bits *= 2) {
    const Index m = add(bits);
    if (split_simplex(mesh, old, simplex, size, m)) return m;
    mesh.drop_last_point();
  }
}

}  // namespace mgf
