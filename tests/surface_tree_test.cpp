// SPDX-License-Identifier: GPL-3.0-or-later
// The search tree against brute force and closed forms, with queries through vertices and edges.
#include "vcg_ext/exact/surface_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/core/random.h"
#include "vcg_ext/exact/self_intersections.h"

namespace mgf {
namespace {

using fixtures::box;
using fixtures::sphere;

/// A point in the cube of half-size `size`.
Vec3 random_point(Random& random, double size) {
  constexpr Index kSteps = 1000003;
  const auto coordinate = [&] {
    return size * (2.0 * static_cast<double>(random.below(kSteps)) / kSteps - 1.0);
  };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

TEST(SurfaceTree, FindsTheNearestPointThatBruteForceFinds) {
  const TriangleSurface surface = fixtures::torus(20, 10, 2, 0.7);
  const SurfaceTree tree(surface);
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random_point(random, 3.0);
    double best = std::numeric_limits<double>::infinity();
    Index best_face = kNone;
    for (Index f = 0; f < surface.triangles.size(); ++f) {
      const Triangle& t = surface.triangles[f];
      const double d = (nearest_point_of_triangle(p, surface.points[t[0]], surface.points[t[1]],
                                                  surface.points[t[2]]) -
                        p)
                           .squaredNorm();
      if (d < best) {
        best = d;
        best_face = f;
      }
    }
    const SurfacePoint found = tree.nearest(p);
    EXPECT_EQ(found.face, best_face);
    EXPECT_DOUBLE_EQ(found.distance, std::sqrt(best));
    EXPECT_NEAR((found.position - p).norm(), found.distance, 1e-14);
  }
}

TEST(SurfaceTree, KnowsTheNearestPointOfABox) {
  const TriangleSurface surface = box(2, 2, 2);
  const SurfaceTree tree(surface);
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random_point(random, 4.0) + Vec3(1, 1, 1);
    const Vec3 clamped = p.cwiseMax(Vec3::Zero()).cwiseMin(Vec3::Constant(2));
    if (clamped == p) continue;
    EXPECT_NEAR((tree.nearest(p).position - clamped).norm(), 0.0, 1e-14);
  }
}

TEST(SurfaceTree, GivesTheLeastFaceAmongEquals) {
  const TriangleSurface surface = sphere(0);
  EXPECT_EQ(SurfaceTree(surface).nearest(Vec3(0, 0, 0)).face, 0U);
  EXPECT_EQ(SurfaceTree(surface).nearest(Vec3(0, 0, -5)).face, 4U);
}

TEST(SurfaceTree, TellsInsideFromOutside) {
  const TriangleSurface surface = sphere(3);
  const SurfaceTree tree(surface);
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point(random, 1.2);
    if (p.norm() < 0.97) {
      EXPECT_EQ(tree.winding_number(p), 1) << p.transpose();
    } else if (p.norm() > 1.0) {
      EXPECT_EQ(tree.winding_number(p), 0) << p.transpose();
    }
  }
}

TEST(SurfaceTree, IsNotFooledByRaysThroughVerticesAndEdges) {
  // Straight above these points lie vertices, edges, vertical faces and face borders.
  const TriangleSurface block = box(2, 2, 2);
  const SurfaceTree blocks(block);
  for (const double x : {-1.0, 0.0, 0.5, 1.0, 2.0, 3.0}) {
    for (const double y : {-1.0, 0.0, 0.5, 1.0, 2.0, 3.0}) {
      for (const double z : {-1.0, 0.5, 1.0, 3.0}) {
        const bool inside = x > 0 && x < 2 && y > 0 && y < 2 && z > 0 && z < 2;
        const bool on = !inside && x >= 0 && x <= 2 && y >= 0 && y <= 2 && z >= 0 && z <= 2;
        if (on) continue;
        EXPECT_EQ(blocks.winding_number(Vec3(x, y, z)), inside ? 1 : 0);
      }
    }
  }
  const TriangleSurface octahedron = sphere(0);
  EXPECT_TRUE(SurfaceTree(octahedron).inside(Vec3(0, 0, 0)));
  EXPECT_FALSE(SurfaceTree(octahedron).inside(Vec3(0, 0, -2)));
  EXPECT_FALSE(SurfaceTree(octahedron).inside(Vec3(0, 0, 2)));
}

TEST(SurfaceTree, CountsHowOftenOverlapsWind) {
  const TriangleSurface both = fixtures::joined(sphere(2), sphere(2, 2.0));
  EXPECT_EQ(SurfaceTree(both).winding_number(Vec3(0.1, 0.2, 0.3)), 2);
  const TriangleSurface hollow = fixtures::joined(fixtures::reversed(sphere(2)), sphere(2, 2.0));
  EXPECT_EQ(SurfaceTree(hollow).winding_number(Vec3(0.1, 0.2, 0.3)), 0);
  EXPECT_EQ(SurfaceTree(hollow).winding_number(Vec3(1.5, 0.0, 0.0)), 1);
  EXPECT_EQ(SurfaceTree(hollow).winding_number(Vec3(3.0, 0.0, 0.0)), 0);
}

