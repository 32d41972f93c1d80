// SPDX-License-Identifier: GPL-3.0-or-later
// What the proof stands on: each check notices what it is for, and moves can be taken back.
#include "vcg_ext/medial/topology_certificate.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/fixtures.h"
#include "tests/voxel_solids.h"
#include "vcg_ext/core/random.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/medial/isotopy_guard.h"
#include "vcg_ext/medial/local_moves.h"
#include "vcg_ext/medial/ray_winding.h"
#include "vcg_ext/medial/recover_interior.h"
#include "vcg_ext/medial/surface_flips.h"

namespace mgf::test {
namespace {

InteriorTetrahedra proven_torus() {
  InteriorTetrahedra interior = recover_interior(fixtures::torus(24, 10, 1.0, 0.3), {});
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kProven);
  return interior;
}

BettiNumbers betti_of(const InteriorTetrahedra& interior) {
  return betti_numbers(dual_cells(interior.tetrahedra, interior.neighbours));
}

TEST(Certificate, HoldsWhenCheckedAgain) {
  InteriorTetrahedra interior = proven_torus();
  certify(interior, interior.boundary, true);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kProven);
}

TEST(Certificate, NoticesATetrahedronTurnedOver) {
  InteriorTetrahedra interior = proven_torus();
  std::swap(interior.tetrahedra[7][0], interior.tetrahedra[7][1]);
  std::swap(interior.neighbours[7][0], interior.neighbours[7][1]);
  certify(interior, interior.boundary, true);
  EXPECT_EQ(interior.certificate.tetrahedra_not_positive, 1U);
  EXPECT_NE(interior.certificate.topology, TopologyVerdict::kProven);
}

TEST(Certificate, NoticesOneSidedNeighbours) {
  InteriorTetrahedra interior = proven_torus();
  for (Index& neighbour : interior.neighbours[7]) neighbour = kNone;
  certify(interior, interior.boundary, true);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kFailed);
}

TEST(Certificate, NoticesFacesThatAreNotOfTheSurface) {
  InteriorTetrahedra interior = proven_torus();
  std::vector<Triangle> wanted = interior.boundary;
  wanted.pop_back();
  certify(interior, wanted, true);
  EXPECT_EQ(interior.certificate.boundary_faces_extra, 1U);
  EXPECT_EQ(interior.certificate.boundary_faces_missing, 0U);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, NoticesMissingFaces) {
  InteriorTetrahedra interior = proven_torus();
  std::vector<Triangle> wanted = interior.boundary;
  std::swap(wanted.front()[0], wanted.front()[1]);  // the other side of that face
  certify(interior, wanted, true);
  EXPECT_EQ(interior.certificate.boundary_faces_missing, 1U);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, IsOnlyACountWithoutAnEmbedding) {
  InteriorTetrahedra interior = proven_torus();
  certify(interior, interior.boundary, false);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, FailsOnTheWrongNumberOfLoops) {
  InteriorTetrahedra interior = proven_torus();
  interior.certificate.expected = {1, 0, 0};
  certify(interior, interior.boundary, true);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kFailed);
}

TEST(Certificate, IsIsotopicUnlessPointsWereRounded) {
  InteriorTetrahedra interior = proven_torus();
  EXPECT_TRUE(interior.certificate.isotopic);
  interior.certificate.points_added = 1;
  certify(interior, interior.boundary, true);
  EXPECT_FALSE(interior.certificate.isotopic);
  interior.certificate.points_added = 0;
  certify(interior, interior.boundary, false);
  EXPECT_FALSE(interior.certificate.isotopic);
}

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

TEST(Betti, AreThoseOfSolidsOfCubes) {
  EXPECT_EQ(betti_of(solid_of_cubes(plate_of_cubes(4, 3))), (BettiNumbers{1, 0, 0}));
  EXPECT_EQ(betti_of(solid_of_cubes(ring_of_cubes(5))), (BettiNumbers{1, 1, 0}));
  EXPECT_EQ(betti_of(solid_of_cubes(hollow_box_of_cubes(4))), (BettiNumbers{1, 0, 1}));
}

TEST(Betti, ExpectedOnesCountShellsAndHandles) {
  const TriangleSurface torus = fixtures::torus(12, 8, 1.0, 0.3);
  const TriangleSurface both =
      fixtures::joined(torus, fixtures::moved(fixtures::sphere(1), Vec3(4, 0, 0)));
  EXPECT_EQ(expected_betti_numbers(torus), (BettiNumbers{1, 1, 0}));
  EXPECT_EQ(expected_betti_numbers(both), (BettiNumbers{2, 1, 0}));
}

TEST(RayWinding, AgreesWithTheExactOne) {
  const TriangleSurface two = fixtures::joined(
      fixtures::sphere(2), fixtures::moved(fixtures::sphere(2), Vec3(0.9, 0.1, 0)));
  const RayWinding ray(two.points, two.triangles);
  const SurfaceTree tree(two);
  Random random(4);
  int doubly = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p(0.004 * random.below(1000) - 1.5, 0.003 * random.below(1000) - 1.5,
                 0.003 * random.below(1000) - 1.5);
    EXPECT_EQ(ray(p), tree.winding_number(p));
    doubly += tree.winding_number(p) == 2 ? 1 : 0;
  }
  EXPECT_GT(doubly, 10);
}

TEST(TetrahedralMesh, TakesMovesBack) {
  const OrderedSurface ordered = in_spatial_order(fixtures::torus(24, 10, 1.0, 0.3));
  const BoxedSurface plain = boxed(ordered);
  TetrahedralMesh mesh(plain.points, plain.delaunay.corners, plain.delaunay.neighbours);
  const ConstrainedSurface nothing(plain.points.size(), {});
  LocalMoves<SegmentObstacle> moves(mesh, nothing, SegmentObstacle{0, 100});
  const std::size_t slots = mesh.slot_count();
  mesh.open_journal();
  Random random(2);
  int made = 0;
  for (int i = 0; i < 3000; ++i) {
    const Index t = random.below(slots);
    if (mesh.alive(t) && moves.flip_face(t, random.below(4), 1000)) ++made;
  }
  ASSERT_GT(made, 100);
  ASSERT_TRUE(is_triangulated_box(mesh, kBoxFaces));
  mesh.roll_back(0);
  for (Index t = 0; t < slots; ++t) {
    ASSERT_EQ(mesh.corners(t), plain.delaunay.corners[t]);
    for (unsigned i = 0; i < 4; ++i) {
      ASSERT_EQ(mesh.neighbour(t, i), plain.delaunay.neighbours[t][i]);
    }
  }
  for (auto t = to_index(slots); t < mesh.slot_count(); ++t) ASSERT_FALSE(mesh.alive(t));
}

}  // namespace
}  // namespace mgf::test
