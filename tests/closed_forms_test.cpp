// SPDX-License-Identifier: GPL-3.0-or-later
// Eccentricity and segmentation, through all stages, on shapes whose answer is known on paper.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/anatomy.h"
#include "tests/lofted_fixtures.h"

namespace mgf {
namespace {

using test::Anatomy;
using test::circle_section;
using test::dissect;
using test::lofted;
using test::rectangle_section;

double polyline_length(const Row<Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/// The circles drawn are the ones measured: closed, and of length g(E).
void expect_circles_drawn(const Anatomy& anatomy) {
  for (Index e = 0; e < anatomy.skeleton.edge_count(); ++e) {
    const Row<Vec3> circle = anatomy.circles.polyline[e];
    EXPECT_EQ(circle.front(), circle.back());
    EXPECT_NEAR(polyline_length(circle), anatomy.skeleton.girth[e],
                1e-9 * anatomy.skeleton.girth[e]);
  }
}

TEST(ClosedForms, ARoundRodHasEccentricityOne) {
  const double radius = 0.5;
  const Anatomy rod = dissect(
      lofted(6.0, 50, 40, [&](double /*x*/, double u) { return circle_section(radius, u); }), 1.3);
  ASSERT_EQ(rod.graph.branches.size(), 1U);
  const Branch& branch = rod.graph.branches[0];
  EXPECT_NEAR(branch.eccentricity_median, 1.0, 0.03);
  EXPECT_NEAR(branch.radius_mean, radius, 0.01 * radius);
  EXPECT_NEAR(branch.girth_mean, 2 * M_PI * radius, 0.02 * 2 * M_PI * radius);
  EXPECT_TRUE(branch.tubular);
  EXPECT_DOUBLE_EQ(rod.segmentation.tubular_area_share, 1.0);
  EXPECT_EQ(rod.segmentation.unlabelled_faces, 0U);
  EXPECT_LE(rod.smooth.mean_turning, 5 * M_PI / 180);
  EXPECT_EQ(rod.smooth.outside_edges, 0U);
  for (const Vec3& p : rod.smooth.position) EXPECT_LE(std::hypot(p.y(), p.z()), 0.05 * radius);
  expect_circles_drawn(rod);
}

TEST(ClosedForms, BarsHaveTheirPerimeterOverTheirInscribedCircle) {
  // g is the perimeter; three contacts on the two wide sides, or on three sides of a square, span
  // the inscribed circle: 4 / pi for a square, 6 / pi for two to one.
  const Anatomy square = dissect(
      lofted(6.0, 40, 48, [](double /*x*/, double u) { return rectangle_section(1, 1, u); }), 1.3);
  EXPECT_NEAR(square.graph.branches.at(0).eccentricity_median, 4 / M_PI, 0.03 * 4 / M_PI);
  EXPECT_DOUBLE_EQ(square.segmentation.tubular_area_share, 1.0);

  const Anatomy flat = dissect(
      lofted(10.0, 40, 60, [](double /*x*/, double u) { return rectangle_section(2, 1, u); }), 1.3);
  EXPECT_NEAR(flat.graph.branches.at(0).eccentricity_median, 6 / M_PI, 0.03 * 6 / M_PI);
  EXPECT_DOUBLE_EQ(flat.segmentation.tubular_area_share, 0.0);
  EXPECT_FALSE(flat.graph.branches.at(0).tubular);
  expect_circles_drawn(flat);
}

TEST(ClosedForms, APaddleIsRoundAtTheRodAndFlatAtTheBlade) {
  const TriangleSurface surface = test::paddle();
  const Anatomy anatomy = dissect(surface, 1.3);
  std::size_t right = 0;
  std::size_t judged = 0;
  for (Index f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    const double x =
        (surface.points[t[0]].x() + surface.points[t[1]].x() + surface.points[t[2]].x()) / 3;
    if (x > 5.0 && x < 5.5) continue;  // between rod and blade
    ++judged;
    if ((anatomy.segmentation.tubular[f] != 0) == (x <= 5.0)) ++right;
  }
  EXPECT_GE(static_cast<double>(right), 0.97 * static_cast<double>(judged));
}

}  // namespace
}  // namespace mgf
