// SPDX-License-Identifier: GPL-3.0-or-later
// Windows on their way: their trails, what a search knows, and searches longer than a band of
// distances.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "geodesics_fixtures.h"
#include "vcg_ext/core/constants.h"
#include "vcg_ext/geodesics/search_bands.h"
#include "vcg_ext/geodesics/search_bounds.h"
#include "vcg_ext/geodesics/search_targets.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/trail.h"
#include "vcg_ext/geodesics/window.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Trail, KeepsEveryTurn) {
  // A walk longer than one word of bits, and one that leaves it on the way and goes on otherwise.
  const HalfedgeMesh mesh = make_halfedge_mesh(bumpy_sphere(3, 0.1, 1));
  std::mt19937 random(5);
  TrailStore store;
  Trail trail;
  trail.first = 7;
  std::vector<Index> walked{7};
  const auto step = [&](Trail& of, std::vector<Index>& edges) {
    const Side side = random() % 2 == 0 ? kLeft : kRight;
    store.turn(side, of);
    edges.push_back(mesh.crossings[edges.back()].beyond[side]);
  };
  for (int i = 0; i < 100; ++i) step(trail, walked);
  Trail other = trail;
  std::vector<Index> other_walked = walked;
  for (int i = 0; i < 150; ++i) {
    step(trail, walked);
    step(other, other_walked);
  }
  EXPECT_EQ(store.crossed(mesh, trail), walked);
  EXPECT_EQ(store.crossed(mesh, other), other_walked);
  EXPECT_NE(walked, other_walked);
}

TEST(Crossing, LeadsToTheTrianglesBeyond) {
  const HalfedgeMesh mesh = make_halfedge_mesh(bumpy_sphere(2, 0.2, 3));
  for (Index h = 0; h < mesh.halfedges.size(); ++h) {
    const Crossing& crossing = mesh.crossings[h];
    EXPECT_EQ(mesh.tail(crossing.beyond[kLeft]), mesh.tail(h));
    EXPECT_EQ(mesh.head(crossing.beyond[kLeft]), crossing.apex);
    EXPECT_EQ(mesh.tail(crossing.beyond[kRight]), crossing.apex);
    EXPECT_EQ(mesh.head(crossing.beyond[kRight]), mesh.head(h));
    const Vec2 apex =
        place_beside({0.0, 0.0}, {mesh.halfedges[h].length, 0.0}, crossing.along, crossing.across);
    EXPECT_NEAR(norm(apex - mesh.halfedges[h].apex), 0.0, 1e-15);
  }
}

TEST(SearchBounds, KeepTheShortestLengthAndWhatIsLeftForTheTargets) {
  const HalfedgeMesh mesh = make_halfedge_mesh(bumpy_sphere(2, 0.2, 3));
  constexpr double kTolerance = 1e-12;
  SearchTargets targets(mesh, kTolerance, nullptr);
  SearchBounds bounds(mesh, {}, kTolerance, targets);
  const auto aim_at = [&](Index v, double known) {
    targets.assign({{place_of_vertex(mesh, v), known, known}});
  };
  aim_at(7, 3.0);
  EXPECT_EQ(bounds.known(3), kInfinity);
  EXPECT_FALSE(bounds.is_detour(3, 1e9));
  bounds.learn(3, 2.0);
  bounds.learn(3, 2.5);
  EXPECT_EQ(bounds.known(3), 2.0);
  EXPECT_TRUE(bounds.is_detour(3, 2.1));
  EXPECT_FALSE(bounds.is_detour(3, 2.0 + 0.5 * kTolerance));
  EXPECT_NEAR(bounds.rest(3), 3.0 - (mesh.points[7] - mesh.points[3]).norm(), 1e-11);
  bounds.clear();
  aim_at(9, 1.5);
  EXPECT_EQ(bounds.known(3), kInfinity);
  EXPECT_NEAR(bounds.rest(3), 1.5 - (mesh.points[9] - mesh.points[3]).norm(), 1e-11);
}

