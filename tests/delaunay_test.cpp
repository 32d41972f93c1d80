// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/delaunay.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/fixtures.h"
#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/delaunay_ahead.h"

namespace mgf::test {
namespace {

std::vector<Vec3> some_points() {
  return fixtures::torus(24, 10, 1.0, 0.3).points;
}

void expect_equal(const TetrahedronArrays& found, const TetrahedronArrays& wanted) {
  EXPECT_EQ(found.corners, wanted.corners);
  EXPECT_EQ(found.neighbours, wanted.neighbours);
}

TEST(Delaunay, StopsForTheUser) {
  int reports = 0;
  const Progress refuse([&](double, const char*) { return ++reports < 2; });
  EXPECT_THROW(delaunay_tetrahedra(fixtures::sphere(4).points, 1, refuse), Cancelled);
}

TEST(DelaunayAhead, GivesWhatItBeganWithOnTwoThreads) {
  DelaunayAhead ahead(some_points);
  expect_equal(ahead.finish(some_points(), 2, {}), delaunay_tetrahedra(some_points()));
}

TEST(DelaunayAhead, BeginsAnewWithOtherPointsOnTwoThreads) {
  std::vector<Vec3> moved = some_points();
  moved[7] *= 1.01;
  DelaunayAhead ahead(some_points);
  expect_equal(ahead.finish(moved, 2, {}), delaunay_tetrahedra(moved));
  DelaunayAhead nothing([] { return std::vector<Vec3>(); });
  expect_equal(nothing.finish(moved, 2, {}), delaunay_tetrahedra(moved));
}

TEST(DelaunayAhead, PassesOnWhatIsWrongWithThePoints) {
  std::vector<Vec3> twice = some_points();
  twice[7] = twice[8];
  DelaunayAhead ahead([&] { return twice; });
  EXPECT_THROW(ahead.finish(twice, 2, {}), InputError);
}

TEST(DelaunayAhead, LetsTheUserStopWhileItIsWaitedFor) {
  const Progress refuse([](double, const char*) { return false; });
  const std::vector<Vec3> many = fixtures::sphere(6).points;
  DelaunayAhead ahead([&] { return many; });
  EXPECT_THROW(ahead.finish(many, 2, refuse), Cancelled);
}

}  // namespace
}  // namespace mgf::test
