// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/surface/segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "tests/graph_fixtures.h"
#include "tests/swept_fixtures.h"
#include "vcg_ext/surface/branch_areas.h"

namespace mgf {
namespace {

using test::circled_tube;
using test::CircledShape;
using test::set_circles;

constexpr double kThreshold = 1.3;

Segmentation segment(const CircledShape& shape, double threshold = kThreshold) {
  return segment_surface(shape.surface, unrefined(shape.surface), shape.skeleton,
                         build_branches(shape.skeleton), shape.circles, threshold);
}

/// A tube whose circles get eccentricity 2 from ring `first_flat` on: a paddle.
CircledShape paddle(Index rings, Index first_flat) {
  CircledShape shape = circled_tube(10.0, 0.5, rings, 12);
  for (Index e = first_flat; e < rings; ++e) shape.skeleton.eccentricity[e] = 2.0;
  shape.circles.eccentricity = shape.skeleton.eccentricity;
  return shape;
}

double centre_x(const TriangleSurface& surface, Index f) {
  const Triangle& t = surface.triangles[f];
  return (surface.points[t[0]].x() + surface.points[t[1]].x() + surface.points[t[2]].x()) / 3;
}

TEST(GeodesicCircles, CloseTheThreePathsAndListEachFaceOnce) {
  struct Path {
    std::vector<Vec3> points;
    std::vector<Index> faces;
  };
  CurveSkeleton skeleton = test::line_skeleton(1.0, 1, 1.0);
  skeleton.contacts = {Triangle{4, 7, 9}};
  skeleton.eccentricity = {1.25};
  const GeodesicCircles circles = trace_geodesic_circles(skeleton, [](Index a, Index b) {
    EXPECT_LT(a, b);
    return Path{{Vec3(a, 0, 0), Vec3(a, b, 1), Vec3(b, 0, 0)}, {b, 3, a}};
  });
  ASSERT_EQ(circles.polyline.size(), 1U);
  const std::vector<Vec3> expected = {{4, 0, 0}, {4, 7, 1}, {7, 0, 0}, {7, 9, 1},
                                      {9, 0, 0}, {4, 9, 1}, {4, 0, 0}};
  const Row<Vec3> points = circles.polyline[0];
  EXPECT_EQ(std::vector<Vec3>(points.begin(), points.end()), expected);
  const Row<Index> faces = circles.faces[0];
  EXPECT_EQ(std::vector<Index>(faces.begin(), faces.end()), (std::vector<Index>{3, 4, 7, 9}));
  EXPECT_EQ(circles.eccentricity, std::vector<double>{1.25});
}

TEST(GeodesicCircles, AreEmptyWhereTwoContactsHaveNoPath) {
  struct Path {
    std::vector<Vec3> points;
    std::vector<Index> faces;
  };
  CurveSkeleton skeleton = test::line_skeleton(4.0, 4, 1.0);
  skeleton.contacts = {{0, 1, 2}, {0, 1, 9}, {0, 8, 9}, {7, 8, 9}};  // 0 to 4 and 5 to 9 lie apart
  const GeodesicCircles circles = trace_geodesic_circles(skeleton, [](Index a, Index b) {
    return (a < 5) == (b < 5) ? Path{{Vec3(a, 0, 0), Vec3(b, 0, 0)}, {a, b}} : Path{};
  });
  ASSERT_EQ(circles.polyline.size(), 4U);
  ASSERT_EQ(circles.faces.size(), 4U);
  for (const Index c : {0U, 3U}) {
    EXPECT_EQ(circles.polyline[c].size(), 4U);
    EXPECT_EQ(circles.faces[c].size(), 3U);
  }
  for (const Index c : {1U, 2U}) {
    EXPECT_TRUE(circles.polyline[c].empty());
    EXPECT_TRUE(circles.faces[c].empty());
  }
}

TEST(Segmentation, CutsAPaddleWhereItsEccentricityCrossesTheThreshold) {
  const CircledShape shape = paddle(100, 50);
  const Segmentation result = segment(shape);
  for (Index f = 0; f < shape.surface.triangles.size(); ++f) {
    const double x = centre_x(shape.surface, f);
    if (std::abs(x - 5.0) < 0.1) continue;  // the ring whose window is half on either side
    EXPECT_EQ(result.tubular[f] != 0, x < 5.0) << x;
    EXPECT_EQ(result.eccentricity[f], x < 5.0 ? 1.0 : 2.0);
    EXPECT_GT(result.confidence[f], 0.0);
    EXPECT_LE(result.confidence[f], 1.0);
  }
  EXPECT_EQ(result.unlabelled_faces, 0U);
  EXPECT_NEAR(result.tubular_area_share, 0.5, 0.01);
}

TEST(Segmentation, LabelIsEccentricityAgainstThreshold) {
  CircledShape shape = paddle(60, 20);
  for (Index e = 0; e < 60; ++e) shape.skeleton.eccentricity[e] += 0.01 * (e * 7 % 10);
  for (const double threshold : {0.5, 1.03, 1.5, 2.04, 3.0}) {
    const Segmentation result = segment(shape, threshold);
    for (Index f = 0; f < result.tubular.size(); ++f) {
      EXPECT_EQ(result.tubular[f] != 0, result.eccentricity[f] < threshold);
    }
  }
}

TEST(Segmentation, LeavesNoIslandOfASingleNoisyCircle) {
  CircledShape shape = paddle(100, 100);
  shape.skeleton.eccentricity[40] = 7.0;
  EXPECT_DOUBLE_EQ(segment(shape).tubular_area_share, 1.0);
}

TEST(Segmentation, ConfidenceFallsWithDissentAndWithDistance) {
  CircledShape shape = circled_tube(10.0, 0.5, 100, 12);
  shape.skeleton.eccentricity[40] = 7.0;  // outvoted by the filter, but not forgotten
  const Segmentation result = segment(shape);
  const Row<Index> noisy = shape.circles.faces[40];
  const Row<Index> sure = shape.circles.faces[20];
  EXPECT_DOUBLE_EQ(result.confidence[noisy[0]], 0.0);
  EXPECT_DOUBLE_EQ(result.confidence[sure[0]], 1.0);
  // The caps have no circles.
  EXPECT_LT(result.confidence.back(), 1.0);
  EXPECT_GT(result.confidence.back(), 0.5);
}

TEST(Segmentation, ReachesFacesBetweenSparseCircles) {
  CircledShape shape = paddle(100, 50);
  std::vector<std::vector<Index>> sparse(100);
  for (Index e = 5; e < 100; e += 10) {
    sparse[e].assign(shape.circles.faces[e].begin(), shape.circles.faces[e].end());
  }
  set_circles(sparse, shape);
  const Segmentation result = segment(shape);
  EXPECT_EQ(result.unlabelled_faces, 0U);
  EXPECT_NEAR(result.tubular_area_share, 0.5, 0.01);
}

TEST(Segmentation, MajorityOfCirclesDecidesAndATieIsTubular) {
  CircledShape shape = circled_tube(30.0, 0.1, 3, 12);
  shape.skeleton.eccentricity = {1.0, 2.0, 3.0};  // each alone in its window
  std::vector<std::vector<Index>> ring(3);
  for (Index e = 0; e < 3; ++e) {
    ring[e].assign(shape.circles.faces[e].begin(), shape.circles.faces[e].end());
  }
  const auto joined = [](std::vector<Index> one, const std::vector<Index>& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
  };
  // Ring 0 is crossed by all three circles, ring 1 by the second, ring 2 by the first and third.
  set_circles({joined(ring[0], ring[2]), joined(ring[0], ring[1]), joined(ring[0], ring[2])},
              shape);
  const Segmentation result = segment(shape);
  for (Index i = 0; i < ring[0].size(); ++i) {
    EXPECT_EQ(result.tubular[ring[0][i]], 0);
    EXPECT_EQ(result.tubular[ring[1][i]], 0);
    EXPECT_EQ(result.tubular[ring[2][i]], 1);
  }
}

TEST(Segmentation, AFlatPatchSmallerThanTheTubesSectionIsNoise) {
  CircledShape shape = circled_tube(20.0, 1.0, 100, 24);
  std::vector<std::vector<Index>> circles(100);
  for (Index e = 0; e < 100; ++e) {
    circles[e].assign(shape.circles.faces[e].begin(), shape.circles.faces[e].end());
  }
  for (Index e = 50; e < 100; ++e) shape.skeleton.eccentricity[e] = 2.0;
  for (Index e = 80; e < 83; ++e) {  // three flat circles stray on the tubular half
    for (Index stray = 20; stray < 22; ++stray) {
      circles[e].insert(circles[e].end(), circles[stray].begin(), circles[stray].begin() + 6);
    }
  }
  set_circles(circles, shape);
  const Segmentation result = segment(shape);
  EXPECT_NEAR(result.tubular_area_share, 0.5, 0.02);
  for (Index stray = 20; stray < 22; ++stray) {
    EXPECT_EQ(result.tubular[circles[stray][0]], 1);
    EXPECT_EQ(result.eccentricity[circles[stray][0]], 1.0);
  }
}

TEST(Segmentation, HasBordersAsShortAsTheGirth) {
  constexpr Index kRings = 100;
  CircledShape shape = circled_tube(6.5, 1.0, kRings, 96);
  std::vector<std::vector<Index>> circles(kRings);
  for (Index e = 0; e < kRings; ++e) {
    for (const Index f : shape.circles.faces[e]) {
      const bool tooth = f % 192 / 6 % 2 == 0;  // three squares wide and as high
      circles[tooth ? e : std::min(e + 3, kRings - 1)].push_back(f);
    }
  }
  for (Index e = kRings / 2; e < kRings; ++e) shape.skeleton.eccentricity[e] = 2.0;
  set_circles(circles, shape);
  const FaceGraph faces = build_face_graph(shape.surface);
  EXPECT_LT(test::border_length(faces, segment(shape).tubular), 1.1 * 2 * M_PI);
}

TEST(Segmentation, DoesntDependOnTheOrderOfFaces) {
  CircledShape shape = paddle(40, 17);
  std::mt19937 random(5);
  std::vector<std::vector<Index>> some(40);
  for (Index e = 0; e < 40; ++e) {
    shape.skeleton.eccentricity[e] += 0.001 * e;
    for (const Index f : shape.circles.faces[e]) {
      if (random() % 4 == 0) some[e].push_back(f);
    }
  }
  set_circles(some, shape);
  const Segmentation result = segment(shape);

  std::vector<Index> order(shape.surface.triangles.size());
  std::iota(order.begin(), order.end(), Index{0});
  for (int round = 0; round < 5; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    CircledShape shuffled = shape;
    std::vector<Index> place(order.size());
    for (Index f = 0; f < order.size(); ++f) {
      place[order[f]] = f;
      shuffled.surface.triangles[f] = shape.surface.triangles[order[f]];
    }
    for (Index& f : shuffled.circles.faces.items) f = place[f];
    const Segmentation other = segment(shuffled);
    for (Index f = 0; f < order.size(); ++f) {
      EXPECT_EQ(other.tubular[f], result.tubular[order[f]]);
      EXPECT_EQ(other.eccentricity[f], result.eccentricity[order[f]]);
    }
  }
}

TEST(Segmentation, SpeaksOfTheInputsFacesWhenTheSurfaceIsRefined) {
  const CircledShape shape = paddle(40, 20);
  RefinedSurface refined;
  refined.surface.points = shape.surface.points;
  refined.input_points = to_index(shape.surface.points.size());
  for (Index f = 0; f < shape.surface.triangles.size(); ++f) {
    const Triangle& t = shape.surface.triangles[f];
    const Index centre = to_index(refined.surface.points.size());
    refined.surface.points.emplace_back(
        (shape.surface.points[t[0]] + shape.surface.points[t[1]] + shape.surface.points[t[2]]) / 3);
    for (std::size_t i = 0; i < 3; ++i) {
      refined.surface.triangles.push_back({t[i], t[(i + 1) % 3], centre});
      refined.parent_face.push_back(f);
    }
  }
  GeodesicCircles circles = shape.circles;
  for (Index& f : circles.faces.items) f = 3 * f + f % 3;
  const Segmentation result = segment_surface(shape.surface, refined, shape.skeleton,
                                              build_branches(shape.skeleton), circles, kThreshold);
  EXPECT_EQ(result.tubular, segment(shape).tubular);
  EXPECT_EQ(result.tubular.size(), shape.surface.triangles.size());
}

TEST(Segmentation, LeavesAComponentWithoutCirclesUnlabelled) {
  CircledShape shape = circled_tube(4.0, 0.5, 20, 8);
  const CircledShape apart = circled_tube(1.0, 0.5, 2, 8);
  const Index offset = to_index(shape.surface.points.size());
  for (const Vec3& p : apart.surface.points) {
    shape.surface.points.emplace_back(p + Vec3(0, 5, 0));
  }
  for (const Triangle& t : apart.surface.triangles) {
    shape.surface.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  const Segmentation result = segment(shape);
  EXPECT_EQ(result.unlabelled_faces, apart.surface.triangles.size());
  EXPECT_EQ(result.tubular.front(), 1);
  EXPECT_EQ(result.tubular.back(), 0);
  EXPECT_EQ(result.confidence.back(), 0.0);
}

TEST(Segmentation, OfASkeletonWithoutEdgesLabelsNothing) {
  CircledShape shape = circled_tube(1.0, 0.5, 2, 8);
  shape.skeleton = test::single_node_skeleton();
  set_circles({}, shape);
  const Segmentation result = segment(shape);
  EXPECT_EQ(result.unlabelled_faces, shape.surface.triangles.size());
  EXPECT_EQ(result.tubular_area_share, 0.0);
}

TEST(BranchAreas, WholeBranchesAgreeWithTheirFaces) {
  const CircledShape shape = paddle(100, 30);
  const BranchGraph graph = build_branches(shape.skeleton);
  const SurfaceMap map =
      map_surface(shape.surface, unrefined(shape.surface), shape.skeleton, graph, shape.circles);
  const BranchGraph measured =
      with_surface_measures(graph, shape.surface, map, segment(shape), kThreshold);
  ASSERT_EQ(measured.branches.size(), 1U);
  EXPECT_NEAR(measured.branches[0].area_share, 1.0, 1e-12);
  EXPECT_NEAR(measured.branches[0].tubular_share, 0.3, 0.02);
  EXPECT_FALSE(measured.branches[0].tubular);
  EXPECT_FALSE(graph.branches[0].tubular);
  EXPECT_EQ(graph.branches[0].area_share, 0.0);  // the argument is as it was
}

}  // namespace
}  // namespace mgf
