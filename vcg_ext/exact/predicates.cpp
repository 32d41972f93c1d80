// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/predicates.h"

#include "vcg_ext/exact/cgal_kernel.h"

namespace mgf {
namespace exact_detail {

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
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
