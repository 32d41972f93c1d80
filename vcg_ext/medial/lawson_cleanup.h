// SPDX-License-Identifier: GPL-3.0-or-later
// After recovery: back to locally Delaunay where the surface allows it.
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/predicates.h"
#include "vcg_ext/medial/channel.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// 2-3 and 3-2 flips of faces that are not locally Delaunay, none of them of the surface, starting
/// from the tetrahedra that `mesh.changed`. Each flip lowers the mesh lifted to the paraboloid, so
/// this ends. Faces that no flip serves remain.
class LawsonCleanup {
 public:
  LawsonCleanup(TetrahedralMesh& mesh, const ConstrainedSurface& surface)
      : mesh_(mesh), surface_(surface) {}

  void run() {
    for (Index t = 0; t < mesh_.slot_count(); ++t) {
      if (mesh_.alive(t) && mesh_.changed(t)) enqueue(t);
    }
    while (!queue_.empty()) {
      const ListedFace face = queue_.back();
      queue_.pop_back();
      const unsigned i = find_listed(mesh_, face);
      if (i < 4) improve(face.tetrahedron, i);
    }
  }

 private:
  void enqueue(Index t) {
    for (unsigned i = 0; i < 4; ++i) queue_.push_back({t, face_of(mesh_.corners(t), i)});
  }

  void improve(Index t, unsigned i) {
    const Index u = mesh_.neighbour(t, i);
    if (u == kNone) return;
    const Tetrahedron corners = mesh_.corners(t);
    const Triangle face = face_of(corners, i);
    const Index p = corners[i];
    const Index q = across(u, face);
    if (std::any_of(corners.begin(), corners.end(), [&](Index v) { return mesh_.is_exact(v); }) ||
        mesh_.is_exact(q)) {
      return;  // in_sphere has doubles only
    }
    const int inside = in_sphere(mesh_.point(corners[0]), mesh_.point(corners[1]),
                                 mesh_.point(corners[2]), mesh_.point(corners[3]), mesh_.point(q));
    if (inside <= 0 || surface_.has_face(face[0], face[1], face[2])) return;
    int reflex = 0;
    unsigned side = 3;
    for (unsigned k = 0; k < 3; ++k) {
      const int sign = mesh_.orientation(p, q, face[k], face[(k + 1) % 3]);
      if (sign > 0) continue;
      ++reflex;
      side = sign < 0 ? k : 3;
    }
    if (reflex == 0) {
      exchange({t, u},
               {{p, q, face[0], face[1]}, {p, q, face[1], face[2]}, {p, q, face[2], face[0]}});
    } else if (reflex == 1 && side < 3) {
      remove_edge(t, face[side], face[(side + 1) % 3]);
    }
  }

  // 3-2 flip.
  void remove_edge(Index t, Index x, Index y) {
    if (!mesh_.ring_of(t, x, y, 3, ring_) || ring_.link.size() != 3 || surface_.has_edge(x, y)) {
      return;
    }
    const auto [a, b, c] = Triangle{ring_.link[0], ring_.link[1], ring_.link[2]};
    if (mesh_.orientation(a, b, c, y) <= 0 || mesh_.orientation(a, c, b, x) <= 0) return;
    exchange(ring_.tetrahedra, {{a, b, c, y}, {a, c, b, x}});
  }

  void exchange(const std::vector<Index>& old, const std::vector<Tetrahedron>& made) {
    for (const Index t : mesh_.replace(old, made)) enqueue(t);
  }

  Index across(Index t, const Triangle& face) const {
    for (const Index v : mesh_.corners(t)) {
      if (!ConstrainedSurface::has_corner(face, v)) return v;
    }
    return kNone;
  }

  TetrahedralMesh& mesh_;
  const ConstrainedSurface& surface_;
  EdgeRing ring_;
  std::vector<ListedFace> queue_;
};

}  // namespace mgf
