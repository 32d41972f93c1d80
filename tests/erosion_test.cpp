// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/erosion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "tests/voxel_solids.h"
#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/skeleton/theta_births.h"

namespace mgf::test {
namespace {

/// A solid with random f on its facets and random divergence scores on its edges.
struct Scene {
  InteriorTetrahedra interior;
  MedialComplex complex;
  std::vector<double> mgf;
  std::vector<double> score;
  ErosionOrder order;

  Scene(const std::vector<Cell>& cubes, unsigned seed)
      : interior(solid_of_cubes(cubes)), complex(build_medial_complex(interior)) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(0.5, 2.0);
    std::uniform_real_distribution<double> divergence(-1.0, 1.0);
    for (std::size_t f = 0; f < complex.facet_count(); ++f) mgf.push_back(value(random));
    for (std::size_t e = 0; e < complex.edge_count(); ++e) score.push_back(divergence(random));
    order = order_cells(complex, mgf, interior.points);
  }

  std::vector<Index> marks(double theta) const {
    return choose_marks(complex, score, order.edge_rank, theta, MarkingRule::kAll);
  }
  ErodedComplex erode(double theta, bool open_pockets = false) const {
    return Erosion(complex, order, mgf).run(marks(theta), score, open_pockets);
  }
};

long euler_characteristic(const ErodedComplex& eroded) {
  const auto alive = [](const std::vector<char>& cells) {
    return static_cast<long>(std::count(cells.begin(), cells.end(), 1));
  };
  return alive(eroded.vertex_alive) - alive(eroded.edge_alive) + alive(eroded.facet_alive);
}

/// Components of the live edges and vertices.
Index components(const MedialComplex& complex, const ErodedComplex& eroded) {
  DisjointSets sets(complex.vertex_count());
  Index count = 0;
  for (const char alive : eroded.vertex_alive) count += alive != 0 ? 1 : 0;
  for (Index e = 0; e < complex.edge_count(); ++e) {
    const auto& ends = complex.edge_vertices[e];
    if (eroded.edge_alive[e] != 0 && sets.join(ends[0], ends[1])) --count;
  }
  return count;
}

/// What a cell is ordered by, from its definition.
struct FullKey {
  std::vector<double> mgf;  // of its facets, descending
  bool is_vertex = false;
  double size = 0.0;
  Index cell = 0;
  bool operator<(const FullKey& other) const {
    return std::tie(mgf, is_vertex, size, cell) <
           std::tie(other.mgf, other.is_vertex, other.size, other.cell);
  }
};

std::vector<FullKey> full_keys(const Scene& scene, const std::vector<double>& mgf) {
  const MedialComplex& complex = scene.complex;
  const std::vector<Vec3>& points = scene.interior.points;
  std::vector<FullKey> keys(complex.edge_count() + complex.vertex_count());
  for (Index e = 0; e < complex.edge_count(); ++e) {
    const auto [a, b, c] = complex.edge_contacts[e];
    const std::array<double, 3> sides = {(points[a] - points[b]).norm(),
                                         (points[b] - points[c]).norm(),
                                         (points[c] - points[a]).norm()};
    for (const Index f : complex.edge_facets[e]) {
      if (f != kNone) keys[e].mgf.push_back(mgf[f]);
    }
    if (keys[e].mgf.empty()) keys[e].mgf = {*std::max_element(sides.begin(), sides.end())};
    keys[e].size = sides[0] + sides[1] + sides[2];
  }
  for (Index v = 0; v < complex.vertex_count(); ++v) {
    FullKey& key = keys[complex.edge_count() + v];
    std::set<Index> facets;
    for (const Index e : complex.vertex_edges[v]) {
      facets.insert(complex.edge_facets[e].begin(), complex.edge_facets[e].end());
    }
    facets.erase(kNone);
    for (const Index f : facets) key.mgf.push_back(mgf[f]);
    key.is_vertex = true;
    key.size = complex.radius[v];
  }
  for (Index cell = 0; cell < keys.size(); ++cell) {
    keys[cell].cell = cell;
    std::sort(keys[cell].mgf.rbegin(), keys[cell].mgf.rend());
    keys[cell].mgf.resize(6, 0.0);
  }
  return keys;
}

TEST(ErosionOrder, SortsByAllThatTheKeysSay) {
  const Scene scene(plate_of_cubes(4, 3), 3);
  std::vector<double> rough = scene.mgf;  // with ties
  for (double& f : rough) f = std::ceil(4.0 * f) / 4.0;
  for (const std::vector<double>& mgf : {scene.mgf, rough}) {
    std::vector<FullKey> keys = full_keys(scene, mgf);
    std::sort(keys.begin(), keys.end());
    for (const unsigned threads : {1U, 2U, 5U}) {
      const ErosionOrder order = order_cells(scene.complex, mgf, scene.interior.points, threads);
      ASSERT_EQ(order.cell_at.size(), keys.size());
      for (Index rank = 0; rank < keys.size(); ++rank) {
        ASSERT_EQ(order.cell_at[rank], keys[rank].cell);
      }
    }
  }
}

TEST(ErosionOrder, FollowsTheLargestIncidentMgf) {
  const Scene scene(plate_of_cubes(4, 4), 1);
  const auto largest = [&](Index e) {
    double f = 0.0;
    for (const Index facet : scene.complex.edge_facets[e]) {
      if (facet != kNone) f = std::max(f, scene.mgf[facet]);
    }
    return f;
  };
  std::vector<Index> edges;
  for (const Index cell : scene.order.cell_at) {
    if (cell < scene.complex.edge_count()) edges.push_back(cell);
  }
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (largest(edges[i]) > 0.0 && largest(edges[i - 1]) > 0.0) {
      EXPECT_LE(largest(edges[i - 1]), largest(edges[i]));
    }
  }
}

