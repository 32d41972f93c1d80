// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/exact_points.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>

namespace mgf {
namespace {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = ExactKernel::Point_3;
using Number = CGAL::Exact_predicates_exact_constructions_kernel::Exact_kernel::FT;
using ExactVector = std::array<Number, 3>;

ExactVector coordinates_of(const Point& p) {
  const auto& exact = CGAL::exact(p);
  return {exact.x(), exact.y(), exact.z()};
}

ExactVector difference(const ExactVector& p, const ExactVector& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

ExactVector cross(const ExactVector& u, const ExactVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Number dot(const ExactVector& u, const ExactVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// The share of the way from p to q at which the plane through x with that normal is crossed.
Number crossing(const ExactVector& p, const ExactVector& q, const ExactVector& x,
                const ExactVector& normal) {
  return dot(normal, difference(x, p)) / dot(normal, difference(q, p));
}

// The multiple of 2^-bits in (0, 1) next to `value`, which lies in [0, 1].
Number rounded(const Number& value, unsigned bits) {
  Number low(0);
  Number high(1);
  for (unsigned bit = 0; bit < bits; ++bit) {
    const Number middle = (low + high) / Number(2);
    (middle <= value ? low : high) = middle;
  }
  return low == Number(0) || (high != Number(1) && high - value < value - low) ? high : low;
}

}  // namespace

struct ExactPoints::Coordinates {
  std::vector<Point> points;

  Vec3 push(const ExactVector& p) {
    points.emplace_back(ExactKernel::FT(p[0]), ExactKernel::FT(p[1]), ExactKernel::FT(p[2]));
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }
};

ExactPoints::ExactPoints(const std::vector<Vec3>& points)
    : coordinates_(std::make_unique<Coordinates>()) {
  coordinates_->points.reserve(points.size());
  for (const Vec3& p : points) add(p);
}

ExactPoints::~ExactPoints() = default;

std::size_t ExactPoints::size() const {
  return coordinates_->points.size();
}

int ExactPoints::orientation(Index a, Index b, Index c, Index d) const {
  const std::vector<Point>& p = coordinates_->points;
  return static_cast<int>(CGAL::orientation(p[a], p[b], p[c], p[d]));
}

Vec3 ExactPoints::add_on_segment(Index a, Index b, const Triangle& xyz, unsigned bits) {
  const std::vector<Point>& points = coordinates_->points;
  const ExactVector start = coordinates_of(points[a]);
  const ExactVector end = coordinates_of(points[b]);
  const ExactVector x = coordinates_of(points[xyz[0]]);
  const ExactVector normal = cross(difference(coordinates_of(points[xyz[1]]), x),
                                   difference(coordinates_of(points[xyz[2]]), x));
  const Number share = rounded(crossing(start, end, x, normal), bits);
  const ExactVector way = difference(end, start);
  return coordinates_->push(
      {start[0] + share * way[0], start[1] + share * way[1], start[2] + share * way[2]});
}

Vec3 ExactPoints::add_on_triangle(const Triangle& abc, Index p, Index q, unsigned bits) {
  const std::vector<Point>& points = coordinates_->points;
  const ExactVector a = coordinates_of(points[abc[0]]);
  const ExactVector u = difference(coordinates_of(points[abc[1]]), a);
  const ExactVector v = difference(coordinates_of(points[abc[2]]), a);
  const ExactVector normal = cross(u, v);
  const ExactVector start = coordinates_of(points[p]);
  const ExactVector way = difference(coordinates_of(points[q]), start);
  const Number share = dot(normal, difference(a, start)) / dot(normal, way);
  const ExactVector place = difference(
      {start[0] + share * way[0], start[1] + share * way[1], start[2] + share * way[2]}, a);
  const Number area = dot(normal, normal);
  const Number along_u = rounded(dot(cross(place, v), normal) / area, bits);
  const Number along_v = rounded(dot(cross(u, place), normal) / area, bits);
  return coordinates_->push({a[0] + along_u * u[0] + along_v * v[0],
                             a[1] + along_u * u[1] + along_v * v[1],
                             a[2] + along_u * u[2] + along_v * v[2]});
}

void ExactPoints::add(const Vec3& point) {
  coordinates_->points.emplace_back(point.x(), point.y(), point.z());
}

void ExactPoints::drop_last() {
  coordinates_->points.pop_back();
}

}  // namespace mgf
