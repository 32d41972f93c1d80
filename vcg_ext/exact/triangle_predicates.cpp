// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/triangle_predicates.h"

#include <CGAL/intersections.h>

#include <array>
#include <cstddef>

#include "vcg_ext/exact/cgal_kernel.h"
#include "vcg_ext/exact/predicates.h"

namespace mgf::exact {

using exact_detail::Kernel;
using exact_detail::to_cgal;

namespace {

// Rotates `triangle` so that `corner` comes first.
Triangle starting_at(const Triangle& triangle, std::size_t corner) {
  return {triangle[corner], triangle[(corner + 1) % 3], triangle[(corner + 2) % 3]};
}

// True if abc and abd, which share the side ab, share more than it.
bool folded_onto(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  for (int axis = 0; axis < 3; ++axis) {  // on either side of ab seen along an axis?
    if (area_sign_filtered(a, b, c, axis) * area_sign_filtered(a, b, d, axis) < 0) return false;
  }
  return orient3d(a, b, c, d) == 0 && CGAL::coplanar_orientation(to_cgal(a), to_cgal(b), to_cgal(c),
                                                                 to_cgal(d)) == CGAL::POSITIVE;
}

// True if abc and ade surely share a only, as seen along an axis a line through a parts them.
bool parted_at_corner(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  int axis = 0;
  (b - a).cross(c - a).cwiseAbs().maxCoeff(&axis);
  const auto side = [&](const Vec3& p, const Vec3& q) { return area_sign_filtered(a, p, q, axis); };
  const int bc = side(b, c);
  const int de = side(d, e);
  const int bd = side(b, d);
  const int be = side(b, e);
  const int cd = side(c, d);
  const int ce = side(c, e);
  // Both ends of one opposite side lie beyond a side of the other triangle at a.
  return (bc * bd < 0 && bc * be < 0) || (bc * cd > 0 && bc * ce > 0) ||
         (de * bd > 0 && de * cd > 0) || (de * be < 0 && de * ce < 0);
}

// True if abc and ade, which share the corner a, share more than it.
bool meet_beyond_corner(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  if (orient3d_filtered(a, b, c, d) * orient3d_filtered(a, b, c, e) > 0) return false;
  if (orient3d_filtered(a, d, e, b) * orient3d_filtered(a, d, e, c) > 0) return false;
  if (parted_at_corner(a, b, c, d, e)) return false;
  return segment_meets_triangle(b, c, a, d, e) || segment_meets_triangle(d, e, a, b, c);
}

}  // namespace

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    if (area_sign_filtered(a, b, c, axis) != 0) return false;
  }
  return CGAL::collinear(to_cgal(a), to_cgal(b), to_cgal(c));
}

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                            const Vec3& c) {
  const int side_p = orient3d(a, b, c, p);
  const int side_q = orient3d(a, b, c, q);
  if (side_p * side_q > 0) return false;
  if (side_p != 0 || side_q != 0) {  // the line meets the plane in one point
    const int ab = orient3d(p, q, a, b);
    const int bc = orient3d(p, q, b, c);
    if (ab * bc < 0) return false;
    const int ca = orient3d(p, q, c, a);
    return ab * ca >= 0 && bc * ca >= 0;
  }
  return CGAL::do_intersect(Kernel::Segment_3(to_cgal(p), to_cgal(q)),
                            Kernel::Triangle_3(to_cgal(a), to_cgal(b), to_cgal(c)));
}

bool triangles_intersect(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t) {
  std::array<std::size_t, 3> shared_s{};
  std::array<std::size_t, 3> shared_t{};
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (s[i] != t[j]) continue;
      shared_s[shared] = i;
      shared_t[shared] = j;
      ++shared;
    }
  }
  const auto at = [&](Index v) -> const Vec3& { return points[v]; };
  if (shared == 3) return true;
  if (shared == 2) {
    const Index c = s[3 - shared_s[0] - shared_s[1]];
    const Index d = t[3 - shared_t[0] - shared_t[1]];
    return folded_onto(at(s[shared_s[0]]), at(s[shared_s[1]]), at(c), at(d));
  }
  if (shared == 1) {
    const Triangle u = starting_at(s, shared_s[0]);
    const Triangle v = starting_at(t, shared_t[0]);
    return meet_beyond_corner(at(u[0]), at(u[1]), at(u[2]), at(v[1]), at(v[2]));
  }
  const auto cgal_triangle = [&](const Triangle& f) {
    return Kernel::Triangle_3(to_cgal(at(f[0])), to_cgal(at(f[1])), to_cgal(at(f[2])));
  };
  return CGAL::do_intersect(cgal_triangle(s), cgal_triangle(t));
}

}  // namespace mgf::exact