TEST(Erosion, LeavesAPointOfAPlateWithoutMarks) {
  const Scene scene(plate_of_cubes(6, 5), 2);
  const ErodedComplex eroded = scene.erode(-1.1);
  EXPECT_EQ(eroded.residual_facets, 0U);
  EXPECT_EQ(std::count(eroded.vertex_alive.begin(), eroded.vertex_alive.end(), 1), 1);
  EXPECT_EQ(std::count(eroded.edge_alive.begin(), eroded.edge_alive.end(), 1), 0);
}

TEST(Erosion, LeavesOneLoopOfARingWithoutMarks) {
  const Scene scene(ring_of_cubes(5), 3);
  const ErodedComplex eroded = scene.erode(-1.1);
  EXPECT_EQ(eroded.residual_facets, 0U);
  EXPECT_EQ(euler_characteristic(eroded), 0);
  EXPECT_EQ(components(scene.complex, eroded), 1U);
  std::vector<Index> degree(scene.complex.vertex_count(), 0);
  for (Index e = 0; e < scene.complex.edge_count(); ++e) {
    if (eroded.edge_alive[e] == 0) continue;
    for (const Index v : scene.complex.edge_vertices[e]) ++degree[v];
  }
  for (Index v = 0; v < degree.size(); ++v) {
    EXPECT_EQ(degree[v], eroded.vertex_alive[v] != 0 ? 2U : 0U);
  }
}

TEST(Erosion, KeepsEulerCharacteristicAndComponentsWhateverTheMarks) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const double theta : {-0.9, -0.5, 0.0}) {
      const Scene plate(plate_of_cubes(5, 4), seed);
      const Scene ring(ring_of_cubes(6), seed);
      EXPECT_EQ(euler_characteristic(plate.erode(theta)), 1) << seed;
      EXPECT_EQ(euler_characteristic(ring.erode(theta)), 0) << seed;
      EXPECT_EQ(components(plate.complex, plate.erode(theta)), 1U) << seed;
      EXPECT_EQ(components(ring.complex, ring.erode(theta)), 1U) << seed;
    }
  }
}

TEST(Erosion, ErodesNoMarkedEdgeUnlessAFacetWouldStay) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Scene scene(plate_of_cubes(6, 6), seed);
    const ErodedComplex eroded = scene.erode(-0.8);
    EXPECT_EQ(eroded.residual_facets, 0U);
    for (Index e = 0; e < scene.complex.edge_count(); ++e) {
      if (eroded.mark_score[e] == kUnmarkable) continue;
      EXPECT_EQ(eroded.edge_alive[e], 1) << seed;
    }
  }
}

TEST(Erosion, ReportsAClosedPocketAndKeepsIt) {
  const Scene scene(hollow_box_of_cubes(4), 4);
  const ErodedComplex eroded = scene.erode(-0.5);
  EXPECT_GT(eroded.residual_facets, 0U);
  EXPECT_EQ(eroded.pockets_opened, 0U);
  EXPECT_EQ(euler_characteristic(eroded), 2);
}

TEST(Erosion, OpensAClosedPocketWhenAsked) {
  const Scene scene(hollow_box_of_cubes(4), 4);
  const ErodedComplex eroded = scene.erode(-1.1, true);
  EXPECT_EQ(eroded.residual_facets, 0U);
  EXPECT_EQ(eroded.pockets_opened, 1U);
  EXPECT_EQ(euler_characteristic(eroded), 1);  // one facet given up: a void less
}

TEST(Erosion, CollapsesTheCellsOfBuriedContactsFirst) {
  std::vector<Cell> block;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) block.push_back({i, j, k});
    }
  }
  const Scene scene(block, 8);
  EXPECT_EQ(scene.complex.cell_count, 12U);  // 3 by 2 by 2 lattice points lie inside
  const ErodedComplex eroded = scene.erode(-1.1);
  EXPECT_EQ(eroded.residual_facets, 0U);
  EXPECT_EQ(euler_characteristic(eroded), 1);
  EXPECT_EQ(std::count(eroded.vertex_alive.begin(), eroded.vertex_alive.end(), 1), 1);
}

