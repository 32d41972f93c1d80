// SPDX-License-Identifier: GPL-3.0-or-later
// Whether an edge flip moves a surface by an isotopy of space.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "vcg_ext/core/box_tree.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/predicates.h"
#include "vcg_ext/exact/triangle_predicates.h"
#include "vcg_ext/medial/constrained_surface.h"

namespace mgf {

/// Checks flips of a surface that changes by them. The flip of the side ab of abc and bad sweeps
/// the tetrahedron abcd. If the other faces meet that in no more than the corners and sides that
/// they have in common with it, the surface can be pushed across it, and stays embedded if it was
/// (docs/topology.md). Exact.
class IsotopyGuard {
 public:
  IsotopyGuard(const std::vector<Vec3>& points, const ConstrainedSurface& surface)
      : points_(points), surface_(surface) {}

  /// Whether the flip of ab, between f = abc and g = bad, is known to be an isotopy. If the two lie
  /// in one plane, they must make a convex quadrangle. A microsecond
  /// or two, but for the first call, which is O(n log n).
  bool allows(Index f, Index g, Index a, Index b, Index c, Index d) {
    const Tetrahedron swept{a, b, c, d};
    const int sign = orient3d(points_[a], points_[b], points_[c], points_[d]);
    if (sign == 0) {  // the surface stays the same point set
      return !exact::collinear(points_[c], points_[a], points_[d]) &&
             !exact::collinear(points_[d], points_[b], points_[c]);
    }
    if (!tree_) tree_.emplace(face_boxes(points_, surface_.faces()));
    Box box = box_of(surface_.face(f));
    box.extend(box_of(surface_.face(g)));
    bool free = true;
    tree_->visit([&](const Box& other) { return free && other.meets(box); },
                 [&](Index other) {
                   free = free && (other == f || other == g || is_clear(other, swept, sign));
                 });
    return free;
  }

  /// To be called after the flip.
  void flipped(Index f, Index g) {
    if (!tree_) return;
    for (const Index face : {f, g}) tree_->extend(face, box_of(surface_.face(face)));
  }

 private:
  Box box_of(const Triangle& t) const {
    return box_of_triangle(points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  // +1 if the vertex is strictly on the side of the tetrahedron's face opposite corner i where
  // corner i is, 0 on its plane.
  int side(Index v, const Tetrahedron& swept, int sign, unsigned i) const {
    std::array<Index, 4> corners = swept;
    corners[i] = v;
    return sign * orient3d(points_[corners[0]], points_[corners[1]], points_[corners[2]],
                           points_[corners[3]]);
  }

  // Whether the face meets the tetrahedron in what they have in common by number.
  bool is_clear(Index face, const Tetrahedron& swept, int sign) const {
    std::array<unsigned, 3> outside{};  // a bit for each plane that the corner lies beyond
    unsigned beyond = 0xF;
    for (unsigned k = 0; k < 3; ++k) {
      const Index v = surface_.face(face)[k];
      const auto shared =
          static_cast<unsigned>(std::find(swept.begin(), swept.end(), v) - swept.begin());
      if (shared < 4) {
        beyond &= ~(1U << shared);  // inside of this plane, on all others
        continue;
      }
      for (unsigned i = 0; i < 4; ++i) {
        if (side(v, swept, sign, i) < 0) outside[k] |= 1U << i;
      }
      if (outside[k] == 0) return false;  // within
      beyond &= outside[k];
    }
    if (beyond != 0) return true;
    const auto [a, b, c, d] = swept;
    const Triangle walls[4] = {{a, b, c}, {b, a, d}, {c, a, d}, {d, b, c}};
    return std::none_of(std::begin(walls), std::end(walls), [&](const Triangle& wall) {
      return exact::triangles_intersect(points_, surface_.face(face), wall);
    });
  }

  const std::vector<Vec3>& points_;
  const ConstrainedSurface& surface_;
  std::optional<BoxTree> tree_;  // of the faces, each with all that it has been
};

}  // namespace mgf
