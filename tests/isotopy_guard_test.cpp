// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/medial/isotopy_guard.h"

#include <gtest/gtest.h>

#include <vector>

#include "vcg_ext/medial/boxed_surface.h"
#include "vcg_ext/medial/surface_flips.h"

namespace mgf::test {
namespace {

// Whether the edge of a ridge over the origin may be flipped in the presence of another face.
bool may_flip_beside(const std::vector<Vec3>& others, const Triangle& face) {
  std::vector<Vec3> points{{-1, 0, 1}, {1, 0, 1}, {0, 1, 0}, {0, -1, 0}};
  points.insert(points.end(), others.begin(), others.end());
  const ConstrainedSurface surface(points.size(), {{0, 1, 2}, {1, 0, 3}, face});
  return IsotopyGuard(points, surface).allows(0, 1, 0, 1, 2, 3);
}

TEST(Isotopy, AllowsFlipsThroughEmptySpace) {
  EXPECT_TRUE(may_flip_beside({{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}, {4, 5, 6}));
  EXPECT_TRUE(may_flip_beside({{0, 2, 0}}, {0, 2, 4}));             // the next face round
  EXPECT_TRUE(may_flip_beside({{3, 0, 1}, {3, 1, 1}}, {1, 4, 5}));  // at a corner, looking away
  EXPECT_TRUE(may_flip_beside({{0.9, 0.9, 0.9}, {1, 1, 0}, {1, 0.8, 0.5}}, {4, 5, 6}));
}

TEST(Isotopy, RefusesFlipsOverASpike) {
  EXPECT_FALSE(may_flip_beside({{0, 0, 0.5}, {0.1, 0, -1}, {-0.1, 0, -1}}, {4, 5, 6}));
  EXPECT_FALSE(may_flip_beside({{0, 0, 0}, {0.1, 0, -1}, {-0.1, 0, -1}}, {4, 5, 6}));  // touches
}

TEST(Isotopy, RefusesFlipsThroughASheet) {
  EXPECT_FALSE(may_flip_beside({{-5, -5, 0.5}, {5, -5, 0.5}, {0, 9, 0.5}}, {4, 5, 6}));
  EXPECT_FALSE(may_flip_beside({{9, 1, 0.5}, {9, -1, 0.6}}, {0, 4, 5}));  // from a corner
  EXPECT_FALSE(may_flip_beside({{0.5, 0.1, 0.7}}, {0, 2, 4}));  // next face round, but inward
}

TEST(Isotopy, RefusesFlatFlipsThatWouldFlattenAFace) {
  const auto may_flip = [](double x_of_c, double x_of_d) {
    const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {x_of_c, 1, 0}, {x_of_d, -1, 0}};
    const ConstrainedSurface surface(points.size(), {{0, 1, 2}, {1, 0, 3}});
    return IsotopyGuard(points, surface).allows(0, 1, 0, 1, 2, 3);
  };
  EXPECT_TRUE(may_flip(1, 1));
  EXPECT_FALSE(may_flip(0, 0));
  EXPECT_FALSE(may_flip(2, 2));
}

TEST(Isotopy, FollowsTheSurfaceAsItChanges) {
  const std::vector<Vec3> points{{-1, 0, 1}, {1, 0, 1},   {0, 1, 0},    {0, -1, 0},
                                 {4, 0, 9},  {5, 0.5, 9}, {5, -0.5, 9}, {0, 0, 0.5}};
  ConstrainedSurface surface(points.size(), {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}, {4, 6, 5}});
  IsotopyGuard guard(points, surface);
  ASSERT_TRUE(guard.allows(0, 1, 0, 1, 2, 3));
  ConstrainedSurface spiked(points.size(), {{0, 1, 2}, {1, 0, 3}, {5, 6, 7}, {4, 6, 5}});
  surface = spiked;  // face 2 has moved where its old box didn't reach
  ASSERT_TRUE(guard.allows(0, 1, 0, 1, 2, 3));
  guard.flipped(2, 3);
  EXPECT_FALSE(guard.allows(0, 1, 0, 1, 2, 3));
}

// A ridge whose flip makes two faces Delaunay, and a spike between the faces that it has and those
// that it would get, or below them.
Index flips_over_a_spike(double height) {
  const TriangleSurface surface{{{-1, 0, 0.02},
                                 {1, 0, 0.02},
                                 {0, 0.1, 0},
                                 {0, -0.1, 0},
                                 {0.3, 0, height},
                                 {0.35, 0.1, -1},
                                 {0.25, -0.1, -1}},
                                {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}}};
  const BoxedSurface plain = boxed(in_spatial_order(surface));
  const TetrahedralMesh delaunay(plain.points, plain.delaunay.corners, plain.delaunay.neighbours);
  ConstrainedSurface flipped(plain.points.size(), plain.faces);
  return SurfaceFlipper(delaunay.points(), flipped).flip_towards(delaunay);
}

TEST(Isotopy, IsAskedOfEveryFlip) {
  EXPECT_EQ(flips_over_a_spike(0.003), 1U);
  EXPECT_EQ(flips_over_a_spike(0.013), 0U);
}

// A larger ridge, and in one quarter of it (signs `x`, `y`) a small valley that crosses neither its
// roof nor the faces that it would get, but would cross either if it became a ridge; below each a
// spike that is in nobody's way.
Index flips_of_ridge_and_valley(double x, double y, bool has_ridge) {
  TriangleSurface surface{{{-1, 0, 0.04},
                           {1, 0, 0.04},
                           {0, 0.4, 0},
                           {0, -0.4, 0},
                           {-0.6 * x, 0, 0.0238},
                           {-0.6 * x + 0.05, 0.1, -1},
                           {-0.6 * x - 0.05, -0.1, -1},
                           {0.6 * x - 0.07, 0.13 * y, 0.012},
                           {0.6 * x + 0.07, 0.13 * y, 0.012},
                           {0.6 * x, 0.13 * y + 0.11, y > 0 ? 0.032 : 0.022},
                           {0.6 * x, 0.13 * y - 0.11, y > 0 ? 0.022 : 0.032},
                           {0.6 * x, 0.13 * y, 0.011},
                           {0.6 * x + 0.05, 0.13 * y + 0.1, -1},
                           {0.6 * x - 0.05, 0.13 * y - 0.1, -1}},
                          {{4, 5, 6}, {7, 8, 9}, {8, 7, 10}, {11, 12, 13}}};
  if (has_ridge) surface.triangles.insert(surface.triangles.end(), {{0, 1, 2}, {1, 0, 3}});
  const BoxedSurface plain = boxed(in_spatial_order(surface));
  const TetrahedralMesh delaunay(plain.points, plain.delaunay.corners, plain.delaunay.neighbours);
  ConstrainedSurface flipped(plain.points.size(), plain.faces);
  return SurfaceFlipper(delaunay.points(), flipped).flip_towards(delaunay);
}

TEST(Isotopy, IsAskedAboutTheSurfaceAsFlipped) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      EXPECT_EQ(flips_of_ridge_and_valley(x, y, false), 1U);
      EXPECT_EQ(flips_of_ridge_and_valley(x, y, true), 1U);
    }
  }
}

}  // namespace
}  // namespace mgf::test
