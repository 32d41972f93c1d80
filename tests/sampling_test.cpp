// SPDX-License-Identifier: GPL-3.0-or-later
// Added vertices: enough, none where none are needed, and never a different surface.
#include "vcg_ext/input/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/core/random.h"
#include "vcg_ext/exact/self_intersections.h"
#include "vcg_ext/input/diagnosis.h"
#include "vcg_ext/input/point_insertion.h"

namespace mgf {
namespace {

using fixtures::box;
using fixtures::coarse_cylinder;
using fixtures::l_block;
using fixtures::sphere;

Vec3 area_vector(const TriangleSurface& s, Index f) {
  const Triangle& t = s.triangles[f];
  return 0.5 * (s.points[t[1]] - s.points[t[0]]).cross(s.points[t[2]] - s.points[t[0]]);
}

double longest_edge(const TriangleSurface& s) {
  double longest = 0.0;
  for (Index f = 0; f < s.triangles.size(); ++f) longest = std::max(longest, longest_side(s, f));
  return longest;
}

/// The refined surface is closed and manifold, keeps the input's vertices, and the parts of each
/// face lie in it, look its way and make up its area.
void expect_refinement(const RefinedSurface& refined, const TriangleSurface& original) {
  const TriangleSurface& s = refined.surface;
  ASSERT_EQ(refined.input_points, original.points.size());
  ASSERT_EQ(refined.parent_face.size(), s.triangles.size());
  EXPECT_TRUE(std::equal(original.points.begin(), original.points.end(), s.points.begin()));
  EXPECT_TRUE(check_manifold(s, make_edge_table(s.triangles)).empty());
  const double tolerance = 1e-12 * bounding_box_diagonal(original.points);
  std::vector<double> area(original.triangles.size(), 0.0);
  for (Index f = 0; f < s.triangles.size(); ++f) {
    const Index parent = refined.parent_face[f];
    ASSERT_LT(parent, original.triangles.size());
    const Triangle& t = original.triangles[parent];
    for (const Index v : s.triangles[f]) {
      const Vec3 nearest = nearest_point_of_triangle(s.points[v], original.points[t[0]],
                                                     original.points[t[1]], original.points[t[2]]);
      EXPECT_LE((nearest - s.points[v]).norm(), tolerance);
    }
    EXPECT_GE(area_vector(s, f).dot(area_vector(original, parent).normalized()),
              -tolerance * longest_edge(original));
    area[parent] += area_vector(s, f).norm();
  }
  for (Index f = 0; f < area.size(); ++f) {
    EXPECT_NEAR(area[f], area_vector(original, f).norm(), tolerance * longest_edge(original));
  }
}

bool is_unchanged(const RefinedSurface& refined, const TriangleSurface& original) {
  return refined.surface.points == original.points &&
         refined.surface.triangles == original.triangles;
}

TEST(Sampling, RefinesWhatHasTooFewVertices) {
  for (const TriangleSurface& surface :
       {box(3, 2, 1), box(1, 1, 1), box(10, 1, 1), l_block(), coarse_cylinder(24, 0.5, 3.0),
        fixtures::tetrahedron(), sphere(0)}) {
    const RefinedSurface refined = refine_sampling(surface, {});
    expect_refinement(refined, surface);
    EXPECT_GT(refined.surface.points.size(), 2 * surface.points.size());
    EXPECT_LT(refined.surface.points.size(), 1000U);
    EXPECT_TRUE(exact::self_intersections(refined.surface).empty());
    const Shells shells = find_pieces(refined.surface, make_edge_table(refined.surface.triangles));
    EXPECT_TRUE(too_coarse_faces(refined.surface, SurfaceTree(refined.surface), shells).empty());
  }
}

TEST(Sampling, KeepsEdgesShortForTheThickness) {
  // The box is 1 thick beneath its large faces: no edge there may be longer than 0.71.
  const RefinedSurface refined = refine_sampling(box(3, 2, 1), {});
  for (Index f = 0; f < refined.surface.triangles.size(); ++f) {
    const Vec3 area = area_vector(refined.surface, f);
    if (area.cwiseAbs().z() < 0.99 * area.norm()) continue;
    EXPECT_LE(longest_side(refined.surface, f), 0.7072);
  }
}

TEST(Sampling, LeavesFineMeshesAlone) {
  for (const TriangleSurface& surface :
       {sphere(2), sphere(3), fixtures::torus(24, 12, 2, 0.5), fixtures::torus(40, 20, 2, 0.5)}) {
    EXPECT_TRUE(is_unchanged(refine_sampling(surface, {}), surface));
  }
}

TEST(Sampling, LeavesScansAlone) {
  for (const std::string name : {"armadillo_25001", "camel", "dino", "femur", "genus3_6652", "hand",
                                 "handle", "horse_15563", "knot", "man_8904"}) {
    const std::string path = fixtures::shared_model(name);
    if (path.empty()) GTEST_SKIP() << "no shared models";
    const TriangleSurface surface = fixtures::load_off(path);
    EXPECT_TRUE(is_unchanged(refine_sampling(surface, {}), surface)) << name;
  }
}

TEST(Sampling, RefinesOnlyTheShellThatNeedsIt) {
  const TriangleSurface both =
      fixtures::joined(sphere(3), fixtures::moved(box(3, 2, 1), Vec3(5, 0, 0)));
  const RefinedSurface refined = refine_sampling(both, {});
  expect_refinement(refined, both);
  const std::size_t sphere_faces = sphere(3).triangles.size();
  EXPECT_EQ(std::count_if(refined.parent_face.begin(), refined.parent_face.end(),
                          [&](Index f) { return f < sphere_faces; }),
            static_cast<std::ptrdiff_t>(sphere_faces));
  EXPECT_GT(refined.surface.points.size(), both.points.size() + 50U);
}

TEST(Sampling, IsTheSameAtAnyScale) {
  const RefinedSurface refined = refine_sampling(l_block(), {});
  for (const double factor : {1.0 / 1048576.0, 1048576.0}) {
    const RefinedSurface other = refine_sampling(fixtures::scaled(l_block(), factor), {});
    EXPECT_EQ(other.surface.triangles, refined.surface.triangles);
    EXPECT_EQ(other.surface.points, fixtures::scaled(refined.surface, factor).points);
  }
}

TEST(Sampling, StaysWithinItsBudget) {
  const TriangleSurface plate = box(1, 1, 0.001);
  const RefinedSurface refined = refine_sampling(plate, {});
  expect_refinement(refined, plate);
  EXPECT_LE(refined.surface.points.size(), 8008U);
  EXPECT_GT(refined.surface.points.size(), 2000U);  // half the length takes up to four times more
}

TEST(Sampling, SpendsManyPointsOnlyWhereFewDoNotSuffice) {
  for (const double thickness : {0.09, 0.06, 0.04, 0.03}) {
    const TriangleSurface plate = box(1, 1, thickness);
    const std::size_t few = plate.points.size() + detail::kMostToRefine;
    const double longer = 1.5 * detail::kEdgePerThickness * thickness;
    const bool few_suffice = refine_sampling(plate, {longer}).surface.points.size() < few;
    const std::size_t points = refine_sampling(plate, {}).surface.points.size();
    EXPECT_GT(points, 500U) << thickness;
    EXPECT_TRUE(!few_suffice || points <= few) << thickness;
  }
}

TEST(Sampling, SplitsTheSameInStepsAsAtOnce) {
  const FixedLength allowed(0.05);
  constexpr std::size_t kMost = 100000;
  SurfaceRefiner at_once(unrefined(l_block()));
  SurfaceRefiner in_steps = at_once;
  EXPECT_TRUE(WorstFirstSplitter(at_once, allowed).run(1.0, kMost, {}));
  WorstFirstSplitter splitter(in_steps, allowed);
  std::size_t points = in_steps.surface().surface.points.size();
  for (const double excess : {8.0, 4.0, 2.0, 1.0}) {
    EXPECT_TRUE(splitter.run(excess, kMost, {}));
    EXPECT_LE(splitter.worst_excess(), excess);
    EXPECT_LE(longest_edge(in_steps.surface().surface), 0.05 * excess);
    EXPECT_GT(in_steps.surface().surface.points.size(), points);
    points = in_steps.surface().surface.points.size();
  }
  EXPECT_EQ(in_steps.triangles(), at_once.triangles());
  EXPECT_EQ(in_steps.surface().surface.points, at_once.surface().surface.points);
}

TEST(Sampling, MakesNoNeedlesBesideAThinPlate) {
  // The rim is thick beneath but narrow; left in one piece its diagonals would end up in needles.
  const auto slimness = [](const TriangleSurface& s, Index f) {
    return longest_side(s, f) * longest_side(s, f) / area_vector(s, f).norm();
  };
  const TriangleSurface plate = box(1, 1, 0.05);
  const RefinedSurface refined = refine_sampling(plate, {});
  expect_refinement(refined, plate);
  for (Index f = 0; f < refined.surface.triangles.size(); ++f) {
    EXPECT_LE(slimness(refined.surface, f), 3.0 * slimness(plate, refined.parent_face[f]));
  }
}

TEST(Sampling, KeepsToAFixedLength) {
  for (const double length : {0.1, 0.5, 5.0}) {
    const RefinedSurface refined = refine_sampling(box(3, 2, 1), {length});
    expect_refinement(refined, box(3, 2, 1));
    EXPECT_LE(longest_edge(refined.surface), length);
  }
  EXPECT_TRUE(is_unchanged(refine_sampling(sphere(2), {1.0}), sphere(2)));
}

TEST(Sampling, CanBeSwitchedOff) {
  EXPECT_TRUE(is_unchanged(refine_sampling(box(3, 2, 1), {0.0}), box(3, 2, 1)));
}

TEST(Sampling, RefusesImpossibleLengths) {
  for (const double length : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    try {
      refine_sampling(box(3, 2, 1), {length});
      FAIL() << "not refused";
    } catch (const InputError& error) {
      EXPECT_EQ(error.code(), "sampling_negative");
    }
  }
  try {
    refine_sampling(box(3, 2, 1), {1e-9});
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), "sampling_too_fine");
  }
}

