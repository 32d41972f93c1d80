// SPDX-License-Identifier: GPL-3.0-or-later
// An order of points along a space-filling curve: near in space, near in memory, and the same
// however the points were numbered.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/types.h"

namespace mgf {
namespace spatial_detail {

// Spreads the low 21 bits of x to every third bit.
inline std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffffU;
  x = (x | (x << 32U)) & 0x1f00000000ffffU;
  x = (x | (x << 16U)) & 0x1f0000ff0000ffU;
  x = (x | (x << 8U)) & 0x100f00f00f00f00fU;
  x = (x | (x << 4U)) & 0x10c30c30c30c30c3U;
  x = (x | (x << 2U)) & 0x1249249249249249U;
  return x;
}

}  // namespace spatial_detail

/// A grid of 2^21 cells a side on a box, numbered along a Morton curve.
class MortonGrid {
 public:
  MortonGrid(const Vec3& low, const Vec3& high) : low_(low) {
    const double extent = (high - low).maxCoeff();
    scale_ = extent > 0.0 ? 2097151.0 / extent : 0.0;
  }

  /// The number of the cell with `point`, which must lie in the box.
  std::uint64_t code(const Vec3& point) const {
    const Vec3 cell = (point - low_) * scale_;
    return spatial_detail::spread(static_cast<std::uint64_t>(cell.x())) |
           (spatial_detail::spread(static_cast<std::uint64_t>(cell.y())) << 1U) |
           (spatial_detail::spread(static_cast<std::uint64_t>(cell.z())) << 2U);
  }

 private:
  Vec3 low_;
  double scale_ = 0.0;
};

/// The numbers in `vertices` sorted by the Morton code of their point, ties by coordinates, then by
/// number. Linear time but for ties.
inline std::vector<Index> spatial_order(const std::vector<Vec3>& points,
                                        std::vector<Index> vertices) {
  if (vertices.empty()) return vertices;
  Vec3 low = points[vertices.front()];
  Vec3 high = low;
  for (const Index v : vertices) {
    low = low.cwiseMin(points[v]);
    high = high.cwiseMax(points[v]);
  }
  const MortonGrid grid(low, high);
  std::vector<std::uint64_t> code;
  code.reserve(vertices.size());
  for (const Index v : vertices) code.push_back(grid.code(points[v]));
  const std::vector<Index> order = sorted_by_key(code);
  std::vector<Index> sorted;
  sorted.reserve(order.size());
  for (const Index i : order) sorted.push_back(vertices[i]);
  vertices.swap(sorted);
  const auto key = [&](Index v) {
    const Vec3& p = points[v];
    return std::make_tuple(p.x(), p.y(), p.z(), v);
  };
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && code[order[last]] == code[order[first]]) ++last;
    if (last - first == 1) continue;
    std::sort(vertices.begin() + static_cast<std::ptrdiff_t>(first),
              vertices.begin() + static_cast<std::ptrdiff_t>(last),
              [&](Index a, Index b) { return key(a) < key(b); });
  }
  return vertices;
}

}  // namespace mgf
