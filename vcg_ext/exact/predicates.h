// SPDX-License-Identifier: GPL-3.0-or-later
// Signs of determinants of points, always right: a floating-point filter that settles nearly every
// call inline, exact arithmetic (predicates.cpp) for the rest.
#pragma once

#include <cmath>

#include "vcg_ext/core/types.h"

namespace mgf {
namespace exact_detail {

// Bounds on the rounding error of the determinants below, as multiples of their permanents
// (Shewchuk 1997, "Adaptive precision floating-point arithmetic", section 4.3), with a little to
// spare; u = 2^-53.
inline constexpr double kRoundoff = 1.1102230246251565e-16;
inline constexpr double kAreaBound = 4.0 * kRoundoff;
inline constexpr double kOrientBound = 8.0 * kRoundoff;
inline constexpr double kSphereBound = 18.0 * kRoundoff;
// Below these the permanents are in reach of underflow, which the bounds ignore.
inline constexpr double kAreaFloor = 1e-290;
inline constexpr double kOrientFloor = 1e-280;
inline constexpr double kSphereFloor = 1e-270;

inline int sign(double value) {
  return (value > 0.0) - (value < 0.0);
}

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
int in_sphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace exact_detail

/// The sign of the area of a, b, c seen from above (+z): +1 if anticlockwise, 0 if their
/// projections lie on a line. Exact for finite coordinates.
int orient2d_from_above(const Vec3& a, const Vec3& b, const Vec3& c);

/// `orient3d` where floating-point arithmetic is certain of the sign, else 0. A few nanoseconds.
inline int orient3d_filtered(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double bx = b.x() - a.x(), by = b.y() - a.y(), bz = b.z() - a.z();
  const double cx = c.x() - a.x(), cy = c.y() - a.y(), cz = c.z() - a.z();
  const double dx = d.x() - a.x(), dy = d.y() - a.y(), dz = d.z() - a.z();
  const double bycz = by * cz, bzcy = bz * cy;
  const double bzcx = bz * cx, bxcz = bx * cz;
  const double bxcy = bx * cy, bycx = by * cx;
  const double determinant = dx * (bycz - bzcy) + dy * (bzcx - bxcz) + dz * (bxcy - bycx);
  const double permanent = std::abs(dx) * (std::abs(bycz) + std::abs(bzcy)) +
                           std::abs(dy) * (std::abs(bzcx) + std::abs(bxcz)) +
                           std::abs(dz) * (std::abs(bxcy) + std::abs(bycx));
  const bool certain = permanent > exact_detail::kOrientFloor &&
                       std::abs(determinant) > exact_detail::kOrientBound * permanent;
  return certain ? exact_detail::sign(determinant) : 0;
}

/// The sign of det(b - a, c - a, d - a): +1 if d sees a, b, c clockwise, that is if abcd is a
/// positively oriented tetrahedron, -1 if negatively, 0 if the four points are coplanar. Exact for
/// finite coordinates. A few nanoseconds unless the points are nearly coplanar.
inline int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const int sign = orient3d_filtered(a, b, c, d);
  return sign != 0 ? sign : exact_detail::orient3d_exact(a, b, c, d);
}

/// The sign of component `axis` of (b - a) x (c - a), that is of the area of abc seen along that
/// axis, where floating-point arithmetic is certain of it, else 0.
inline int area_sign_filtered(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  const double left = (b[i] - a[i]) * (c[j] - a[j]);
  const double right = (b[j] - a[j]) * (c[i] - a[i]);
  const double permanent = std::abs(left) + std::abs(right);
  const bool certain = permanent > exact_detail::kAreaFloor &&
                       std::abs(left - right) > exact_detail::kAreaBound * permanent;
  return certain ? exact_detail::sign(left - right) : 0;
}

/// +1 if e lies inside the sphere through a, b, c, d, -1 if outside, 0 if on it. Requires abcd to
/// be positively oriented. Exact for finite coordinates.
inline int in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const Vec3 p[4] = {a - e, b - e, c - e, d - e};
  double lift[4];
  for (int i = 0; i < 4; ++i) lift[i] = p[i].squaredNorm();
  // Minors of the rows i, j in x and y; `plus` holds their permanents.
  double minor[4][4];
  double plus[4][4];
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const double left = p[i].x() * p[j].y();
      const double right = p[j].x() * p[i].y();
      minor[i][j] = left - right;
      plus[i][j] = std::abs(left) + std::abs(right);
    }
  }
  const auto det3 = [&](int i, int j, int k) {
    return p[i].z() * minor[j][k] - p[j].z() * minor[i][k] + p[k].z() * minor[i][j];
  };
  const auto permanent3 = [&](int i, int j, int k) {
    return std::abs(p[i].z()) * plus[j][k] + std::abs(p[j].z()) * plus[i][k] +
           std::abs(p[k].z()) * plus[i][j];
  };
  const double determinant = lift[0] * det3(1, 2, 3) - lift[1] * det3(0, 2, 3) +
                             lift[2] * det3(0, 1, 3) - lift[3] * det3(0, 1, 2);
  const double permanent = lift[0] * permanent3(1, 2, 3) + lift[1] * permanent3(0, 2, 3) +
                           lift[2] * permanent3(0, 1, 3) + lift[3] * permanent3(0, 1, 2);
  if (permanent > exact_detail::kSphereFloor &&
      std::abs(determinant) > exact_detail::kSphereBound * permanent) {
    return determinant > 0.0 ? 1 : -1;
  }
  return exact_detail::in_sphere_exact(a, b, c, d, e);
}

}  // namespace mgf