// So far from the origin that coordinates are multiples of 1/8: midpoints are rounded off their
// edges, and the parts of a face don't lie in one plane.
TEST(Sampling, EndsWhereCoordinatesHaveFewDigits) {
  const Vec3 far(1e15, -1e15, 1e15);  // doubles there are 1/8 apart
  for (const TriangleSurface& surface :
       {fixtures::moved(fixtures::torus(24, 10, 3.0, 1.5), far), fixtures::moved(box(4, 3, 2), far),
        fixtures::moved(coarse_cylinder(12, 1.5, 3.0), far)}) {
    EXPECT_LT(refine_sampling(surface, {}).surface.points.size(), 30000U);
    SamplingOptions fixed;
    fixed.length = 0.1;
    EXPECT_LT(refine_sampling(surface, fixed).surface.points.size(), 30000U);
  }
}

TEST(Sampling, CanBeCancelled) {
  const Progress impatient([](double, const char*) { return false; });
  EXPECT_THROW(refine_sampling(box(3, 2, 1), {0.02}, impatient), Cancelled);
}

TEST(PointInsertion, GivesEachPointItsNumberAndPlace) {
  const TriangleSurface surface = fixtures::torus(20, 10, 2, 0.7);
  const SurfaceTree tree(surface);
  Random random(17);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) {
    points.emplace_back(0.006 * random.below(1000) - 3.0, 0.006 * random.below(1000) - 3.0,
                        0.002 * random.below(1000) - 1.0);
  }
  const RefinedSurface refined = insert_points(unrefined(surface), points);
  ASSERT_EQ(refined.surface.points.size(), surface.points.size() + points.size());
  expect_refinement(refined, surface);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(refined.surface.points[surface.points.size() + i], tree.nearest(points[i]).position);
  }
}

