// SPDX-License-Identifier: GPL-3.0-or-later
// Pair geodesics against CGAL's independent exact shortest paths.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <gtest/gtest.h>

#include "geodesics_fixtures.h"
#include "vcg_ext/geodesics/compute_pair_geodesics.h"

namespace mgf::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Oracle =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

/// Largest relative difference between our lengths and CGAL's; pairs are sorted by a.
double largest_difference(const TriangleSurface& surface, const std::vector<VertexPair>& pairs) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> at;
  for (const Vec3& p : surface.points) at.push_back(mesh.add_vertex({p.x(), p.y(), p.z()}));
  for (const Triangle& t : surface.triangles) mesh.add_face(at[t[0]], at[t[1]], at[t[2]]);
  Oracle oracle(mesh);
  const PairGeodesics result = compute_pair_geodesics(surface, pairs, {}, {});
  double largest = 0.0;
  Index source = kNone;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(result.certification[i], Certification::kProven);
    if (pairs[i].a != source) {
      source = pairs[i].a;
      oracle.remove_all_source_points();
      oracle.add_source_point(at[source]);
    }
    const double expected = oracle.shortest_distance_to_source_points(at[pairs[i].b]).first;
    largest = std::max(largest, std::abs(result.length[i] - expected) / expected);
  }
  return largest;
}

/// All near vertices of a few sources, as pairs sorted by a.
std::vector<VertexPair> pairs_of_few_sources(const TriangleSurface& surface, double radius,
                                             int sources, unsigned seed) {
  const double reach = radius * make_halfedge_mesh(surface).mean_edge;
  std::mt19937 random(seed);
  std::set<Index> starts;
  while (starts.size() < static_cast<std::size_t>(sources)) {
    starts.insert(to_index(random() % surface.points.size()));
  }
  std::vector<VertexPair> pairs;
  for (const Index a : starts) {
    for (Index b = a + 1; b < surface.points.size(); ++b) {
      if ((surface.points[a] - surface.points[b]).norm() < reach) pairs.push_back({a, b});
    }
  }
  return pairs;
}

TEST(GeodesicsOracle, AgreesOnRoughSpheres) {
  for (const double roughness : {0.05, 0.3, 0.6}) {
    const TriangleSurface sphere = bumpy_sphere(3, roughness, 11);
    EXPECT_LT(largest_difference(sphere, pairs_of_few_sources(sphere, 40.0, 6, 1)), 1e-9);
  }
}

TEST(GeodesicsOracle, AgreesOnFlatVertices) {
  const TriangleSurface fine = midpoint_subdivided(midpoint_subdivided(bumpy_sphere(1, 0.4, 3)));
  EXPECT_LT(largest_difference(fine, pairs_of_few_sources(fine, 40.0, 6, 2)), 1e-9);
}

class GeodesicsOracleOnModels : public ::testing::TestWithParam<const char*> {};

TEST_P(GeodesicsOracleOnModels, Agrees) {
  const TriangleSurface model = shared_model(GetParam());
  if (model.points.empty()) GTEST_SKIP() << "no shared models here";
  EXPECT_LT(largest_difference(model, pairs_of_few_sources(model, 9.0, 6, 3)), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Models, GeodesicsOracleOnModels,
                         ::testing::Values("octopus", "handle", "knot", "femur", "hand", "dino"));

}  // namespace
}  // namespace mgf::test
