// SPDX-License-Identifier: GPL-3.0-or-later
// The interior has the shape's topology, proven, on everything that doesn't cross itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/core/random.h"
#include "vcg_ext/medial/recover_interior.h"

namespace mgf {
namespace {

double signed_volume(const TriangleSurface& surface) {
  double volume = 0.0;
  for (const Triangle& t : surface.triangles) {
    volume += surface.points[t[0]].dot(surface.points[t[1]].cross(surface.points[t[2]])) / 6.0;
  }
  return volume;
}

double volume(const InteriorTetrahedra& interior) {
  double sum = 0.0;
  for (const Tetrahedron& t : interior.tetrahedra) {
    const Vec3& a = interior.points[t[0]];
    sum += (interior.points[t[1]] - a)
               .cross(interior.points[t[2]] - a)
               .dot(interior.points[t[3]] - a) /
           6.0;
  }
  return sum;
}

InteriorTetrahedra expect_proven(const TriangleSurface& surface, const BettiNumbers& betti) {
  const InteriorTetrahedra interior = recover_interior(surface, {});
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kProven);
  EXPECT_EQ(interior.certificate.betti, betti);
  EXPECT_EQ(interior.certificate.expected, betti);
  EXPECT_EQ(interior.input_points, surface.points.size());
  return interior;
}

TriangleSurface squeezed(TriangleSurface surface) {
  for (Vec3& p : surface.points) p = p.cwiseProduct(Vec3(1.0, 0.3, 0.02));
  return surface;
}

// The same surface with its vertices and faces in another order.
TriangleSurface renumbered(const TriangleSurface& surface, std::vector<Index>& new_number) {
  Random random(5);
  new_number.resize(surface.points.size());
  std::iota(new_number.begin(), new_number.end(), Index{0});
  for (std::size_t i = new_number.size(); i > 1; --i) {
    std::swap(new_number[i - 1], new_number[random.below(i)]);
  }
  TriangleSurface result = surface;
  for (Index v = 0; v < surface.points.size(); ++v) {
    result.points[new_number[v]] = surface.points[v];
  }
  for (Triangle& t : result.triangles) {
    for (Index& v : t) v = new_number[v];
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  std::reverse(result.triangles.begin(), result.triangles.end());
  return result;
}

TEST(Recovery, FillsABoxOfEightVertices) {
  const InteriorTetrahedra interior = expect_proven(fixtures::box(3, 2, 1), {1, 0, 0});
  EXPECT_NEAR(volume(interior), 6.0, 1e-12);
  EXPECT_EQ(interior.certificate.points_added, 0U);
}

TEST(Recovery, FillsAnLBlock) {
  const TriangleSurface surface = fixtures::l_block();
  EXPECT_NEAR(volume(expect_proven(surface, {1, 0, 0})), signed_volume(surface), 1e-9);
}

TEST(Recovery, FillsCosphericalShapes) {
  expect_proven(fixtures::sphere(3), {1, 0, 0});
  expect_proven(fixtures::coarse_cylinder(48, 1.0, 5.0), {1, 0, 0});
  expect_proven(fixtures::midpoint_subdivided(fixtures::box(1, 1, 1)), {1, 0, 0});
}

TEST(Recovery, FillsATorusWithOneLoop) {
  const TriangleSurface surface = fixtures::torus(40, 16, 1.0, 0.3);
  EXPECT_NEAR(volume(expect_proven(surface, {1, 1, 0})), signed_volume(surface), 1e-9);
}

TEST(Recovery, CountsTheSolidsOfAMesh) {
  const TriangleSurface two = fixtures::joined(
      fixtures::torus(30, 12, 1.0, 0.3), fixtures::moved(fixtures::sphere(2), Vec3(4.0, 0.0, 0.0)));
  expect_proven(two, {2, 1, 0});
}

TEST(Recovery, IsProvenOnSqueezedCopies) {
  expect_proven(squeezed(fixtures::torus(40, 16, 1.0, 0.3)), {1, 1, 0});
  expect_proven(squeezed(fixtures::rotated(fixtures::torus(40, 16, 1.0, 0.3), 0.7, Vec3(1, 2, 3))),
                {1, 1, 0});
  expect_proven(squeezed(fixtures::rotated(fixtures::sphere(3), 0.7, Vec3(1, 2, 3))), {1, 0, 0});
}

TEST(Recovery, IsProvenAtEveryScale) {
  for (const double scale : {1e-6, 1e6}) {
    expect_proven(fixtures::scaled(fixtures::torus(40, 16, 1.0, 0.3), scale), {1, 1, 0});
  }
}

TEST(Recovery, DoesNotDependOnTheNumberingOfVertices) {
  const TriangleSurface surface =
      squeezed(fixtures::rotated(fixtures::torus(24, 10, 1.0, 0.3), 0.7, Vec3(1, 2, 3)));
  std::vector<Index> number;
  const InteriorTetrahedra first = recover_interior(surface, {});
  const InteriorTetrahedra second = recover_interior(renumbered(surface, number), {});
  ASSERT_EQ(first.tetrahedra.size(), second.tetrahedra.size());
  for (Index v = to_index(surface.points.size()); v < first.points.size(); ++v) number.push_back(v);
  for (std::size_t t = 0; t < first.tetrahedra.size(); ++t) {
    Tetrahedron mapped = first.tetrahedra[t];
    for (Index& v : mapped) v = number[v];
    ASSERT_EQ(mapped, second.tetrahedra[t]);
  }
}

TEST(Recovery, TurnsWithTheShape) {
  // All corners shaken apart: no four cocircular, so that there is one Delaunay tetrahedralisation.
  TriangleSurface surface = squeezed(fixtures::torus(24, 10, 1.0, 0.3));
  Random random(9);
  for (Vec3& p : surface.points) {
    p += 1e-6 * Vec3(random.below(1000), random.below(1000), 0.1 * random.below(1000));
  }
  const InteriorTetrahedra first = recover_interior(surface, {});
  EXPECT_GT(first.certificate.surface_flips, 0U);
  EXPECT_TRUE(first.certificate.isotopic);
  for (const double angle : {0.4, 1.3, 2.9}) {
    const InteriorTetrahedra turned =
        recover_interior(fixtures::rotated(surface, angle, Vec3(1, 2, 3)), {});
    EXPECT_EQ(first.tetrahedra, turned.tetrahedra) << angle;
    EXPECT_EQ(first.neighbours, turned.neighbours) << angle;
  }
}

TEST(Recovery, DoesNotDependOnTheNumberOfThreads) {
  const TriangleSurface surface = squeezed(fixtures::torus(24, 10, 1.0, 0.3));
  RecoveryOptions options;
  options.threads = 1;
  const InteriorTetrahedra one = recover_interior(surface, options);
  options.threads = 3;
  const InteriorTetrahedra three = recover_interior(surface, options);
  EXPECT_EQ(one.tetrahedra, three.tetrahedra);
  EXPECT_EQ(one.certificate.betti, three.certificate.betti);
  EXPECT_EQ(one.certificate.topology, three.certificate.topology);
}

TEST(Recovery, GivesAnHonestResultWhenItsBoundsDontDo) {
  const TriangleSurface surface = squeezed(fixtures::torus(40, 16, 1.0, 0.3));
  const OrderedSurface ordered = in_spatial_order(surface);
  const BettiNumbers expected = expected_betti_numbers(surface);
  // No flips of the surface, no recursive removals, no added point.
  const RecoveredMesh recovered =
      attempt_recovery(boxed(ordered), {1, 0, 0.0, 0, false, false}, work_bounds(0, 1.0), {});
  ASSERT_FALSE(recovered.complete);
  const InteriorTetrahedra interior =
      choose_interior(recovered, ordered, surface, expected, true, 1);
  EXPECT_NE(interior.certificate.topology, TopologyVerdict::kProven);
  EXPECT_GT(interior.certificate.boundary_faces_missing, 0U);
  EXPECT_EQ(interior.certificate.topology == TopologyVerdict::kCounted,
            interior.certificate.betti == expected);
  // Inside by rays: what is missing are slivers.
  EXPECT_NEAR(volume(interior), signed_volume(surface), 0.05 * signed_volume(surface));
}

// Some stuck edge of this torus has no room for a point until another one has got one.
TEST(BoundaryRecovery, EdgesWithoutRoomForAPointWaitUntilOthersMadeSome) {
  TriangleSurface surface =
      fixtures::rotated(fixtures::torus(24, 10, 1.0, 0.3), 0.7, Vec3(1, 2, 3));
  for (Vec3& p : surface.points) p = p.cwiseProduct(Vec3(1.0, 0.3, 0.3));
  for (const std::uint64_t seed : {1U, 2U}) {
    const RecoveredMesh recovered =
        attempt_recovery(boxed(in_spatial_order(surface)), {seed, 200, 0.05, 400, false, false},
                         work_bounds(0, 1.0), {});
    EXPECT_TRUE(recovered.complete);
    EXPECT_GT(recovered.points_added, 0U);
  }
}

// CGAL's autorefinement is not made for so many faces that cross on one line.
TEST(Recovery, EndsOnATorusThroughItselfThatCantBeCut) {
  TriangleSurface surface = fixtures::torus(8, 11, 1.0, 1.25);
  constexpr double kGrid = 0.044;
  for (Vec3& p : surface.points) p = kGrid * (p / kGrid).array().round().matrix();
  RecoveryOptions options;
  options.known_crossings = 152;  // so that it is cut at once
  const InteriorTetrahedra interior = recover_interior(surface, options);
  EXPECT_NE(interior.certificate.topology, TopologyVerdict::kProven);
  EXPECT_FALSE(interior.tetrahedra.empty());
}

TEST(BoundaryRecovery, AddsPointsOnceItsAttemptsAreSpent) {
  const TriangleSurface surface =
      squeezed(fixtures::rotated(fixtures::torus(24, 10, 1.0, 0.3), 0.7, Vec3(1, 2, 3)));
  const BoxedSurface plain = boxed(in_spatial_order(surface));
  const auto points_added = [&](int attempts_in_all) {
    TetrahedralMesh mesh(plain.points, plain.delaunay.corners, plain.delaunay.neighbours);
    ConstrainedSurface constrained(plain.points.size(), plain.faces);
    RecoveryLimits limits;
    limits.added_points = 1000;
    limits.attempts_in_all = attempts_in_all;
    BoundaryRecovery recovery(mesh, constrained, limits);
    EXPECT_TRUE(recovery.run({}));
    return recovery.points_added();
  };
  const Index unbounded = points_added(std::numeric_limits<int>::max());
  EXPECT_EQ(points_added(100'000), unbounded);
  EXPECT_GT(points_added(100), unbounded);
}

TEST(Recovery, GivesUpHonestlyWhereItsEffortIsSpent) {
  const TriangleSurface surface = squeezed(fixtures::torus(40, 16, 1.0, 0.3));
  RecoveryOptions options;
  options.recover_input_surface = true;
  options.effort = 0.0;
  const TopologyCertificate none = recover_interior(surface, options).certificate;
  EXPECT_TRUE(none.gave_up);
  EXPECT_NE(none.topology, TopologyVerdict::kProven);
  EXPECT_GT(none.boundary_faces_missing, 0U);
  options.effort = std::numeric_limits<double>::infinity();
  const InteriorTetrahedra unbounded = recover_interior(surface, options);
  EXPECT_FALSE(unbounded.certificate.gave_up);
  EXPECT_EQ(unbounded.certificate.topology, TopologyVerdict::kProven);
  options.effort = 1.0;
  EXPECT_EQ(unbounded.tetrahedra, recover_interior(surface, options).tetrahedra);
}

// Bodies that overlap: the attempts at what can't be proven are bounded by effort, too.
TEST(Recovery, EndsAtOnceOnOverlappingBodiesWithoutEffort) {
  const TriangleSurface two = fixtures::joined(
      fixtures::sphere(2),
      fixtures::rotated(fixtures::moved(fixtures::sphere(2), Vec3(1.1, 0.13, 0.07)), 0.3,
                        Vec3(1, 2, 3)));
  RecoveryOptions options;
  options.known_crossings = 100;  // so that it is cut at once
  const TopologyCertificate full = recover_interior(two, options).certificate;
  options.effort = 0.0;
  const TopologyCertificate none = recover_interior(two, options).certificate;
  EXPECT_GT(none.boundary_faces_missing, full.boundary_faces_missing);
}

TEST(Recovery, IsTheSameInEveryRun) {
  const TriangleSurface surface = squeezed(fixtures::torus(24, 10, 1.0, 0.3));
  const InteriorTetrahedra first = recover_interior(surface, {});
  const InteriorTetrahedra second = recover_interior(surface, {});
  EXPECT_EQ(first.tetrahedra, second.tetrahedra);
  EXPECT_EQ(first.neighbours, second.neighbours);
}

TEST(Recovery, CanKeepTheInputSurfaceAsItIs) {
  const TriangleSurface surface =
      fixtures::rotated(fixtures::torus(40, 16, 1.0, 0.3), 0.7, Vec3(1, 2, 3));
  RecoveryOptions options;
  options.recover_input_surface = true;
  const InteriorTetrahedra interior = recover_interior(surface, options);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kProven);
  EXPECT_EQ(interior.certificate.surface_flips, 0U);
  ASSERT_EQ(interior.certificate.points_added, 0U);
  EXPECT_EQ(canonical_sorted(interior.boundary), canonical_sorted(surface.triangles));
}

TEST(Recovery, IgnoresVerticesInNoTriangle) {
  TriangleSurface surface = fixtures::torus(24, 10, 1.0, 0.3);
  surface.points.emplace_back(1.0, 0.0, 0.0);  // inside the tube
  expect_proven(surface, {1, 1, 0});
}

TEST(Recovery, RefusesDuplicatePoints) {
  const TriangleSurface sphere = fixtures::sphere(1);
  try {
    recover_interior(fixtures::joined(sphere, sphere), {});
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), "duplicate_vertices");
    const std::string count = ": " + std::to_string(sphere.points.size()) + ". ";
    EXPECT_NE(std::string(error.what()).find(count), std::string::npos) << error.what();
  }
}

TEST(Recovery, StopsWhenAsked) {
  const Progress refuse([](double, const char*) { return false; });
  EXPECT_THROW(recover_interior(fixtures::sphere(2), {}, refuse), Cancelled);
}

// Two spheres joined to one overlapping solid can't be told from two: both are kept, each whole.
TEST(Recovery, LiftsTwoOverlappingSpheresApart) {
  const TriangleSurface two = fixtures::joined(
      fixtures::sphere(2),
      fixtures::rotated(fixtures::moved(fixtures::sphere(2), Vec3(1.1, 0.13, 0.07)), 0.3,
                        Vec3(1, 2, 3)));
  const InteriorTetrahedra lifted = recover_interior(two, {});
  EXPECT_EQ(lifted.certificate.betti, (BettiNumbers{2, 0, 0}));
  EXPECT_EQ(lifted.certificate.topology, TopologyVerdict::kCounted);
  RecoveryOptions fused;
  fused.lift_overlaps = false;
  const InteriorTetrahedra one = recover_interior(two, fused);
  EXPECT_EQ(one.certificate.betti, (BettiNumbers{1, 0, 0}));
  EXPECT_EQ(one.certificate.topology, TopologyVerdict::kFailed);
}

TEST(Recovery, ProvesTheSharedModels) {
  const std::vector<std::string> names = {"knot", "octopus", "hand", "dino", "femur", "handle"};
  if (fixtures::shared_model(names.front()).empty()) GTEST_SKIP();
  for (const std::string& name : names) {
    const TriangleSurface surface = fixtures::load_off(fixtures::shared_model(name));
    const InteriorTetrahedra interior = recover_interior(surface, {});
    EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kProven) << name;
    EXPECT_LE(interior.certificate.points_added, surface.points.size() / 100) << name;
  }
}

}  // namespace
}  // namespace mgf