TEST(SurfaceTree, FeelsTheLightestTouch) {
  const TriangleSurface block = box(2, 2, 2);
  const SurfaceTree tree(block);
  const double just_above = std::nextafter(2.0, 3.0);
  EXPECT_TRUE(tree.segment_meets(Vec3(-1, 1, 2), Vec3(3, 1, 2)));  // along a face
  EXPECT_FALSE(tree.segment_meets(Vec3(-1, 1, just_above), Vec3(3, 1, just_above)));
  EXPECT_TRUE(tree.segment_meets(Vec3(3, 1, 3), Vec3(1, 3, 1)));  // through an edge
  EXPECT_TRUE(tree.segment_meets(Vec3(2, 2, 2), Vec3(3, 3, 3)));  // from a corner
  EXPECT_TRUE(tree.segment_meets(Vec3(1, 1, 1), Vec3(1, 1, 2)));  // up to a face
  EXPECT_FALSE(tree.segment_meets(Vec3(0.1, 0.1, 0.1), Vec3(1.9, 1.9, 1.9)));
}

TEST(SurfaceTree, AgreesWithBruteForceOnSegments) {
  const TriangleSurface surface = fixtures::torus(20, 10, 2, 0.7);
  const SurfaceTree tree(surface);
  Random random(5);
  int met = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 a = random_point(random, 3.0);
    const Vec3 b = random_point(random, 3.0);
    bool expected = false;
    for (const Triangle& t : surface.triangles) {
      expected =
          expected || exact::segment_meets_triangle(a, b, surface.points[t[0]],
                                                    surface.points[t[1]], surface.points[t[2]]);
    }
    EXPECT_EQ(tree.segment_meets(a, b), expected);
    EXPECT_EQ(tree.first_hit(a, b).has_value(), expected);
    met += expected ? 1 : 0;
  }
  EXPECT_GT(met, 50);
  EXPECT_LT(met, 450);
}

TEST(SurfaceTree, FindsTheFirstHit) {
  const TriangleSurface block = box(3, 2, 1);
  const SurfaceTree tree(block);
  const auto hit = tree.first_hit(Vec3(-1, 0.7, 0.6), Vec3(10, 0.7, 0.6));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 1.0, 1e-14);
  EXPECT_NEAR((hit->position - Vec3(0, 0.7, 0.6)).norm(), 0.0, 1e-14);
  const Index entry = hit->face;
  const auto second = tree.first_hit(Vec3(-1, 0.7, 0.6), Vec3(10, 0.7, 0.6),
                                     [&](Index face) { return face == entry; });
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->distance, 4.0, 1e-14);
  EXPECT_FALSE(tree.first_hit(Vec3(-1, 5, 5), Vec3(10, 5, 5)));
}

TEST(SurfaceTree, AnswersForNoSurface) {
  const TriangleSurface nothing;
  const SurfaceTree tree(nothing);
  EXPECT_EQ(tree.nearest(Vec3(1, 2, 3)).face, kNone);
  EXPECT_FALSE(tree.segment_meets(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  EXPECT_FALSE(tree.inside(Vec3(0, 0, 0)));
}

TEST(SelfIntersections, AreNoneInSoundSurfaces) {
  EXPECT_TRUE(exact::self_intersections(sphere(3)).empty());
  EXPECT_TRUE(exact::self_intersections(box(3, 2, 1)).empty());
  EXPECT_TRUE(exact::self_intersections(fixtures::l_block()).empty());
  EXPECT_TRUE(exact::self_intersections(fixtures::torus(20, 10, 2, 0.7)).empty());
}

TEST(SelfIntersections, CountATouch) {
  // The second box stands on the first one: coplanar faces touch; lifted by one ulp, none do.
  const TriangleSurface lower = box(3, 3, 1);
  const TriangleSurface upper = fixtures::moved(box(1, 1, 1), Vec3(1, 1, 1));
  EXPECT_FALSE(exact::self_intersections(fixtures::joined(lower, upper)).empty());
  TriangleSurface lifted = upper;
  for (Vec3& p : lifted.points) p.z() = std::nextafter(p.z(), 9.0);
  EXPECT_TRUE(exact::self_intersections(fixtures::joined(lower, lifted)).empty());
}

TEST(SelfIntersections, NameThePairs) {
  const TriangleSurface crossing{{{0, 0, 0},
                                  {2, 0, 0},
                                  {0, 2, 0},
                                  {0.5, 0.5, -1},
                                  {0.5, 0.5, 1},
                                  {3, 3, 1},
                                  {9, 9, 9},
                                  {8, 9, 9},
                                  {9, 8, 9}},
                                 {{0, 1, 2}, {6, 7, 8}, {3, 4, 5}}};
  EXPECT_EQ(exact::self_intersections(crossing), (std::vector<std::array<Index, 2>>{{0, 2}}));
}

TEST(SelfIntersections, SeeFoldsOfNeighbours) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.5, 0}, {0, -1, 0}};
  EXPECT_TRUE(exact::triangles_intersect(points, {0, 1, 2}, {1, 0, 3}));   // folded flat
  EXPECT_FALSE(exact::triangles_intersect(points, {0, 1, 2}, {1, 0, 4}));  // spread flat
}

}  // namespace
}  // namespace mgf
