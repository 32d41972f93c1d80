// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/predicates.h"

#include <cmath>

#include "vcg_ext/exact/cgal_kernel.h"

namespace mgf {
namespace exact_detail {

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

int in_sphere_closely(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
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
  if (permanent > kSphereFloor && std::abs(determinant) > kSphereBound * permanent) {
    return determinant > 0.0 ? 1 : -1;
  }
  return in_sphere_exact(a, b, c, d, e);
}

int in_sphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  return static_cast<int>(
      CGAL::side_of_oriented_sphere(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d), to_cgal(e)));
}

}  // namespace exact_detail

int orient2d_from_above(const Vec3& a, const Vec3& b, const Vec3& c) {
  using Point = exact_detail::Kernel::Point_2;
  return static_cast<int>(
      CGAL::orientation(Point(a.x(), a.y()), Point(b.x(), b.y()), Point(c.x(), c.y())));
}

}  // namespace mgf