TEST(Marking, MarksAreNestedInTheta) {
  for (const MarkingRule rule : {MarkingRule::kAll, MarkingRule::kOnePerFacet}) {
    const Scene scene(plate_of_cubes(6, 6), 5);
    const auto strict = choose_marks(scene.complex, scene.score, scene.order.edge_rank, -0.6, rule);
    const auto loose = choose_marks(scene.complex, scene.score, scene.order.edge_rank, -0.2, rule);
    ASSERT_LT(strict.size(), loose.size());
    EXPECT_TRUE(std::equal(strict.begin(), strict.end(), loose.begin()));
  }
}

TEST(Marking, OnePerFacetMarksAtMostOneEdgeOfAFacet) {
  const Scene scene(plate_of_cubes(6, 6), 6);
  const auto marks = choose_marks(scene.complex, scene.score, scene.order.edge_rank, 0.0,
                                  MarkingRule::kOnePerFacet);
  ASSERT_FALSE(marks.empty());
  std::set<Index> used;
  for (const Index e : marks) {
    for (const Index facet : scene.complex.edge_facets[e]) {
      if (facet == kNone) continue;
      EXPECT_TRUE(used.insert(facet).second);
    }
  }
}

TEST(Marking, MarksCloseNoLoop) {
  const Scene scene(ring_of_cubes(5), 7);
  DisjointSets sets(scene.complex.vertex_count());
  for (const Index e : scene.marks(1.0)) {
    EXPECT_TRUE(sets.join(scene.complex.edge_vertices[e][0], scene.complex.edge_vertices[e][1]));
  }
}

/// The definition that theta births must reproduce: collapse unmarked leaf edges until none is
/// left, but keep the vertices that stay.
std::set<Index> collapse_leaves(const Scene& scene, const ErodedComplex& eroded, double theta,
                                const std::vector<Index>& staying) {
  std::set<Index> alive;
  std::vector<Index> degree(scene.complex.vertex_count(), 0);
  for (Index e = 0; e < scene.complex.edge_count(); ++e) {
    if (eroded.edge_alive[e] == 0) continue;
    alive.insert(e);
    for (const Index v : scene.complex.edge_vertices[e]) ++degree[v];
  }
  const auto is_leaf = [&](Index v) {
    return degree[v] == 1 && std::find(staying.begin(), staying.end(), v) == staying.end();
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const Index e : std::set<Index>(alive)) {
      const auto& ends = scene.complex.edge_vertices[e];
      const bool leaf = is_leaf(ends[0]) || is_leaf(ends[1]);
      if (!leaf || eroded.mark_score[e] < theta) continue;
      alive.erase(e);
      for (const Index v : ends) --degree[v];
      changed = true;
    }
  }
  return alive;
}

TEST(ThetaBirths, AgreeWithCollapsingLeavesAtEveryTheta) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    for (const auto& cubes : {plate_of_cubes(6, 5), ring_of_cubes(6)}) {
      const Scene scene(cubes, seed);
      const ErodedComplex eroded = scene.erode(0.0);
      const ThetaBirths births = compute_theta_births(scene.complex, eroded, scene.order, 0.0);
      for (const double theta : {-1.1, -0.95, -0.7, -0.4, -0.1, 0.0}) {
        std::set<Index> born;
        for (Index e = 0; e < scene.complex.edge_count(); ++e) {
          if (eroded.edge_alive[e] != 0 && births.edge[e] < theta) born.insert(e);
        }
        EXPECT_EQ(born, collapse_leaves(scene, eroded, theta, births.last_vertex))
            << seed << " " << theta;
      }
    }
  }
}

TEST(ThetaBirths, ATreeShrinksToItsWidestVertexAndALoopStays) {
  const Scene plate(plate_of_cubes(6, 5), 1);
  const ErodedComplex eroded_plate = plate.erode(0.0);
  const auto of_plate = compute_theta_births(plate.complex, eroded_plate, plate.order, 0.0);
  ASSERT_EQ(of_plate.last_vertex.size(), 1U);
  for (Index v = 0; v < plate.complex.vertex_count(); ++v) {
    if (eroded_plate.vertex_alive[v] == 0) continue;
    EXPECT_LE(plate.order.vertex_rank[v], plate.order.vertex_rank[of_plate.last_vertex[0]]);
  }
  const Scene ring(ring_of_cubes(6), 1);
  const ErodedComplex eroded_ring = ring.erode(0.0);
  const auto of_ring = compute_theta_births(ring.complex, eroded_ring, ring.order, 0.0);
  EXPECT_TRUE(of_ring.last_vertex.empty());
  std::size_t always = 0;
  for (Index e = 0; e < ring.complex.edge_count(); ++e) {
    always += eroded_ring.edge_alive[e] != 0 && of_ring.edge[e] == kAlwaysThere ? 1 : 0;
  }
  EXPECT_GE(always, 20U);  // once round a ring of 20 cubes
}

}  // namespace
}  // namespace mgf::test
