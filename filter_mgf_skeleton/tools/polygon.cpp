// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons into triangles.
#include <cmath>
#include <limits>
#include <optional>

#include "filter_mgf_skeleton/tools/file_mesh.h"

namespace mgf::files {
namespace {

using Point2 = std::array<double, 2>;

/// Twice the signed area of a triangle in the plane.
double doubled_area(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Twice the polygon's area vector (Newell): its normal, also when it is neither planar nor convex.
Point area_vector(const std::vector<Point>& polygon) {
  Point sum{};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[(i + 1) % polygon.size()];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t next = (axis + 1) % 3;
      const std::size_t last = (axis + 2) % 3;
      sum[axis] += (p[next] - q[next]) * (p[last] + q[last]);
    }
  }
  return sum;
}

/// The polygon seen along the axis that is nearest to its normal, counter-clockwise.
std::vector<Point2> flattened(const std::vector<Point>& polygon) {
  const Point normal = area_vector(polygon);
  std::size_t axis = 0;
  for (std::size_t other = 1; other < 3; ++other)
    if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
  std::size_t u = (axis + 1) % 3;
  std::size_t v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<Point2> flat;
  flat.reserve(polygon.size());
  for (const Point& p : polygon) flat.push_back({p[u], p[v]});
  return flat;
}

/// Whether the corner at `position` can be cut off: convex, and no other corner lies in its
/// triangle.
bool is_ear(const std::vector<Point2>& flat, const std::vector<std::size_t>& ring,
            std::size_t position) {
  const std::size_t n = ring.size();
  const std::size_t before = ring[(position + n - 1) % n];
  const std::size_t tip = ring[position];
  const std::size_t after = ring[(position + 1) % n];
  if (doubled_area(flat[before], flat[tip], flat[after]) <= 0) return false;
  for (const std::size_t other : ring) {
    if (other == before || other == tip || other == after) continue;
    if (doubled_area(flat[before], flat[tip], flat[other]) >= 0 &&
        doubled_area(flat[tip], flat[after], flat[other]) >= 0 &&
        doubled_area(flat[after], flat[before], flat[other]) >= 0)
      return false;
  }
  return true;
}

double squared_distance(const Point& a, const Point& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

/// The ear with the shortest diagonal. A polygon that crosses itself may have none: then the first
/// corner, so that the number of triangles is right all the same.
std::size_t best_ear(const std::vector<Point>& polygon, const std::vector<Point2>& flat,
                     const std::vector<std::size_t>& ring) {
  std::size_t best = 0;
  double best_length = std::numeric_limits<double>::infinity();
  for (std::size_t position = 0; position < ring.size(); ++position) {
    const std::size_t n = ring.size();
    const double length =
        squared_distance(polygon[ring[(position + n - 1) % n]], polygon[ring[(position + 1) % n]]);
    if (length < best_length && is_ear(flat, ring, position)) {
      best = position;
      best_length = length;
    }
  }
  return best;
}

}  // namespace

void append_polygon(FileMesh& mesh, const std::vector<std::int64_t>& corners) {
  if (corners.size() < 3) throw ParseError("a face has fewer than three corners");
  std::vector<Point> polygon;
  polygon.reserve(corners.size());
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= static_cast<std::int64_t>(mesh.points.size())) {
      throw ParseError("a face names vertex " + std::to_string(corner) + ", but there are only " +
                       std::to_string(mesh.points.size()) + " (numbered from 0)");
    }
    polygon.push_back(mesh.points[static_cast<std::size_t>(corner)]);
  }
  const auto vertex = [&](std::size_t i) { return static_cast<std::uint32_t>(corners[i]); };

  std::vector<std::size_t> ring(corners.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
  const std::vector<Point2> flat = ring.size() > 3 ? flattened(polygon) : std::vector<Point2>();
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    const std::size_t ear = best_ear(polygon, flat, ring);
    mesh.triangles.push_back(
        {vertex(ring[(ear + n - 1) % n]), vertex(ring[ear]), vertex(ring[(ear + 1) % n])});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  mesh.triangles.push_back({vertex(ring[0]), vertex(ring[1]), vertex(ring[2])});
}

}  // namespace mgf::files
