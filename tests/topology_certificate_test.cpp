// SPDX-License-Identifier: GPL-3.0-or-later
// What the proof stands on: each check notices what it is for, and moves can be taken back.
#include "vcg_ext/medial/topology_certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "tests/fixtures.h"
#include "tests/voxel_solids.h"
#include "vcg_ext/core/random.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/medial/local_moves.h"
#include "vcg_ext/medial/ray_winding.h"
#include "vcg_ext/medial/recover_interior.h"

namespace mgf::test {
namespace {

InteriorTetrahedra proven_torus() {
  InteriorTetrahedra interior = recover_interior(fixtures::torus(24, 10, 1.0, 0.3), {});
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kProven);
  return interior;
}

BettiNumbers betti_of(const InteriorTetrahedra& interior) {
  return glued_topology(interior.tetrahedra, interior.neighbours).betti;
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
  const auto [a, b, c] = wanted.front();
  wanted.push_back({b, a, c});  // the other side of that face
  certify(interior, wanted, true);
  EXPECT_EQ(interior.certificate.boundary_faces_missing, 1U);
  EXPECT_EQ(interior.certificate.boundary_faces_extra, 0U);
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

// The interior that the tetrahedra fill, glued where they share a face.
InteriorTetrahedra interior_of(const std::vector<Vec3>& points,
                               const std::vector<Tetrahedron>& tetrahedra,
                               const BettiNumbers& expected) {
  InteriorTetrahedra interior;
  interior.points = points;
  interior.input_points = to_index(points.size());
  interior.tetrahedra = tetrahedra;
  for (Index t = 0; t < tetrahedra.size(); ++t) {
    interior.neighbours.push_back({kNone, kNone, kNone, kNone});
    for (unsigned i = 0; i < 4; ++i) {
      for (Index u = 0; u < tetrahedra.size(); ++u) {
        for (unsigned j = 0; j < 4; ++j) {
          if (is_glued(tetrahedra[t], i, tetrahedra[u], j)) interior.neighbours[t][i] = u;
        }
      }
    }
  }
  collect_boundary(interior);
  interior.certificate.expected = expected;
  certify(interior, interior.boundary, true);
  return interior;
}

const std::vector<Vec3> kCorners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(Certificate, ProvesATetrahedronUnlessItIsFlat) {
  const InteriorTetrahedra whole = interior_of(kCorners, {{0, 1, 2, 3}}, {1, 0, 0});
  EXPECT_EQ(whole.certificate.topology, TopologyVerdict::kProven);
  std::vector<Vec3> corners = kCorners;
  corners[3] = Vec3(0.25, 0.25, 0.0);
  const InteriorTetrahedra flat = interior_of(corners, {{0, 1, 2, 3}}, {1, 0, 0});
  EXPECT_EQ(flat.certificate.tetrahedra_not_positive, 1U);
  EXPECT_EQ(flat.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, OfExactPointsKnowsBetterThanTheirDoubles) {
  for (const Index exactly_flat : {0U, 1U}) {
    InteriorTetrahedra interior = interior_of(kCorners, {{0, 1, 2, 3}}, {1, 0, 0});
    interior.points[3].z() = 0.0;  // by rounding
    interior.certificate.points_added = interior.certificate.exact_points = 1;
    interior.certificate.tetrahedra_not_positive = exactly_flat;
    certify(interior, interior.boundary, true);
    EXPECT_EQ(interior.certificate.tetrahedra_flattened, 1U);
    EXPECT_EQ(interior.certificate.tetrahedra_not_positive, exactly_flat);
    EXPECT_EQ(interior.certificate.topology,
              exactly_flat != 0 ? TopologyVerdict::kCounted : TopologyVerdict::kProven);
    EXPECT_EQ(interior.certificate.isotopic, exactly_flat == 0);
  }
}

TEST(Certificate, NoticesContradictionsOfTheFlood) {
  InteriorTetrahedra interior = proven_torus();
  interior.certificate.winding_conflicts = 1;
  certify(interior, interior.boundary, true);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, NoticesABuriedVertex) {
  std::vector<Vec3> points = kCorners;
  points.emplace_back(0.25, 0.25, 0.25);
  const InteriorTetrahedra interior =
      interior_of(points, {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}}, {1, 0, 0});
  EXPECT_EQ(interior.certificate.interior_vertices, 1U);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, NoticesTetrahedraThatMerelyTouch) {
  std::vector<Vec3> points = kCorners;
  for (const Vec3& p : kCorners) points.emplace_back(-p);
  const InteriorTetrahedra at_a_vertex =
      interior_of(points, {{0, 1, 2, 3}, {0, 5, 7, 6}}, {2, 0, 0});
  EXPECT_EQ(at_a_vertex.certificate.betti, (BettiNumbers{2, 0, 0}));
  EXPECT_EQ(at_a_vertex.certificate.topology, TopologyVerdict::kCounted);
  const InteriorTetrahedra at_an_edge =
      interior_of(points, {{0, 1, 2, 3}, {0, 1, 6, 7}}, {2, 0, 0});
  EXPECT_EQ(at_an_edge.certificate.tetrahedra_not_positive, 0U);
  EXPECT_EQ(at_an_edge.certificate.topology, TopologyVerdict::kCounted);
}

TEST(Certificate, NoticesNeighboursAcrossTheWrongFace) {
  InteriorTetrahedra interior = proven_torus();
  const auto inner = [&](Index t) {
    const auto& around = interior.neighbours[t];
    return std::find(around.begin(), around.end(), kNone) == around.end();
  };
  Index t = 0;
  while (!inner(t)) ++t;
  std::swap(interior.neighbours[t][0], interior.neighbours[t][1]);
  certify(interior, interior.boundary, true);
  EXPECT_EQ(interior.certificate.topology, TopologyVerdict::kFailed);
}

TEST(TriangulatedBox, HasPositiveTetrahedraThatAnswerEachOther) {
  const BoxedSurface plain = boxed(in_spatial_order(fixtures::torus(12, 6, 1.0, 0.3)));
  const auto is_box = [&](std::vector<std::array<Index, 4>> neighbours, std::size_t hull) {
    return is_triangulated_box(
        TetrahedralMesh(plain.points, plain.delaunay.corners, std::move(neighbours)), hull);
  };
  const std::vector<std::array<Index, 4>>& neighbours = plain.delaunay.neighbours;
  EXPECT_TRUE(is_box(neighbours, kBoxFaces));
  EXPECT_FALSE(is_box(neighbours, kBoxFaces - 1));
  std::vector<std::array<Index, 4>> swapped = neighbours;
  std::swap(swapped[0][0], swapped[0][1]);
  EXPECT_FALSE(is_box(swapped, kBoxFaces));

  const std::array<Index, 4> alone{kNone, kNone, kNone, kNone};
  EXPECT_TRUE(is_triangulated_box(TetrahedralMesh(kCorners, {{0, 1, 2, 3}}, {alone}), 4));
  EXPECT_FALSE(is_triangulated_box(TetrahedralMesh(kCorners, {{1, 0, 2, 3}}, {alone}), 4));
  std::vector<Vec3> flat = kCorners;
  flat[3].z() = 0.0;
  EXPECT_FALSE(is_triangulated_box(TetrahedralMesh(flat, {{0, 1, 2, 3}}, {alone}), 4));
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
