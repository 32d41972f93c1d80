// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as it is becomes part of the mesh, with exact points where flips get stuck.
#include "vcg_ext/medial/exact_recovery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/exact/exact_points.h"
#include "vcg_ext/medial/recover_interior.h"
#include "vcg_ext/mgf_skeleton.h"

namespace mgf::test {
namespace {

using namespace fixtures;

TriangleSurface squeezed(TriangleSurface surface) {
  for (Vec3& p : surface.points) p = p.cwiseProduct(Vec3(1.0, 0.3, 0.02));
  return surface;
}

TriangleSurface turned(const TriangleSurface& surface) {
  return rotated(surface, 0.7, Vec3(1, 2, 3));
}

/// A torus wound into a trefoil knot.
TriangleSurface trefoil() {
  TriangleSurface surface = torus(90, 8, 1.0, 0.3);
  for (Vec3& p : surface.points) {
    const double s = std::atan2(p.y(), p.x());
    const double r = std::hypot(p.x(), p.y()) - 1.0;
    const auto centre = [](double t) {
      return Vec3(std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                  -std::sin(3.0 * t));
    };
    const Vec3 along = (centre(s + 1e-3) - centre(s - 1e-3)).normalized();
    const Vec3 side = along.cross(Vec3(0, 0, 1)).normalized();
    p = centre(s) + r * side + p.z() * along.cross(side);
  }
  return reversed(surface);
}

double volume_under(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  double sum = 0.0;
  for (const Triangle& t : faces) sum += points[t[0]].dot(points[t[1]].cross(points[t[2]])) / 6.0;
  return sum;
}

InteriorTetrahedra recover(const TriangleSurface& surface, unsigned threads = 0) {
  RecoveryOptions options;
  options.recover_input_surface = true;
  options.threads = threads;
  return recover_interior(surface, options);
}

// Proven, and T' is T but for how it is divided into triangles.
InteriorTetrahedra expect_as_it_is(const TriangleSurface& surface, const BettiNumbers& betti) {
  const InteriorTetrahedra interior = recover(surface);
  const TopologyCertificate& certificate = interior.certificate;
  EXPECT_EQ(certificate.topology, TopologyVerdict::kProven);
  EXPECT_EQ(certificate.betti, betti);
  EXPECT_EQ(certificate.tetrahedra_not_positive, 0U);
  EXPECT_EQ(certificate.surface_flips, 0U);
  EXPECT_TRUE(certificate.isotopic);
  EXPECT_EQ(certificate.points_added, certificate.exact_points);
  const double volume = volume_under(surface.points, surface.triangles);
  EXPECT_NEAR(volume_under(interior.points, interior.boundary), volume, 1e-9 * volume);
  const SurfaceTree tree(surface);
  for (const Triangle& t : interior.boundary) {
    const Vec3 centroid =
        (interior.points[t[0]] + interior.points[t[1]] + interior.points[t[2]]) / 3.0;
    EXPECT_NEAR((tree.nearest(centroid).position - centroid).norm(), 0.0, 1e-12);
  }
  return interior;
}

TEST(ExactRecovery, KeepsSurfacesThatAreThere) {
  EXPECT_EQ(expect_as_it_is(sphere(3), {1, 0, 0}).certificate.exact_points, 0U);
  EXPECT_EQ(expect_as_it_is(torus(40, 16, 1.0, 0.3), {1, 1, 0}).certificate.exact_points, 0U);
}

TEST(ExactRecovery, RecoversAKnot) {
  expect_as_it_is(trefoil(), {1, 1, 0});
  expect_as_it_is(squeezed(trefoil()), {1, 1, 0});
}

TEST(ExactRecovery, RecoversSlivers) {
  // Needles fanned out from one corner each, and the diagonals of flat faces.
  expect_as_it_is(squeezed(turned(coarse_cylinder(48, 1.0, 5.0))), {1, 0, 0});
  expect_as_it_is(turned(midpoint_subdivided(box(1, 1, 1e-3))), {1, 0, 0});
  expect_as_it_is(squeezed(turned(l_block())), {1, 0, 0});
}

TEST(ExactRecovery, AddsPointsWhereFlipsGetStuck) {
  const InteriorTetrahedra interior = expect_as_it_is(squeezed(torus(40, 16, 1.0, 0.3)), {1, 1, 0});
  EXPECT_GT(interior.certificate.exact_points, 0U);
  EXPECT_EQ(interior.points.size(), interior.input_points + interior.certificate.exact_points);
}

TEST(ExactRecovery, CountsTheSolidsOfAMesh) {
  const TriangleSurface two =
      joined(squeezed(torus(30, 12, 1.0, 0.3)), moved(turned(box(1, 1, 0.01)), Vec3(0, 0, 2)));
  expect_as_it_is(two, {2, 1, 0});
}

TEST(ExactRecovery, IsTheSameInEveryRunWhateverTheThreads) {
  const TriangleSurface surface = squeezed(torus(24, 10, 1.0, 0.3));
  const InteriorTetrahedra first = recover(surface, 1);
  ASSERT_GT(first.certificate.exact_points, 0U);
  for (const unsigned threads : {1U, 3U}) {
    const InteriorTetrahedra again = recover(surface, threads);
    EXPECT_EQ(first.tetrahedra, again.tetrahedra);
    EXPECT_EQ(first.points, again.points);
  }
}

TEST(ExactRecovery, StopsWhenAsked) {
  const OrderedSurface ordered = in_spatial_order(squeezed(torus(40, 16, 1.0, 0.3)));
  const BoxedSurface plain = boxed(ordered);
  int reports = 0;
  const Progress impatient([&](double, const char*) { return ++reports < 20; });
  EXPECT_THROW(recover_exactly(plain, false, work_bounds(0, 1.0), impatient), Cancelled);
  EXPECT_EQ(reports, 20);
}

TEST(ExactRecovery, AddsPointsOnceItsAttemptsAreSpent) {
  const BoxedSurface plain = boxed(in_spatial_order(squeezed(torus(40, 16, 1.0, 0.3))));
  const auto points_added = [&](const ExactRecoveryLimits& limits) {
    TetrahedralMesh mesh(plain.points, plain.delaunay.corners, plain.delaunay.neighbours);
    ExactRecovery recovery(mesh, plain.faces, missing_faces(mesh, plain.faces), limits);
    EXPECT_TRUE(recovery.run({}).has_value());
    EXPECT_FALSE(recovery.spent());
    return mesh.exact_point_count();
  };
  ExactRecoveryLimits limits;
  const std::size_t unbounded = points_added(limits);
  limits.recursive_attempts = 0;
  EXPECT_GT(points_added(limits), unbounded);
}

TEST(ExactRecovery, ProvesAWingOfNeedles) {
  MedialAxisOptions options;
  const TopologyCertificate certificate =
      compute_medial_axis(wing(1000, 1.0), options).interior.certificate;
  EXPECT_EQ(certificate.topology, TopologyVerdict::kProven);
  EXPECT_GT(certificate.exact_points, 0U);
}

TEST(ExactRecovery, EndsWhenItsStepsAreSpent) {
  const BoxedSurface plain = boxed(in_spatial_order(squeezed(torus(40, 16, 1.0, 0.3))));
  const auto steps_of = [&](std::uint64_t limit) {
    TetrahedralMesh mesh(plain.points, plain.delaunay.corners, plain.delaunay.neighbours);
    ExactRecoveryLimits limits;
    limits.steps = limit;
    ExactRecovery recovery(mesh, plain.faces, missing_faces(mesh, plain.faces), limits);
    const bool complete = recovery.run({}).has_value();
    EXPECT_EQ(complete, !recovery.spent());
    EXPECT_TRUE(is_triangulated_box(mesh, kBoxFaces));
    return recovery.steps();
  };
  const std::uint64_t all = steps_of(std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(steps_of(all), all);
  for (const std::uint64_t part : {2U, 10U, 100U}) {
    EXPECT_GT(steps_of(all / part), all / part);
    EXPECT_LT(steps_of(all / part), all);
  }
}

// A surface through itself: the pieces of it meet inside faces, so that some are left out.
TEST(ExactRecovery, EndsOnASurfaceThatCrossesItself) {
  const TriangleSurface two = joined(sphere(1), moved(turned(sphere(1)), Vec3(0.9, 0.1, 0.2)));
  const OrderedSurface ordered = in_spatial_order(two);
  const InteriorTetrahedra interior =
      choose_interior(recover_exactly(boxed(ordered), false, work_bounds(0, 1.0), {}), ordered, two,
                      expected_betti_numbers(two), false, 1);
  EXPECT_NE(interior.certificate.topology, TopologyVerdict::kProven);
}

TEST(ExactRecovery, IsAnIsotopyWithFlipsToo) {
  const TriangleSurface surface = squeezed(trefoil());
  const TopologyCertificate certificate = recover_interior(surface, {}).certificate;
  EXPECT_EQ(certificate.topology, TopologyVerdict::kProven);
  EXPECT_TRUE(certificate.isotopic);
  EXPECT_GT(certificate.surface_flips, 0U);
  EXPECT_GT(certificate.exact_points, 0U);
  EXPECT_LT(certificate.exact_points, recover(surface).certificate.exact_points);
}

TEST(ExactRecovery, ServesTheLaterStages) {
  const TriangleSurface surface = squeezed(torus(40, 16, 1.0, 0.3));
  MedialAxisOptions options;
  options.sampling.length = 0.0;  // with points added, all of it is recovered by local moves
  options.recovery.recover_input_surface = true;
  const MedialAxis axis = compute_medial_axis(surface, options);
  ASSERT_GT(axis.interior.certificate.exact_points, 0U);
  const MedialGeodesicField field = compute_medial_geodesic_function(axis).field;
  const CurveSkeletonResult result = compute_skeleton_hierarchy(axis, field);
  const SkeletonOptions defaults;
  const CurveSkeleton skeleton = skeleton_at(result.hierarchy, defaults.theta, defaults.prune);
  EXPECT_EQ(betti_numbers(skeleton), (BettiNumbers{1, 1, 0}));
  const SurfaceTree tree(surface);
  const ShapeInterior inside = shape_interior(tree, false);
  for (const auto& [a, b] : skeleton.edge) {
    EXPECT_TRUE(inside.contains(skeleton.position[a]) &&
                inside.stays_inside(skeleton.position[a], skeleton.position[b]));
  }
}

TEST(SimplexSplit, RefusesAPointThatFlattensATetrahedron) {
  TetrahedralMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}},
                       {{kNone, kNone, kNone, kNone}});
  const Index on_a_face = mesh.add_point(Vec3(0.25, 0.25, 0.0));
  EXPECT_FALSE(split_simplex(mesh, {0}, {0, 1, 2, 3}, 4, on_a_face));
  EXPECT_EQ(mesh.slot_count(), 1U);
  const Index inside = mesh.add_point(Vec3(0.25, 0.25, 0.25));
  EXPECT_TRUE(split_simplex(mesh, {0}, {0, 1, 2, 3}, 4, inside));
  EXPECT_EQ(mesh.slot_count(), 4U);
  EXPECT_TRUE(is_triangulated_box(mesh, 4));
}

