// SPDX-License-Identifier: GPL-3.0-or-later
// What is harmless is mended on the working copy, and nothing else is touched.
#include "vcg_ext/input/working_copy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "tests/fixtures.h"
#include "tests/working_copy_checks.h"

namespace mgf {
namespace {

using fixtures::box;
using fixtures::joined;
using fixtures::moved;
using fixtures::reversed;
using fixtures::sphere;
using test::count_of;
using test::expect_consistent_maps;
using test::same;

/// Nothing but the sampling is found.
bool is_sound(const TriangleSurface& s) {
  const Diagnosis diagnosis = diagnose(s);
  return diagnosis.servable &&
         std::all_of(diagnosis.findings.begin(), diagnosis.findings.end(),
                     [](const Finding& finding) { return finding.code == "too_coarse"; });
}

double volume(const TriangleSurface& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles) {
    sum += s.points[t[0]].dot(s.points[t[1]].cross(s.points[t[2]])) / 6.0;
  }
  return sum;
}

TEST(WorkingCopy, IgnoresWhatBelongsToNoFace) {
  TriangleSurface surface = sphere(1);
  const TriangleSurface sound = surface;
  surface.points.insert(surface.points.begin() + 2,
                        Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (Triangle& t : surface.triangles) {
    for (Index& v : t) v += v >= 2 ? 1 : 0;
  }
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(diagnosis.find("unreferenced_vertices")->vertices, (std::vector<Index>{2}));
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(same(copy.surface, sound));
  EXPECT_EQ(copy.vertex_of_input[2], kNone);
  ASSERT_EQ(copy.warnings.size(), 1U);
  EXPECT_EQ(copy.warnings[0].code, "unreferenced_vertices");
}

TEST(WorkingCopy, ClosesASoupByMergingEqualPoints) {
  const TriangleSurface soup = fixtures::soup(sphere(2));
  const Diagnosis diagnosis = diagnose(soup);
  EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
  EXPECT_EQ(count_of(diagnosis, "duplicate_vertices"), soup.points.size() - 66U);
  const WorkingCopy copy = prepare(soup, diagnosis);
  EXPECT_EQ(copy.surface.points.size(), 66U);
  EXPECT_EQ(copy.surface.triangles.size(), soup.triangles.size());
  expect_consistent_maps(copy, soup);
}

TEST(WorkingCopy, NeverMergesZeroAndItsNegativeApart) {
  TriangleSurface surface = fixtures::soup(box(1, 1, 1));
  for (std::size_t i = 0; i < surface.points.size(); i += 2) {
    for (double& x : surface.points[i]) x = x == 0.0 ? -0.0 : x;
  }
  EXPECT_EQ(prepare(surface, diagnose(surface)).surface.points.size(), 8U);
}

TEST(WorkingCopy, TurnsAnInsideOutSurface) {
  const TriangleSurface surface = reversed(sphere(2));
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(count_of(diagnosis, "inside_out"), 1U);
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_NEAR(volume(copy.surface), volume(sphere(2)), 1e-12);
  expect_consistent_maps(copy, surface);
}

TEST(WorkingCopy, TurnsOnlyThePieceThatIsInsideOut) {
  const TriangleSurface surface =
      joined(box(1, 1, 1), reversed(moved(box(1, 1, 1), Vec3(5, 0, 0))));
  const WorkingCopy copy = prepare(surface, diagnose(surface));
  EXPECT_NEAR(volume(copy.surface), 2.0, 1e-12);
  EXPECT_EQ(copy.surface.triangles[0], surface.triangles[0]);
}

TEST(WorkingCopy, NumbersSeparateSolids) {
  const TriangleSurface surface =
      joined(joined(sphere(1), moved(fixtures::torus(12, 8, 2, 0.5), Vec3(10, 0, 0))),
             moved(box(1, 1, 1), Vec3(0, 10, 0)));
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(count_of(diagnosis, "several_shells"), 3U);
  EXPECT_EQ(diagnosis.genus, 1U);
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(same(copy.surface, surface));
  EXPECT_EQ(copy.solids, 3U);
  EXPECT_EQ(copy.shell_of_vertex.front(), 0U);
  EXPECT_EQ(copy.shell_of_vertex.back(), 2U);
}

TEST(WorkingCopy, FillsACavityOnDemand) {
  for (const TriangleSurface& inner : {sphere(1), reversed(sphere(1))}) {
    const TriangleSurface hollow = joined(inner, sphere(2, 2.0));
    const DiagnosisOptions options{true};
    const WorkingCopy copy = prepare(hollow, diagnose(hollow, options));
    EXPECT_TRUE(same(copy.surface, sphere(2, 2.0)));
    EXPECT_EQ(copy.solids, 1U);
    EXPECT_EQ(copy.face_of_input[0], kNone);
    expect_consistent_maps(copy, hollow);
  }
}

TEST(WorkingCopy, TakesASolidWithinACavityForASolid) {
  const TriangleSurface nested =
      joined(joined(sphere(1), reversed(sphere(1, 2.0))), sphere(1, 3.0));
  const Diagnosis diagnosis = diagnose(nested);
  ASSERT_EQ(diagnosis.shells.size(), 3U);
  EXPECT_EQ(diagnosis.shells[0].inside_shell, kNone);
  EXPECT_EQ(diagnosis.shells[1].inside_shell, 2U);
  EXPECT_EQ(diagnosis.shells[2].inside_shell, kNone);
}

TEST(WorkingCopy, DropsRepeatedFaces) {
  TriangleSurface surface = sphere(1);
  const Triangle& t = surface.triangles[4];
  surface.triangles.push_back({t[1], t[2], t[0]});
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(diagnosis.find("duplicate_faces")->faces, (std::vector<Index>{32}));
  EXPECT_TRUE(same(prepare(surface, diagnosis).surface, sphere(1)));
}

TEST(WorkingCopy, FlipsACapAwayWithoutMovingTheSurface) {
  // A vertex on an edge of a box belongs to one side only: the other has a face without area.
  TriangleSurface surface = box(2, 2, 2);
  const auto at = std::find(surface.triangles.begin(), surface.triangles.end(), Triangle{0, 1, 5});
  ASSERT_NE(at, surface.triangles.end());
  surface.points.emplace_back(1.0, 0.0, 0.0);
  *at = {0, 8, 5};
  surface.triangles.push_back({8, 1, 5});
  surface.triangles.push_back({0, 1, 8});
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
  EXPECT_EQ(diagnosis.find("degenerate_faces")->faces, (std::vector<Index>{13}));
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(is_sound(copy.surface)) << diagnose(copy.surface).summary();
  EXPECT_NEAR(volume(copy.surface), 8.0, 1e-12);
  EXPECT_EQ(copy.face_of_input[13], kNone);
  expect_consistent_maps(copy, surface);
}

TEST(WorkingCopy, FlipsAWholeFanOfCaps) {
  // Three vertices on one edge; the side below reaches them through caps only.
  TriangleSurface surface = box(4, 2, 2);
  const auto at = std::find(surface.triangles.begin(), surface.triangles.end(), Triangle{0, 1, 5});
  ASSERT_NE(at, surface.triangles.end());
  for (const double x : {1.0, 2.0, 3.0}) surface.points.emplace_back(x, 0.0, 0.0);
  *at = {0, 8, 5};
  for (const Triangle& t : {Triangle{8, 9, 5}, Triangle{9, 10, 5}, Triangle{10, 1, 5},
                            Triangle{8, 0, 9}, Triangle{9, 0, 1}, Triangle{10, 9, 1}}) {
    surface.triangles.push_back(t);
  }
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(count_of(diagnosis, "degenerate_faces"), 3U);
  ASSERT_TRUE(diagnosis.servable) << diagnosis.summary();
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(is_sound(copy.surface)) << diagnose(copy.surface).summary();
  EXPECT_NEAR(volume(copy.surface), 16.0, 1e-12);
  expect_consistent_maps(copy, surface);
}

TEST(WorkingCopy, LeavesRealMeshesAlone) {
  for (const std::string name : {"hand", "knot", "octopus", "femur", "genus3_6652"}) {
    const std::string path = fixtures::shared_model(name);
    if (path.empty()) GTEST_SKIP() << "no shared models";
    const TriangleSurface surface = fixtures::load_off(path);
    const Diagnosis diagnosis = diagnose(surface);
    EXPECT_TRUE(diagnosis.servable) << name;
    EXPECT_EQ(count_of(diagnosis, "self_intersections"), 0U) << name;
    EXPECT_TRUE(same(prepare(surface, diagnosis).surface, surface)) << name;
  }
}

}  // namespace
}  // namespace mgf
