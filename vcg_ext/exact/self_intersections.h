// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of triangles in which a surface intersects or touches itself.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "vcg_ext/core/box_tree.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/triangle_predicates.h"

namespace mgf::exact {

/// The pairs i < j of faces that share a point which no common corner or side accounts for, in
/// ascending order. Exact: 0 pairs means embedded. Collinear faces are left out.
/// Requires valid indices, finite points, and no two points of the same position.
/// Cost: O(n log n) for a surface whose faces meet few others. The same for any number of
/// `threads` (0: all). `boxes`: the tree of the boxes of the faces.
inline std::vector<std::array<Index, 2>> self_intersections(const TriangleSurface& surface,
                                                            const BoxTree& boxes,
                                                            unsigned threads = 0) {
  const std::vector<Vec3>& points = surface.points;
  std::vector<char> degenerate;
  degenerate.reserve(surface.triangles.size());
  for (const Triangle& t : surface.triangles) {
    degenerate.push_back(collinear(points[t[0]], points[t[1]], points[t[2]]) ? 1 : 0);
  }
  using Pairs = std::vector<std::array<Index, 2>>;
  std::vector<Pairs> found(thread_count(threads));  // by each worker
  boxes.visit_meeting_pairs(thread_count(threads), [&](Index i, Index j, unsigned worker) {
    if (degenerate[i] != 0 || degenerate[j] != 0) return;
    const auto [f, g] = std::minmax(i, j);
    if (triangles_intersect(points, surface.triangles[f], surface.triangles[g])) {
      found[worker].push_back({f, g});
    }
  });
  Pairs meeting;
  for (const Pairs& some : found) meeting.insert(meeting.end(), some.begin(), some.end());
  std::sort(meeting.begin(), meeting.end());
  return meeting;
}
inline std::vector<std::array<Index, 2>> self_intersections(const TriangleSurface& surface,
                                                            unsigned threads = 0) {
  return self_intersections(surface, BoxTree(face_boxes(surface.points, surface.triangles)),
                            threads);
}

}  // namespace mgf::exact
