// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of any set of triangles, manifold or not.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A side of a face: from its corner `side` to the next one.
struct FaceSide {
  Index face;
  Index side;  ///< 0, 1, 2
};

/// All edges and the face sides on each.
struct EdgeTable {
  std::vector<std::array<Index, 2>> ends;  ///< a < b, ascending, one per edge
  Rows<FaceSide> sides;                    ///< one row per edge, by ascending face

  std::size_t size() const { return ends.size(); }
};

/// The vertex that a side of a triangle starts at, and the one it ends at.
inline Index side_start(const Triangle& triangle, Index side) {
  return triangle[side];
}
inline Index side_end(const Triangle& triangle, Index side) {
  return triangle[(side + 1) % 3];
}

/// The edges of `triangles`. Requires the three corners of each to differ. Linear time, but for
/// vertices of very many edges.
inline EdgeTable make_edge_table(const std::vector<Triangle>& triangles) {
  std::vector<Index> lesser_end;  // of side 3 f + i
  lesser_end.reserve(3 * triangles.size());
  Index vertex_count = 0;
  for (const Triangle& t : triangles) {
    for (Index side = 0; side < 3; ++side) {
      lesser_end.push_back(std::min(side_start(t, side), side_end(t, side)));
      vertex_count = std::max(vertex_count, t[side] + 1);
    }
  }
  const Rows<Index> sides_at = group_by_key(lesser_end, vertex_count);
  EdgeTable table;
  table.ends.reserve(lesser_end.size() / 2);
  table.sides.begin.reserve(lesser_end.size() / 2 + 1);
  table.sides.items.reserve(lesser_end.size());
  std::vector<std::array<Index, 2>> fan;  // greater end and side
  for (Index low = 0; low < vertex_count; ++low) {
    fan.clear();
    for (const Index s : sides_at[low]) {
      const Triangle& t = triangles[s / 3];
      fan.push_back({std::max(side_start(t, s % 3), side_end(t, s % 3)), s});
    }
    std::sort(fan.begin(), fan.end(), [](const auto& x, const auto& y) {
      return x[0] != y[0] ? x[0] < y[0] : x[1] < y[1];
    });
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const auto [high, side] = fan[i];
      table.sides.items.push_back({side / 3, side % 3});
      if (i + 1 < fan.size() && fan[i + 1][0] == high) continue;
      table.ends.push_back({low, high});
      table.sides.close_row();
    }
  }
  return table;
}

}  // namespace mgf