TEST(PointInsertion, PutsManyPointsIntoOneFace) {
  const TriangleSurface surface = fixtures::tetrahedron();
  std::vector<Vec3> points;
  for (int i = 1; i < 10; ++i) {
    for (int j = 1; i + j < 10; ++j) points.emplace_back(0.1 * i, 0.1 * j, 0.0);
  }
  const RefinedSurface refined = insert_points(unrefined(surface), points);
  expect_refinement(refined, surface);
  EXPECT_TRUE(exact::self_intersections(refined.surface).empty());
}

TEST(PointInsertion, SplitsEdgesForPointsOnThem) {
  const TriangleSurface surface = box(2, 2, 2);
  const RefinedSurface refined =
      insert_points(unrefined(surface), {Vec3(1, 0, 0), Vec3(0.5, 0, 0), Vec3(1.5, 0, 0)});
  expect_refinement(refined, surface);
  EXPECT_EQ(refined.surface.triangles.size(), 18U);
  for (Index f = 0; f < refined.surface.triangles.size(); ++f) {
    EXPECT_GT(area_vector(refined.surface, f).norm(), 0.1);
  }
}

TEST(PointInsertion, GivesAPointAtAVertexItsOwnVertex) {
  const TriangleSurface surface = sphere(1);
  const Vec3 vertex = surface.points[7];
  const RefinedSurface refined = insert_points(unrefined(surface), {vertex, vertex});
  ASSERT_EQ(refined.surface.points.size(), surface.points.size() + 2);
  EXPECT_EQ(refined.surface.points.back(), vertex);
  expect_refinement(refined, surface);
}

TEST(PointInsertion, GoesOnFromARefinedSurface) {
  const RefinedSurface sampled = refine_sampling(box(3, 2, 1), {});
  const std::vector<Vec3> points{Vec3(1.3, 0.9, 1.0), Vec3(2.1, 0.0, 0.3)};
  const RefinedSurface refined = insert_points(sampled, points);
  expect_refinement(refined, box(3, 2, 1));
  EXPECT_EQ(refined.surface.points.size(), sampled.surface.points.size() + 2);
  EXPECT_TRUE(is_unchanged(insert_points(sampled, {}), sampled.surface));
}

}  // namespace
}  // namespace mgf
