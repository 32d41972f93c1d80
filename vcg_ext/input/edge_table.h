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

/// The edges of `triangles`. Requires the three corners of each to differ. O(n log n).
inline EdgeTable make_edge_table(const std::vector<Triangle>& triangles) {
  struct Entry {
    std::array<Index, 2> ends;
    FaceSide side;
  };
  std::vector<Entry> entries;
  entries.reserve(3 * triangles.size());
  for (Index f = 0; f < triangles.size(); ++f) {
    for (Index side = 0; side < 3; ++side) {
      const Index a = side_start(triangles[f], side);
      const Index b = side_end(triangles[f], side);
      entries.push_back({{std::min(a, b), std::max(a, b)}, {f, side}});
    }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return x.ends != y.ends ? x.ends < y.ends : x.side.face < y.side.face;
  });
  EdgeTable table;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    table.sides.items.push_back(entries[i].side);
    if (i + 1 < entries.size() && entries[i + 1].ends == entries[i].ends) continue;
    table.ends.push_back(entries[i].ends);
    table.sides.close_row();
  }
  return table;
}

}  // namespace mgf
