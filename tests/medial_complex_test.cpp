// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/medial/medial_complex.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/voxel_solids.h"
#include "vcg_ext/medial/placement.h"

namespace mgf::test {
namespace {

/// n tetrahedra round the edge from (0,0,0) to (0,0,1), whose numbers are `bottom` and `top`.
InteriorTetrahedra ring_about_axis(Index n, Index bottom, Index top) {
  std::vector<Vec3> points(n + 2);
  points[bottom] = {0, 0, 0};
  points[top] = {0, 0, 1};
  std::vector<Index> rim;
  for (Index i = 0; i < n + 2; ++i) {
    if (i != bottom && i != top) rim.push_back(i);
  }
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * i / n;
    points[rim[i]] = {std::cos(angle), std::sin(angle), 0.5};
  }
  std::vector<Tetrahedron> tetrahedra;
  for (Index i = 0; i < n; ++i) tetrahedra.push_back({bottom, top, rim[i], rim[(i + 1) % n]});
  return from_tetrahedra(std::move(points), std::move(tetrahedra));
}

long euler_characteristic(const MedialComplex& complex) {
  return static_cast<long>(complex.vertex_count()) - static_cast<long>(complex.edge_count()) +
         static_cast<long>(complex.facet_count());
}

TEST(MedialComplex, TetrahedraRoundAnEdgeMakeOneFacet) {
  const MedialComplex complex = build_medial_complex(ring_about_axis(7, 0, 1));
  ASSERT_EQ(complex.facet_count(), 1U);
  EXPECT_EQ(complex.facet_contacts[0].a, 0U);
  EXPECT_EQ(complex.facet_contacts[0].b, 1U);
  EXPECT_EQ(complex.facet_edges[0].size(), 7U);
  EXPECT_EQ(complex.edge_count(), 7U);
}

TEST(MedialComplex, FacetsAreRightHandedAboutTheirDelaunayEdge) {
  for (const auto& [bottom, top] : {std::pair<Index, Index>{0, 8}, {8, 0}, {3, 5}, {5, 3}}) {
    const InteriorTetrahedra interior = ring_about_axis(7, bottom, top);
    const MedialComplex complex = build_medial_complex(interior);
    const Row<Index> ring = complex.facet_vertices[0];
    const Vec3 axis =
        interior.points[complex.facet_contacts[0].b] - interior.points[complex.facet_contacts[0].a];
    const Vec3 turn =
        tetrahedron_centroid(interior, ring[0]).cross(tetrahedron_centroid(interior, ring[1]));
    EXPECT_GT(turn.dot(axis), 0.0) << bottom << " " << top;
  }
}

TEST(MedialComplex, FacetVerticesLieBetweenTheirEdges) {
  const MedialComplex complex = build_medial_complex(solid_of_cubes(plate_of_cubes(4, 3)));
  ASSERT_GT(complex.facet_count(), 0U);
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    const Row<Index> edges = complex.facet_edges[f];
    const Row<Index> vertices = complex.facet_vertices[f];
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto& ends = complex.edge_vertices[edges[i]];
      const Index from = vertices[i];
      const Index to = vertices[(i + 1) % vertices.size()];
      EXPECT_TRUE((ends[0] == from && ends[1] == to) || (ends[0] == to && ends[1] == from));
    }
  }
}

TEST(MedialComplex, EveryFacetOfAnEdgeIsDualToTheSideItIsListedFor) {
  const MedialComplex complex = build_medial_complex(solid_of_cubes(plate_of_cubes(4, 3)));
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const Triangle& dual = complex.edge_contacts[e];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index facet = complex.edge_facets[e][i];
      if (facet == kNone) continue;
      const VertexPair& contacts = complex.facet_contacts[facet];
      EXPECT_EQ(contacts.a, std::min(dual[(i + 1) % 3], dual[(i + 2) % 3]));
      EXPECT_EQ(contacts.b, std::max(dual[(i + 1) % 3], dual[(i + 2) % 3]));
    }
  }
}