TEST(SearchBands, TakeWindowsOfAnyDistance) {
  SearchBands bands(2.0);
  Window window;
  for (const double nearest : {-7.0, 0.5, 5.0}) {
    window.root = static_cast<Index>(nearest + 10.0);
    EXPECT_TRUE(bands.put_off(window, nearest));
  }
  EXPECT_FALSE(bands.put_off(window, 1e12));
  EXPECT_FALSE(bands.put_off(window, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(bands.take_windows().empty());
  ASSERT_TRUE(bands.advance());  // what lies before the next band is taken there
  ASSERT_EQ(bands.take_windows().size(), 2U);
  EXPECT_EQ(bands.take_windows().size(), 0U);
  ASSERT_TRUE(bands.advance());
  const std::vector<Window>& last = bands.take_windows();
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last[0].root, 15U);
  EXPECT_FALSE(bands.advance());
}

TEST(WindowInterval, IsWhereTheRaysMeetTheEdge) {
  Window window;
  window.left_ray = {-1.0, 4.0};
  window.right_ray = {1.0, 2.0};
  window.ends[Window::kTail].place = {-4.0, 4.0};
  window.ends[Window::kHead].place = {6.0, 4.0};
  for (UnfoldedCorner& end : window.ends) {
    end.past_left = cross(window.left_ray, end.place);
    end.past_right = cross(window.right_ray, end.place);
  }
  const WindowInterval interval(window);
  EXPECT_DOUBLE_EQ(interval.left, 0.3);   // at (-1, 4)
  EXPECT_DOUBLE_EQ(interval.right, 0.6);  // at (2, 4)
  EXPECT_DOUBLE_EQ(interval.left_square, 17.0);
  EXPECT_DOUBLE_EQ(interval.right_square, 20.0);
}

/// From a corner of the lower rim of a long prism to a corner of its upper rim: a straight line on
/// the prism unrolled, across some hundreds of edges.
class LongPrism : public ::testing::Test {
 protected:
  static constexpr int kSides = 12;
  static constexpr int kRings = 240;
  static constexpr double kHeight = 60.0;
  const HalfedgeMesh mesh = make_halfedge_mesh(prism(1.0, kHeight, kSides, kRings));

  Index corner(int side, double height) const {
    const double angle = 2.0 * kPi * side / kSides;
    const Vec3 place(std::cos(angle), std::sin(angle), height);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if ((mesh.points[v] - place).norm() < 1e-9) return v;
    }
    return kNone;
  }
  static double unrolled(int sides) {
    return std::hypot(sides * 2.0 * std::sin(kPi / kSides), kHeight);
  }
};

TEST_F(LongPrism, IsCrossedInOnePiece) {
  WindowPropagation search(mesh);
  const PropagationTarget target{place_of_vertex(mesh, corner(5, kHeight)), 1.1 * kHeight,
                                 1.1 * kHeight};
  ASSERT_TRUE(search.run(place_of_vertex(mesh, corner(0, 0.0)), {target}));
  EXPECT_NEAR(search.distance(0), unrolled(5), 1e-11);
  const std::vector<PathPiece> pieces = search.pieces(0);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_GT(pieces[0].crossed.size(), 200U);
}

TEST_F(LongPrism, IsMeasuredThroughAllBands) {
  PropagationPruning everywhere;
  everywhere.ellipse = false;
  WindowPropagation search(mesh, everywhere);
  ASSERT_TRUE(search.run(place_of_vertex(mesh, corner(0, 0.0)), {}));
  for (int side = 0; side <= kSides / 2; ++side) {
    EXPECT_NEAR(search.vertex_bound(corner(side, kHeight)), unrolled(side), 1e-11);
  }
}

TEST_F(LongPrism, SearchesThatAreGivenUpSaySo) {
  WindowPropagation search(mesh);
  search.give_up_beyond(1000);
  const PropagationTarget target{place_of_vertex(mesh, corner(5, kHeight)), kInfinity};
  EXPECT_FALSE(search.run(place_of_vertex(mesh, corner(0, 0.0)), {target}));
  // The next one starts anew.
  const PropagationTarget near{place_of_vertex(mesh, corner(1, 0.0)), 1.0, 1.0};
  EXPECT_TRUE(search.run(place_of_vertex(mesh, corner(0, 0.0)), {near}));
  EXPECT_NEAR(search.distance(0), 2.0 * std::sin(kPi / kSides), 1e-12);
}

TEST(WindowPropagation, IsTheSameWhereEdgesAreFarLongerThanMost) {
  // The small sphere makes bands of distances narrow; windows on the box are far wider than those.
  TriangleSurface both = gridded_box(Vec3(30.0, 20.0, 1.0), 2, 1, 1);
  const HalfedgeMesh alone = make_halfedge_mesh(both);
  const Index offset = to_index(both.points.size());
  const TriangleSurface small = bumpy_sphere(6, 0.1, 1);
  for (const Vec3& p : small.points) both.points.push_back(0.01 * p + Vec3(0.0, 0.0, 50.0));
  for (const Triangle& t : small.triangles) {
    both.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  const HalfedgeMesh mesh = make_halfedge_mesh(both);
  ASSERT_LT(16.0 * mesh.mean_edge, 0.5);
  PropagationPruning everywhere;
  everywhere.ellipse = false;
  WindowPropagation search(mesh, everywhere);
  WindowPropagation expected(alone, everywhere);
  for (Index start = 0; start < offset; ++start) {
    ASSERT_TRUE(search.run(place_of_vertex(mesh, start), {}));
    ASSERT_TRUE(expected.run(place_of_vertex(alone, start), {}));
    for (Index v = 0; v < offset; ++v) {
      EXPECT_NEAR(search.vertex_bound(v), expected.vertex_bound(v), 1e-12);
    }
  }
}

}  // namespace
}  // namespace mgf::test