TEST(ExactPoints, LieExactlyWhereTheyAreSaidTo) {
  const std::vector<Vec3> given{{0.1, 0.2, 0.3},  {1.7, -0.4, 2.9}, {-0.6, 1.1, 0.7},
                                {0.9, 0.3, -1.3}, {0.2, 0.9, 3.1},  {5.3, -2.2, 0.4}};
  for (const unsigned bits : {4U, 16U, 64U, 256U}) {
    ExactPoints points(given);
    points.add_on_segment(0, 1, {2, 3, 4}, bits);
    points.add_on_triangle({0, 1, 2}, 3, 4, bits);
    for (const Index other : {2U, 3U, 4U, 5U}) EXPECT_EQ(points.orientation(0, 1, 6, other), 0);
    EXPECT_EQ(points.orientation(0, 1, 2, 7), 0);
    EXPECT_NE(points.orientation(0, 1, 3, 7), 0);
  }
}

TEST(ExactPoints, ComeNearerToTheCrossingWithMoreBits) {
  const std::vector<Vec3> given{{0, 0, 0}, {1, 1, 1}, {0.3, 0, 0}, {0, 0.3, 0}, {0, 0, 0.3}};
  const Vec3 crossing = Vec3::Constant(0.1);  // of the diagonal with x + y + z = 0.3
  for (const unsigned bits : {4U, 8U, 16U, 32U}) {
    ExactPoints points(given);
    const Vec3 found = points.add_on_segment(0, 1, {2, 3, 4}, bits);
    EXPECT_LE((found - crossing).cwiseAbs().maxCoeff(), std::ldexp(0.5, -static_cast<int>(bits)));
  }
}

}  // namespace
}  // namespace mgf::test
