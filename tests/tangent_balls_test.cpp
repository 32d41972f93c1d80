// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/tangent_balls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fixtures.h"
#include "vcg_ext/mgf_skeleton.h"

namespace mgf {
namespace {

// The vertex of a sphere of radius 1 that is nearest to `direction`.
Index vertex_towards(const TriangleSurface& sphere, const Vec3& direction) {
  Index best = 0;
  for (Index v = 0; v < sphere.points.size(); ++v) {
    if (sphere.points[v].dot(direction) > sphere.points[best].dot(direction)) best = v;
  }
  return best;
}

TEST(BallTangency, ABallInsideASphereIsTangentWhereItTouches) {
  const TriangleSurface sphere = fixtures::sphere(3);
  const BallTangency balls(sphere);
  for (Index v = 0; v < sphere.points.size(); ++v) {
    EXPECT_TRUE(balls.tangent(Vec3::Zero(), v));
    EXPECT_TRUE(balls.tangent(0.9 * sphere.points[v], v));
    EXPECT_FALSE(balls.tangent(1.1 * sphere.points[v], v)) << "outside";
  }
}

TEST(BallTangency, ABallThatCutsThroughByMoreThanSixtyDegreesIsNotTangent) {
  const TriangleSurface sphere =
      fixtures::sphere(5);  // its normals turn by less than 3 degrees a face
  const BallTangency balls(sphere);
  const Index top = vertex_towards(sphere, Vec3::UnitZ());
  const auto tangent_at_degrees = [&](double degrees) {
    const double angle = degrees * M_PI / 180;
    return balls.tangent(sphere.points[top] + Vec3(std::sin(angle), 0, -std::cos(angle)), top);
  };
  EXPECT_TRUE(tangent_at_degrees(55));
  EXPECT_FALSE(tangent_at_degrees(65));
}

TEST(BallTangency, TheCentreOfABoxIsTangentAtItsCorners) {
  const TriangleSurface box = fixtures::box(1, 1, 1);
  const BallTangency balls(box);
  for (Index v = 0; v < box.points.size(); ++v) {
    EXPECT_TRUE(balls.tangent(Vec3(0.5, 0.5, 0.5), v));
  }
}

// The points added on a disc 75 times as wide as it is thick are further apart than it is thick, so
// that balls through them cut through both faces and say nothing of the flow.
TEST(BallTangency, AThinDiscGivesAPoint) {
  const MedialAxis axis = compute_medial_axis(fixtures::coarse_cylinder(180, 7.5, 0.2));
  const MedialGeodesicFunction function = compute_medial_geodesic_function(axis);
  const SkeletonOptions options;
  const CurveSkeletonResult result = compute_skeleton_hierarchy(axis, function.field, options);
  const CurveSkeleton skeleton = skeleton_at(result.hierarchy, options.theta, options.prune);
  ASSERT_EQ(skeleton.node_count(), 1U);
  EXPECT_LT(Vec3(skeleton.position[0].x(), skeleton.position[0].y(), 0.0).norm(), 0.75);
}

}  // namespace
}  // namespace mgf
