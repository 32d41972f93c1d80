// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles by their corners, and which of them a tetrahedral mesh has.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Finds triangles by their corners. Immutable, in one piece of memory.
class FaceLookup {
 public:
  /// Requires corners below `point_count`. Linear time.
  FaceLookup(const std::vector<Triangle>& faces, std::size_t point_count) {
    std::vector<Index> least;
    least.reserve(faces.size());
    for (const Triangle& face : faces) least.push_back(name(face).least);
    const Rows<Index> faces_at = group_by_key(least, point_count);
    entries_.begin = faces_at.begin;
    entries_.items.reserve(faces.size());
    for (const Index f : faces_at.items) entries_.items.push_back({name(faces[f]).others, f});
  }

  /// Calls `visit(f)` for the faces with these corners in any order, by ascending number.
  template <class Visit>
  void visit(const Triangle& face, const Visit& visit) const {
    const Name wanted = name(face);
    for (const Entry& entry : entries_[wanted.least]) {
      if (entry.others == wanted.others) visit(entry.face);
    }
  }

  bool has(const Triangle& face) const {
    bool found = false;
    visit(face, [&](Index) { found = true; });
    return found;
  }

 private:
  // A face by its corners, whatever their order.
  struct Name {
    Index least;
    std::uint64_t others;  // the middle corner, then the greatest
  };
  struct Entry {
    std::uint64_t others;
    Index face;
  };

  // Without branches, which no processor could foresee.
  static Name name(const Triangle& t) {
    const Index least = std::min(t[0], std::min(t[1], t[2]));
    const Index greatest = std::max(t[0], std::max(t[1], t[2]));
    const Index middle = t[0] ^ t[1] ^ t[2] ^ least ^ greatest;
    return {least, std::uint64_t{middle} << 32U | greatest};
  }

  Rows<Entry> entries_;  // by least corner
};

/// Calls `visit(f, t, i)` for each of `faces` that a tetrahedron of the mesh has: face i of t, of
/// the two tetrahedra that share it the one of the lesser number. Equal faces come up one by one;
/// calls for different faces may be made at the same time. Linear time.
template <class Visit>
void visit_common_faces(const TetrahedralMesh& mesh, const std::vector<Triangle>& faces,
                        unsigned threads, const Visit& visit) {
  constexpr std::size_t kChunk = 4096;
  const FaceLookup lookup(faces, mesh.points().size());
  parallel_for(mesh.slot_count(), threads, kChunk, [&](std::size_t slot, unsigned) {
    const Index t = to_index(slot);
    if (!mesh.alive(t)) return;
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh.neighbour(t, i) < t) continue;
      lookup.visit(face_of(mesh.corners(t), i), [&](Index f) { visit(f, t, i); });
    }
  });
}

/// The numbers of the faces that the mesh doesn't have, ascending.
inline std::vector<Index> missing_faces(const TetrahedralMesh& mesh,
                                        const std::vector<Triangle>& faces, unsigned threads = 1) {
  std::vector<char> present(faces.size(), 0);
  visit_common_faces(mesh, faces, threads, [&](Index f, Index, unsigned) { present[f] = 1; });
  std::vector<Index> missing;
  for (Index f = 0; f < present.size(); ++f) {
    if (present[f] == 0) missing.push_back(f);
  }
  return missing;
}

}  // namespace mgf
