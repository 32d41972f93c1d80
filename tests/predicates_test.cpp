// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "vcg_ext/core/random.h"

namespace mgf {
namespace {

double unit(Random& random) {
  return static_cast<double>(random.next() >> 11U) * 0x1.0p-53;
}

Vec3 random_point(Random& random) {
  const double x = unit(random);
  const double y = unit(random);
  return {x, y, unit(random)};
}

TEST(Orientation, OfTheAxesIsPositive) {
  const Vec3 o(0, 0, 0);
  EXPECT_EQ(orient3d(o, Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), 1);
  EXPECT_EQ(orient3d(o, Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)), -1);
  EXPECT_EQ(orient3d(o, Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(3, 4, 0)), 0);
}

// A point one unit in the last place off a plane is seen to be off it.
TEST(Orientation, SeesTheLastBit) {
  const Vec3 a(12.0, 12.0, 12.0), b(24.0, 24.0, 24.5), c(3.0, 7.0, 5.0);
  const Vec3 on = a + (b - a) * 0.5 + (c - a) * 0.5;
  ASSERT_EQ(orient3d(a, b, c, on), 0);
  Vec3 above = on;
  above.z() = std::nextafter(on.z(), 1e9);
  Vec3 below = on;
  below.z() = std::nextafter(on.z(), -1e9);
  EXPECT_NE(orient3d(a, b, c, above), 0);
  EXPECT_EQ(orient3d(a, b, c, above), -orient3d(a, b, c, below));
}

TEST(Orientation, AgreesWithExactArithmeticOnNearlyFlatTetrahedra) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random_point(random), b = random_point(random), c = random_point(random);
    const double s = unit(random), t = unit(random);
    const Vec3 d = a + s * (b - a) + t * (c - a);
    ASSERT_EQ(orient3d(a, b, c, d), exact_detail::orient3d_exact(a, b, c, d));
  }
}

TEST(Orientation, SurvivesTinyAndHugeCoordinates) {
  for (const double scale : {1e-120, 1e-12, 1e12, 1e80}) {
    EXPECT_EQ(orient3d(Vec3(0, 0, 0), Vec3(scale, 0, 0), Vec3(0, scale, 0), Vec3(0, 0, scale)), 1);
  }
}

TEST(InSphere, TellsInsideFromOutsideAndOn) {
  const Vec3 a(1, 0, 0), b(0, 1, 0), c(-1, 0, 0), d(0, 0, 1);
  ASSERT_EQ(orient3d(a, b, c, d), 1);
  EXPECT_EQ(in_sphere(a, b, c, d, Vec3(0, 0, 0)), 1);
  EXPECT_EQ(in_sphere(a, b, c, d, Vec3(0, 0, -1)), 0);
  EXPECT_EQ(in_sphere(a, b, c, d, Vec3(0, 0, -1.5)), -1);
}

TEST(InSphere, AgreesWithExactArithmetic) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const auto on_sphere = [&] {
      return (random_point(random) - Vec3::Constant(0.5)).normalized();
    };
    Vec3 p[4] = {on_sphere(), on_sphere(), on_sphere(), on_sphere()};
    if (orient3d(p[0], p[1], p[2], p[3]) == 0) continue;
    if (orient3d(p[0], p[1], p[2], p[3]) < 0) std::swap(p[0], p[1]);
    const Vec3 e = i % 2 == 0 ? on_sphere() : random_point(random);
    ASSERT_EQ(in_sphere(p[0], p[1], p[2], p[3], e),
              exact_detail::in_sphere_exact(p[0], p[1], p[2], p[3], e));
  }
}

}  // namespace
}  // namespace mgf
