// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/inside_routes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vcg_ext/medial/placement.h"

namespace mgf::test {
namespace {

/// The solid `contains`, whose segments are judged by a thousand of their points.
template <class Contains>
ShapeInterior sampled_shape(const Contains& contains) {
  return {contains, [contains](const Vec3& a, const Vec3& b) {
            for (int i = 0; i <= 1000; ++i) {
              if (contains(a + (b - a) * (i / 1000.0)) != contains(a)) return false;
            }
            return true;
          }};
}

bool in_unit_ball(const Vec3& p) {
  return p.norm() < 1.0;
}

TEST(InsideParts, OnePointSpeaksForAllThatClearEdgesJoin) {
  const std::vector<Vec3> nodes{Vec3(0.9, 0, 0), Vec3(0, 0.9, 0), Vec3(0, 2, 0), Vec3(0, 3, 0),
                                Vec3(0, 0, 0.5)};
  const std::vector<std::array<Index, 2>> edges{{0, 1}, {1, 2}, {2, 3}};
  int questions = 0;
  ShapeInterior shape = sampled_shape(in_unit_ball);
  shape.contains = [&questions](const Vec3& p) {
    ++questions;
    return in_unit_ball(p);
  };
  const InsideParts inside = find_inside_parts(shape, nodes, edges, 1);
  EXPECT_EQ(inside.node, (std::vector<char>{1, 1, 0, 0, 1}));
  EXPECT_EQ(inside.edge_is_clear, (std::vector<char>{1, 0, 1}));
  EXPECT_TRUE(inside.has_edge(0, edges[0]));
  EXPECT_FALSE(inside.has_edge(2, edges[2])) << "clear, but outside";
  EXPECT_EQ(questions, 3);
}

/// Two tetrahedra that share the triangle 0 1 2, bent like an open book.
InteriorTetrahedra open_book() {
  InteriorTetrahedra book;
  book.points = {Vec3(0, 0, 0), Vec3(0, 2, 0), Vec3(0, 1, 1), Vec3(3, 1, 3), Vec3(-3, 1, 3)};
  book.tetrahedra = {{0, 1, 2, 3}, {1, 0, 2, 4}};
  return book;
}

bool in_tetrahedron(const InteriorTetrahedra& solid, const Tetrahedron& corners, const Vec3& p) {
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) {
    edges.col(i) =
        solid.points[corners[static_cast<std::size_t>(i) + 1]] - solid.points[corners[0]];
  }
  const Vec3 shares = edges.inverse() * (p - solid.points[corners[0]]);
  return shares.minCoeff() > -1e-9 && shares.sum() < 1 + 1e-9;
}

/// One edge between points of the two tetrahedra.
VoronoiSkeleton edge_in_book(const Vec3& from, const Vec3& to) {
  VoronoiSkeleton drawing;
  drawing.voronoi_vertex = {0, 1};
  CurveSkeleton& skeleton = drawing.skeleton;
  skeleton.position = {from, to};
  skeleton.radius = skeleton.node_mgf = skeleton.node_eccentricity = {1.0, 1.0};
  skeleton.edge = {{0, 1}};
  skeleton.mgf = skeleton.girth = skeleton.circumference = skeleton.eccentricity = {2.0};
  skeleton.theta_birth = {-0.5};
  skeleton.voronoi_edge = {0};
  skeleton.contacts = {{0, 1, 2}};
  skeleton.outside = {0};
  return drawing;
}

class BookRoutes : public ::testing::Test {
 protected:
  InteriorTetrahedra book_ = open_book();
  ShapeInterior shape_ = sampled_shape([this](const Vec3& p) {
    return in_tetrahedron(book_, book_.tetrahedra[0], p) ||
           in_tetrahedron(book_, book_.tetrahedra[1], p);
  });

  void expect_all_inside(const CurveSkeleton& skeleton) const {
    for (Index e = 0; e < skeleton.edge_count(); ++e) {
      const Vec3& from = skeleton.position[skeleton.edge[e][0]];
      EXPECT_EQ(skeleton.outside[e], 0);
      EXPECT_TRUE(shape_.contains(from));
      EXPECT_TRUE(shape_.stays_inside(from, skeleton.position[skeleton.edge[e][1]]));
    }
  }
};

TEST_F(BookRoutes, LeaveAnEdgeThatIsInside) {
  VoronoiSkeleton drawing = edge_in_book(Vec3(0.1, 1, 0.5), Vec3(-0.1, 1, 0.5));
  route_inside(book_, shape_, 1, drawing);
  EXPECT_EQ(drawing.skeleton.edge_count(), 1U);
  expect_all_inside(drawing.skeleton);
}

TEST_F(BookRoutes, LeadAnEdgeThroughTheSharedTriangle) {
  VoronoiSkeleton drawing = edge_in_book(Vec3(2, 1, 2.2), Vec3(-2, 1, 2.2));
  ASSERT_FALSE(shape_.stays_inside(drawing.skeleton.position[0], drawing.skeleton.position[1]));
  route_inside(book_, shape_, 1, drawing);
  EXPECT_EQ(drawing.skeleton.edge_count(), 2U);
  EXPECT_EQ(drawing.skeleton.node_count(), 3U);
  EXPECT_EQ(drawing.skeleton.theta_birth, (std::vector<double>{-0.5, -0.5}));
  expect_all_inside(drawing.skeleton);
}

TEST_F(BookRoutes, LookForAGateWhereTheMiddleOfTheTriangleIsOutside) {
  const Vec3 middle = (book_.points[0] + book_.points[1] + book_.points[2]) / 3.0;
  const ShapeInterior book = shape_;
  shape_ = sampled_shape(
      [book, middle](const Vec3& p) { return book.contains(p) && (p - middle).norm() > 0.15; });
  VoronoiSkeleton drawing = edge_in_book(Vec3(2, 1, 2.2), Vec3(-2, 1, 2.2));
  route_inside(book_, shape_, 1, drawing);
  EXPECT_EQ(drawing.skeleton.edge_count(), 2U);
  expect_all_inside(drawing.skeleton);
}

TEST_F(BookRoutes, CallInNodesThatAreOutside) {
  VoronoiSkeleton drawing = edge_in_book(Vec3(2, 1, 2.2), Vec3(-9, 1, 2.2));
  route_inside(book_, shape_, 1, drawing);
  EXPECT_EQ(drawing.skeleton.position[1], tetrahedron_centroid(book_, 1));
  EXPECT_EQ(drawing.skeleton.position[0], Vec3(2, 1, 2.2));
  expect_all_inside(drawing.skeleton);
}

}  // namespace
}  // namespace mgf::test
