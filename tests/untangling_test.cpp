// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that cross near each other are parted by small moves; what crosses deeply is left.
#include "vcg_ext/input/untangling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/core/constants.h"
#include "vcg_ext/exact/self_intersections.h"
#include "vcg_ext/input/working_copy.h"
#include "vcg_ext/mgf_skeleton.h"

namespace mgf {
namespace {

using fixtures::joined;
using fixtures::moved;
using fixtures::sphere;
using fixtures::torus;

/// Pushes a corner of a face beyond the next one, so that faces round it lie upside down.
void turn_over(TriangleSurface& surface, Index face) {
  const Triangle& t = surface.triangles[face];
  const Vec3 beyond = surface.points[t[1]] - surface.points[t[0]];
  surface.points[t[0]] += 1.4 * beyond;
}

TriangleSurface with_faces_turned_over(TriangleSurface surface, const std::vector<Index>& faces) {
  for (const Index f : faces) turn_over(surface, f);
  return surface;
}

double mean_edge_length_at(const TriangleSurface& surface, Index vertex) {
  double sum = 0.0;
  double count = 0.0;
  for (const Triangle& t : surface.triangles) {
    if (std::find(t.begin(), t.end(), vertex) == t.end()) continue;
    for (const Index w : t) sum += (surface.points[w] - surface.points[vertex]).norm();
    count += 2.0;
  }
  return sum / count;
}

/// A closed tube of radius 0.4 along an eight, whose two strands are `distance` apart, centre to
/// centre, where one passes over the other.
TriangleSurface eight(double distance) {
  constexpr Index kAround = 160;
  constexpr Index kAcross = 24;
  TriangleSurface surface = torus(kAround, kAcross, 2.0, 0.4);
  for (Index i = 0; i < kAround; ++i) {
    const double u = 2.0 * kPi * i / kAround;
    const Vec3 centre(2.0 * std::sin(u), std::sin(2.0 * u), 0.5 * distance * std::cos(u));
    const Vec3 along(2.0 * std::cos(u), 2.0 * std::cos(2.0 * u), -0.5 * distance * std::sin(u));
    const Vec3 aside = along.cross(Vec3::UnitZ()).normalized();
    const Vec3 up = aside.cross(along).normalized();
    for (Index j = 0; j < kAcross; ++j) {
      const double v = 2.0 * kPi * j / kAcross;
      surface.points[i * kAcross + j] = centre + 0.4 * (std::cos(v) * aside + std::sin(v) * up);
    }
  }
  return surface;
}

/// Each vertex moved at random by a normal distribution of that deviation.
TriangleSurface shaken(TriangleSurface surface, double deviation, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> shift(0.0, deviation);
  for (Vec3& p : surface.points) {
    for (double& coordinate : p) coordinate += shift(engine);
  }
  return surface;
}

TEST(Untangling, LeavesASurfaceWithoutCrossingsAlone) {
  TriangleSurface surface = sphere(3);
  const Untangling result = untangle(surface, exact::self_intersections(surface));
  EXPECT_EQ(surface.points, sphere(3).points);
  EXPECT_EQ(result.pairs_mended, 0U);
  EXPECT_TRUE(result.moved.empty());
  EXPECT_TRUE(result.left.empty());
}

TEST(Untangling, TurnsBackVerticesOfASphereAndATorus) {
  for (const TriangleSurface& sound : {sphere(4), torus(60, 20, 2.0, 0.7)}) {
    const TriangleSurface tangled = with_faces_turned_over(sound, {3, 400, 811});
    const auto crossings = exact::self_intersections(tangled);
    ASSERT_GE(crossings.size(), 6U);
    TriangleSurface mended = tangled;
    const Untangling result = untangle(mended, crossings);
    EXPECT_TRUE(exact::self_intersections(mended).empty());
    EXPECT_TRUE(result.left.empty());
    EXPECT_EQ(result.pairs_mended, crossings.size());
    EXPECT_EQ(mended.triangles, sound.triangles);
    EXPECT_LT(result.moved.size(), 60U);
  }
}

TEST(Untangling, MovesVerticesByTwiceTheirEdgesAtMostAndSaysWhich) {
  const TriangleSurface tangled = with_faces_turned_over(sphere(4), {3, 400, 811});
  TriangleSurface mended = tangled;
  const Untangling result = untangle(mended, exact::self_intersections(tangled));
  double largest = 0.0;
  for (Index v = 0; v < tangled.points.size(); ++v) {
    const double move = (mended.points[v] - tangled.points[v]).norm();
    const bool told = std::binary_search(result.moved.begin(), result.moved.end(), v);
    EXPECT_EQ(move > 0.0, told);
    if (told) {
      EXPECT_LE(move, 2.0 * mean_edge_length_at(tangled, v) * (1.0 + 1e-12));
    }
    largest = std::max(largest, move);
  }
  EXPECT_EQ(result.largest_move, largest);
  EXPECT_GT(largest, 0.0);
}

TEST(Untangling, MovesNoVertexOfACoarseSurfaceAcrossIt) {
  // A corner pushed through the far side: a move of less than twice its edges would part the faces.
  TriangleSurface tangled = sphere(1);
  tangled.points[0] *= -1.6;
  const auto crossings = exact::self_intersections(tangled);
  ASSERT_FALSE(crossings.empty());
  TriangleSurface mended = tangled;
  const Untangling result = untangle(mended, crossings);
  EXPECT_EQ(result.largest_move, 0.0);
  EXPECT_EQ(result.left, crossings);
  EXPECT_EQ(mended.points, tangled.points);
}

TEST(Untangling, PartsSheetsThatGrazeEachOther) {
  TriangleSurface surface = eight(0.78);
  const auto crossings = exact::self_intersections(surface);
  ASSERT_FALSE(crossings.empty());
  untangle(surface, crossings);
  EXPECT_TRUE(exact::self_intersections(surface).empty());
}

TEST(Untangling, LeavesWhatCrossesDeeplyAsItIs) {
  const TriangleSurface tangled = eight(0.2);
  const auto crossings = exact::self_intersections(tangled);
  ASSERT_FALSE(crossings.empty());
  TriangleSurface surface = tangled;
  const Untangling result = untangle(surface, crossings);
  EXPECT_EQ(surface.points, tangled.points);
  EXPECT_EQ(result.left, crossings);
  EXPECT_EQ(result.pairs_mended, 0U);
  EXPECT_EQ(result.largest_move, 0.0);
}

TEST(Untangling, LeavesSolidsThatOverlapAsTheyAre) {
  // Deeply, and so little that a move could part them.
  for (const double distance : {1.2, 1.95}) {
    const TriangleSurface tangled = joined(sphere(3), moved(sphere(3), Vec3(distance, 0.01, 0.02)));
    const auto crossings = exact::self_intersections(tangled);
    ASSERT_FALSE(crossings.empty());
    TriangleSurface surface = tangled;
    EXPECT_EQ(untangle(surface, crossings).left, crossings);
    EXPECT_EQ(surface.points, tangled.points);
  }
}

TEST(Untangling, MendsOneTangleBesideAnotherThatStays) {
  TriangleSurface tangled = joined(eight(0.2), moved(sphere(4), Vec3(10, 0, 0)));
  const std::size_t deep = exact::self_intersections(tangled).size();
  turn_over(tangled, to_index(eight(0.2).triangles.size()) + 400);
  const auto crossings = exact::self_intersections(tangled);
  ASSERT_GT(crossings.size(), deep);
  const Untangling result = untangle(tangled, crossings);
  EXPECT_EQ(result.left.size(), deep);
  EXPECT_EQ(exact::self_intersections(tangled), result.left);
}

TEST(Untangling, PartsFacesThatNoiseHasMadeCrossEverywhere) {
  const TriangleSurface sound = torus(60, 20, 2.0, 0.7);
  const TriangleSurface tangled = shaken(sound, 0.08, 1);  // edges are 0.22 long
  const auto crossings = exact::self_intersections(tangled);
  ASSERT_GT(crossings.size(), 100U);
  TriangleSurface mended = tangled;
  EXPECT_TRUE(untangle(mended, crossings).left.empty());
  EXPECT_TRUE(exact::self_intersections(mended).empty());
}

TEST(Untangling, DoesNotDependOnTheNumberingOfVertices) {
  const TriangleSurface tangled = with_faces_turned_over(sphere(4), {3, 400, 811});
  std::vector<Index> number(tangled.points.size());
  std::iota(number.begin(), number.end(), 0U);
  std::shuffle(number.begin(), number.end(), std::mt19937(7));
  TriangleSurface renumbered = tangled;
  for (Index v = 0; v < number.size(); ++v) renumbered.points[number[v]] = tangled.points[v];
  for (Triangle& t : renumbered.triangles) {
    for (Index& v : t) v = number[v];
  }
  TriangleSurface mended = tangled;
  untangle(mended, exact::self_intersections(mended));
  untangle(renumbered, exact::self_intersections(renumbered));
  for (Index v = 0; v < number.size(); ++v) {
    EXPECT_LT((renumbered.points[number[v]] - mended.points[v]).norm(), 1e-12);
  }
}

TEST(Untangling, ThreadsDoNotChangeTheResult) {
  const TriangleSurface tangled = shaken(torus(60, 20, 2.0, 0.7), 0.08, 1);
  const auto crossings = exact::self_intersections(tangled);
  ASSERT_GT(crossings.size(), 100U);
  TriangleSurface by_one = tangled;
  TriangleSurface by_three = tangled;
  const Untangling one = untangle(by_one, crossings, 1);
  const Untangling three = untangle(by_three, crossings, 3);
  EXPECT_EQ(by_one.points, by_three.points);
  EXPECT_EQ(one.left, three.left);
}

TEST(Untangling, TheWorkingCopySaysWhatWasMoved) {
  const TriangleSurface tangled = with_faces_turned_over(sphere(4), {3, 400});
  const Diagnosis diagnosis = diagnose(tangled);
  const WorkingCopy copy = prepare(tangled, diagnosis);
  EXPECT_EQ(copy.untangling.pairs_mended, diagnosis.find("self_intersections")->count);
  EXPECT_FALSE(copy.self_intersecting());
  ASSERT_EQ(copy.warnings.size(), 1U);
  EXPECT_EQ(copy.warnings[0].code, "crossings_mended");
  const std::string count = std::to_string(copy.untangling.moved.size());
  EXPECT_NE(copy.warnings[0].message.find("Vertices moved: " + count), std::string::npos)
      << copy.warnings[0].message;
}

TEST(Untangling, TheWorkingCopyStaysAsItIsOnDemand) {
  const TriangleSurface tangled = with_faces_turned_over(sphere(4), {3, 400});
  const Diagnosis diagnosis = diagnose(tangled);
  const WorkingCopy copy = prepare(tangled, diagnosis, {false});
  EXPECT_EQ(copy.surface.points, tangled.points);
  EXPECT_EQ(copy.untangling.left, diagnosis.crossings);
  ASSERT_EQ(copy.warnings.size(), 1U);
  EXPECT_EQ(copy.warnings[0].code, "self_intersections");
}

TEST(Untangling, IsUndoneWhereItSwallowsASolidOrTurnsItInsideOut) {
  const auto shells = [](const TriangleSurface& surface) {
    return find_shells(surface, make_edge_table(surface.triangles), {});
  };
  const TriangleSurface small = sphere(1, 0.1);
  const Shells apart = shells(joined(sphere(2), moved(small, Vec3(3, 0, 0))));
  const Shells nearer = shells(joined(sphere(2), moved(small, Vec3(2, 0, 0))));
  const Shells swallowed = shells(joined(sphere(2), small));
  const Shells turned = shells(joined(sphere(2), moved(fixtures::reversed(small), Vec3(3, 0, 0))));
  EXPECT_TRUE(detail::same_solids(apart, nearer));
  EXPECT_FALSE(detail::same_solids(apart, swallowed));
  EXPECT_FALSE(detail::same_solids(apart, turned));
}

TEST(Untangling, MakesTheTopologyProven) {
  const TriangleSurface sound = torus(60, 20, 2.0, 0.7);
  const TriangleSurface noisy = shaken(sound, 0.08, 1);
  MedialAxisOptions options;
  EXPECT_EQ(compute_medial_axis(noisy, options).interior.certificate.topology,
            TopologyVerdict::kProven);
  options.preparation.mend_crossings = false;
  EXPECT_NE(compute_medial_axis(noisy, options).interior.certificate.topology,
            TopologyVerdict::kProven);
}

TEST(Untangling, MendsRealMeshes) {
  for (const std::string name : {"horse_15563", "camel", "man_8904"}) {
    const std::string path = fixtures::shared_model(name);
    if (path.empty()) GTEST_SKIP() << "no shared models";
    TriangleSurface surface = fixtures::load_off(path);
    const auto crossings = exact::self_intersections(surface);
    EXPECT_FALSE(crossings.empty()) << name;
    const double diagonal = bounding_box_diagonal(surface.points);
    const Untangling result = untangle(surface, crossings);
    EXPECT_TRUE(exact::self_intersections(surface).empty()) << name;
    EXPECT_LT(result.largest_move, 0.02 * diagonal) << name;
  }
}

}  // namespace
}  // namespace mgf