TEST(MedialComplex, HasTheEulerCharacteristicOfTheSolid) {
  EXPECT_EQ(euler_characteristic(build_medial_complex(solid_of_cubes(plate_of_cubes(5, 4)))), 1);
  EXPECT_EQ(euler_characteristic(build_medial_complex(solid_of_cubes(ring_of_cubes(5)))), 0);
  EXPECT_EQ(euler_characteristic(build_medial_complex(solid_of_cubes(hollow_box_of_cubes(4)))), 2);
}

TEST(MedialComplex, CircumcentresAreEquidistantFromTheirContacts) {
  const InteriorTetrahedra interior = solid_of_cubes(plate_of_cubes(3, 3));
  const MedialComplex complex = build_medial_complex(interior);
  for (Index t = 0; t < complex.vertex_count(); ++t) {
    for (const Index corner : interior.tetrahedra[t]) {
      EXPECT_NEAR((interior.points[corner] - complex.position[t]).norm(), complex.radius[t],
                  1e-9 * complex.radius[t]);
    }
  }
}

TEST(Placement, BringsACircumcentreBackInside) {
  // A flat tetrahedron, its circumcentre far below.
  const InteriorTetrahedra interior =
      from_tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.05}}, {{0, 1, 2, 3}});
  MedialComplex complex = build_medial_complex(interior);
  ASSERT_LT(complex.position[0].z(), 0.0);
  place_voronoi_vertices(interior, complex);
  EXPECT_EQ(complex.displaced[0], 1);
  EXPECT_GT(complex.position[0].z(), 0.0);
  EXPECT_LT(complex.position[0].z(), 0.05);
}

TEST(Placement, LeavesACircumcentreThatLiesInANeighbour) {
  // Two tetrahedra whose union holds the circumcentre of the flat one.
  const InteriorTetrahedra interior =
      from_tetrahedra({{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {0.5, 0.3, 0.1}, {0.5, 0.3, -6.0}},
                      {{0, 1, 2, 3}, {0, 2, 1, 4}});
  MedialComplex complex = build_medial_complex(interior);
  const Vec3 before = complex.position[0];
  ASSERT_LT(before.z(), 0.0);
  place_voronoi_vertices(interior, complex);
  EXPECT_EQ(complex.displaced[0], 0);
  EXPECT_EQ(complex.position[0], before);
}

TEST(Placement, TakesACircumcentreOffTheSurface) {
  // A face through the centre of the ball: the circumcentre is right on it.
  const InteriorTetrahedra interior =
      from_tetrahedra({{5, 0, 0}, {-3, 4, 0}, {-3, -4, 0}, {0, 0, 5}}, {{0, 1, 2, 3}});
  MedialComplex complex = build_medial_complex(interior);
  ASSERT_NEAR(complex.position[0].norm(), 0.0, 1e-12);
  place_voronoi_vertices(interior, complex);
  EXPECT_EQ(complex.displaced[0], 1);
  EXPECT_GT(complex.position[0].z(), 0.1);
}

TEST(Placement, PutsALoneFlatTetrahedronsVertexAtItsCentroid) {
  const InteriorTetrahedra interior =
      from_tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  MedialComplex complex = build_medial_complex(interior);
  place_voronoi_vertices(interior, complex);
  EXPECT_TRUE(complex.position[0].isApprox(Vec3(0.5, 0.5, 0.0)));
  EXPECT_NEAR(complex.radius[0], std::sqrt(0.5), 1e-15);
}

TEST(Placement, PutsAFlatTetrahedronsVertexBetweenItsNeighbours) {
  // A cocircular square seen from an apex on either side: its own circumcentre is anywhere.
  const InteriorTetrahedra interior = from_tetrahedra(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-16}, {0.5, 0.5, 0.8}, {0.5, 0.5, -0.8}},
      {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 2, 3, 4}, {1, 0, 3, 5}, {1, 3, 2, 5}});
  MedialComplex complex = build_medial_complex(interior);
  place_voronoi_vertices(interior, complex);
  EXPECT_NEAR(complex.position[0].z(), 0.0, 1e-9);
  EXPECT_NEAR(complex.position[0].x(), 0.5, 1e-9);
}

}  // namespace
}  // namespace mgf::test
