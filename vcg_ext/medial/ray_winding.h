// SPDX-License-Identifier: GPL-3.0-or-later
// Winding numbers of a closed surface about arbitrary points, by vertical rays.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Winding numbers by counting signed crossings of the ray upwards, over a grid of columns. In the
/// plane, ties are broken in one consistent way, so the answer is an integer for any closed
/// surface, self-intersecting or not, and right for points off the surface by more than rounding.
class RayWinding {
 public:
  RayWinding(const std::vector<Vec3>& points, const std::vector<Triangle>& faces)
      : points_(points), faces_(faces) {
    if (faces.empty()) return;
    low_ = high_ = points[faces.front()[0]];
    for (const Triangle& face : faces) {
      for (const Index v : face) {
        low_ = low_.cwiseMin(points[v]);
        high_ = high_.cwiseMax(points[v]);
      }
    }
    side_ = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::sqrt(static_cast<double>(faces.size()))));
    std::vector<Index> counts(side_ * side_ + 1, 0);
    visit_columns([&](std::size_t column, Index) { ++counts[column + 1]; });
    for (std::size_t i = 0; i + 1 < counts.size(); ++i) counts[i + 1] += counts[i];
    columns_.begin = counts;
    columns_.items.resize(counts.back());
    visit_columns([&](std::size_t column, Index f) { columns_.items[counts[column]++] = f; });
  }

  /// Turns of the surface about p; positive inside an outward surface. Costs the faces of a column.
  int operator()(const Vec3& p) const {
    if (columns_.size() == 0) return 0;
    if ((p.array() < low_.array()).any() || (p.array() > high_.array()).any()) return 0;
    int winding = 0;
    for (const Index f : columns_[cell(p.x(), 0) * side_ + cell(p.y(), 1)]) {
      const Triangle& t = faces_[f];
      const int ab = side(p, t[0], t[1]);
      if (ab != side(p, t[1], t[2]) || ab != side(p, t[2], t[0])) continue;
      // Upward faces (anticlockwise from above) are left by the ray, downward ones entered.
      const Vec3 a = points_[t[0]] - p;
      const Vec3 b = points_[t[1]] - p;
      const Vec3 c = points_[t[2]] - p;
      const double volume = a.dot(b.cross(c));
      if ((volume > 0.0) == (ab > 0) && volume != 0.0) winding += ab;
    }
    return winding;
  }

 private:
  // +1 if p is left of ab seen from above, else -1; the same answer, negated, for ba.
  int side(const Vec3& p, Index a, Index b) const {
    const bool swapped = b < a;
    if (swapped) std::swap(a, b);
    const Vec3& q = points_[a];
    const Vec3& r = points_[b];
    const double area = (q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y());
    return (area >= 0.0) != swapped ? 1 : -1;
  }

  std::size_t cell(double x, int axis) const {
    const double extent = high_[axis] - low_[axis];
    if (!(extent > 0.0)) return 0;
    const double position = (x - low_[axis]) / extent * static_cast<double>(side_);
    return std::min(side_ - 1, static_cast<std::size_t>(std::max(0.0, position)));
  }

  template <class Visit>
  void visit_columns(const Visit& visit) const {
    for (Index f = 0; f < faces_.size(); ++f) {
      const Vec3& a = points_[faces_[f][0]];
      const Vec3& b = points_[faces_[f][1]];
      const Vec3& c = points_[faces_[f][2]];
      const Vec3 low = a.cwiseMin(b).cwiseMin(c);
      const Vec3 high = a.cwiseMax(b).cwiseMax(c);
      for (std::size_t x = cell(low.x(), 0); x <= cell(high.x(), 0); ++x) {
        for (std::size_t y = cell(low.y(), 1); y <= cell(high.y(), 1); ++y) visit(x * side_ + y, f);
      }
    }
  }

  const std::vector<Vec3>& points_;
  const std::vector<Triangle>& faces_;
  Vec3 low_ = Vec3::Zero();
  Vec3 high_ = Vec3::Zero();
  std::size_t side_ = 1;
  Rows<Index> columns_;
};

}  // namespace mgf
