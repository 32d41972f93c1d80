// SPDX-License-Identifier: GPL-3.0-or-later
// Points that no double holds: exactly on a segment or a triangle of others.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A list of points with exact coordinates. The ones added lie exactly where they are said to;
/// their coordinates are sums of products of the given ones and binary fractions, so that they get
/// no longer from one addition to the next.
class ExactPoints {
 public:
  /// Starts with `points` as they are. Requires finite coordinates.
  explicit ExactPoints(const std::vector<Vec3>& points);
  ~ExactPoints();
  ExactPoints(const ExactPoints&) = delete;
  ExactPoints& operator=(const ExactPoints&) = delete;

  std::size_t size() const;

  /// As `orient3d`. Half a microsecond unless the points are nearly coplanar.
  int orientation(Index a, Index b, Index c, Index d) const;

  /// Adds a point on the line ab: its share of the way from a to b has `bits` binary places and is
  /// next to where the line crosses the plane of `xyz`. Requires that it does, a and b of those
  /// given, and `bits` > 0. Returns the point, rounded.
  Vec3 add_on_segment(Index a, Index b, const Triangle& xyz, unsigned bits);

  /// Adds a point in the plane of `abc`: its two coordinates along ab and ac have `bits` binary
  /// places and are next to where the line pq crosses that plane. Requires that it does, the
  /// corners of `abc` of those given, and `bits` > 0. Returns the point, rounded.
  Vec3 add_on_triangle(const Triangle& abc, Index p, Index q, unsigned bits);

  void add(const Vec3& point);
  void drop_last();

 private:
  struct Coordinates;
  std::unique_ptr<Coordinates> coordinates_;
};

}  // namespace mgf
