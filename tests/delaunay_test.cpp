// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/exact/predicates.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using CgalDelaunay =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase>>;

const std::vector<Index> kHull{0, 1, 2, 3, 4, 5, 6, 7};

// The corners of a cube, nearly; other points are to be added inside.
std::vector<Vec3> cube(double half) {
  std::vector<Vec3> points;
  for (unsigned i = 0; i < 8; ++i) {
    const double size = half * (1.0 + 0.01 * i);
    points.emplace_back((i & 1U) != 0 ? size : -size, (i & 2U) != 0 ? size : -size,
                        (i & 4U) != 0 ? size : -size);
  }
  return points;
}

std::set<Tetrahedron> corner_sets(const std::vector<Tetrahedron>& tetrahedra) {
  std::set<Tetrahedron> sets;
  for (Tetrahedron t : tetrahedra) {
    std::sort(t.begin(), t.end());
    sets.insert(t);
  }
  return sets;
}

std::set<Tetrahedron> corner_sets_of_cgal(const std::vector<Vec3>& points) {
  CgalDelaunay delaunay;
  for (Index i = 0; i < points.size(); ++i) {
    delaunay.insert(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()))->info() = i;
  }
  std::vector<Tetrahedron> tetrahedra;
  for (const auto cell : delaunay.finite_cell_handles()) {
    tetrahedra.push_back({cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
                          cell->vertex(3)->info()});
  }
  return corner_sets(tetrahedra);
}

void expect_sound(const std::vector<Vec3>& points, const TetrahedronArrays& arrays) {
  for (Index t = 0; t < arrays.corners.size(); ++t) {
    const Tetrahedron& c = arrays.corners[t];
    EXPECT_EQ(orient3d(points[c[0]], points[c[1]], points[c[2]], points[c[3]]), 1);
    if (t > 0) {
      Tetrahedron before = arrays.corners[t - 1];
      Tetrahedron here = c;
      std::sort(before.begin(), before.end());
      std::sort(here.begin(), here.end());
      EXPECT_LT(before, here);
    }
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = arrays.neighbours[t][i];
      if (u == kNone) continue;
      bool answered = false;
      for (unsigned j = 0; j < 4; ++j) {
        answered =
            answered || (arrays.neighbours[u][j] == t && is_glued(c, i, arrays.corners[u], j));
      }
      EXPECT_TRUE(answered);
    }
  }
}

void expect_as_cgal(const std::vector<Vec3>& points) {
  const TetrahedronArrays arrays = delaunay_tetrahedra(points, kHull);
  expect_sound(points, arrays);
  EXPECT_EQ(corner_sets(arrays.corners), corner_sets_of_cgal(points));
}

TEST(Delaunay, IsThatOfCgalOnPointsAnywhere) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (const std::size_t count : {0U, 1U, 10U, 2000U}) {
    std::vector<Vec3> points = cube(3.0);
    for (std::size_t i = 0; i < count; ++i) {
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    }
    expect_as_cgal(points);
  }
}

TEST(Delaunay, SettlesCosphericalPointsAsCgalDoesWhateverTheirOrder) {
  std::vector<Vec3> points;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      for (int z = 0; z < 6; ++z) points.emplace_back(0.25 * x, 0.5 * y, z);
    }
  }
  std::mt19937 random(2);
  for (int run = 0; run < 3; ++run) {
    std::vector<Vec3> all = cube(9.0);
    all.insert(all.end(), points.begin(), points.end());
    expect_as_cgal(all);
    std::shuffle(points.begin(), points.end(), random);
  }
}

// The last point makes way through all tetrahedra round the axis: more vertices than usual.
TEST(Delaunay, HasRoomForPointsThatSeeManyOthers) {
  std::vector<Vec3> points = cube(9.0);
  constexpr int kRound = 500;
  for (int i = 0; i < kRound; ++i) {
    const double angle = 0.0125 * i;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.001 * (i % 7));
  }
  points.emplace_back(0.0, 0.0, 1.5);
  points.emplace_back(0.0, 0.0, -1.5);
  points.emplace_back(0.0, 0.0, 0.1);
  expect_as_cgal(points);
}

TEST(Delaunay, RefusesPointsAtOnePlace) {
  std::vector<Vec3> points = cube(3.0);
  points.emplace_back(0.1, 0.2, 0.3);
  points.emplace_back(0.3, 0.2, 0.1);
  points.emplace_back(0.1, 0.2, 0.3);
  try {
    delaunay_tetrahedra(points, kHull);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), "duplicate_vertices");
  }
}

}  // namespace
}  // namespace mgf::test
