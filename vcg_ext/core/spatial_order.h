// SPDX-License-Identifier: GPL-3.0-or-later
// An order of points along a space-filling curve: near in space, near in memory, and the same
// however the points were numbered.
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

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

/// The numbers in `vertices` sorted by the Morton code of their point, ties by coordinates, then by
/// number.
inline std::vector<Index> spatial_order(const std::vector<Vec3>& points,
                                        std::vector<Index> vertices) {
  if (vertices.empty()) return vertices;
  Vec3 low = points[vertices.front()];
  Vec3 high = low;
  for (const Index v : vertices) {
    low = low.cwiseMin(points[v]);
    high = high.cwiseMax(points[v]);
  }
  const double extent = (high - low).maxCoeff();
  const double scale = extent > 0.0 ? 2097151.0 / extent : 0.0;
  std::vector<std::uint64_t> code(points.size(), 0);
  for (const Index v : vertices) {
    const Vec3 cell = (points[v] - low) * scale;
    code[v] = spatial_detail::spread(static_cast<std::uint64_t>(cell.x())) |
              (spatial_detail::spread(static_cast<std::uint64_t>(cell.y())) << 1U) |
              (spatial_detail::spread(static_cast<std::uint64_t>(cell.z())) << 2U);
  }
  const auto key = [&](Index v) {
    const Vec3& p = points[v];
    return std::make_tuple(code[v], p.x(), p.y(), p.z(), v);
  };
  std::sort(vertices.begin(), vertices.end(), [&](Index a, Index b) { return key(a) < key(b); });
  return vertices;
}

}  // namespace mgf
