// SPDX-License-Identifier: GPL-3.0-or-later
// The stages together, on shapes whose curve skeleton is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tests/fixtures.h"
#include "tests/implicit_fixtures.h"
#include "tests/voxel_solids.h"
#include "vcg_ext/mgf_skeleton.h"
#include "vcg_ext/skeleton/branches.h"

namespace mgf::test {
namespace {

using namespace fixtures;

struct Study {
  MedialAxis axis;
  MedialGeodesicField field;
  CurveSkeletonResult result;

  explicit Study(const TriangleSurface& surface, const SkeletonOptions& options = {},
                 unsigned threads = 0)
      : axis(compute_medial_axis(surface)),
        field(compute_medial_geodesic_function(axis, {Certification::kProven, threads}).field),
        result(compute_skeleton_hierarchy(axis, field, options)) {}

  CurveSkeleton skeleton() const {
    const SkeletonOptions defaults;
    return skeleton_at(result.hierarchy, defaults.theta, defaults.prune);
  }
  bool warns_of(const std::string& code) const {
    return std::any_of(result.warnings.begin(), result.warnings.end(),
                       [&](const Warning& warning) { return warning.code == code; });
  }
};

std::size_t count_kind(const CurveSkeleton& skeleton, NodeKind kind) {
  const BranchGraph graph = build_branches(skeleton);
  return static_cast<std::size_t>(std::count(graph.node_kind.begin(), graph.node_kind.end(), kind));
}

TriangleSurface y_shape() {
  const Vec3 centre = Vec3::Zero();
  std::vector<SignedDistance> arms;
  for (const double angle : {0.3, 2.5, 4.4}) {
    const Vec3 end = 3.0 * Vec3(std::cos(angle), std::sin(angle), 0.2);
    arms.push_back(capsule(centre, end, 0.5));
  }
  return polygonise(united(arms), {-4, -4, -2}, {4, 4, 2}, 0.16);
}

TriangleSurface capsule_surface() {
  return polygonise(capsule({-2, 0.1, 0}, {2, 0, 0.1}, 0.6), {-3, -1, -1}, {3, 1, 1}, 0.14);
}

/// A bar with round or flat section, finely meshed: `section` gives its outline, anticlockwise.
TriangleSurface bar(const std::vector<std::array<double, 2>>& section, double length, int rings) {
  TriangleSurface surface;
  const Index n = to_index(section.size());
  for (int ring = 0; ring <= rings; ++ring) {
    for (const auto& [x, y] : section) surface.points.emplace_back(x, y, length * ring / rings);
  }
  for (Index ring = 0; ring < static_cast<Index>(rings); ++ring) {
    for (Index i = 0; i < n; ++i) {
      const Index a = ring * n + i;
      const Index b = ring * n + (i + 1) % n;
      surface.triangles.push_back({a, b, b + n});
      surface.triangles.push_back({a, b + n, a + n});
    }
  }
  const Index bottom = to_index(surface.points.size());
  surface.points.emplace_back(0, 0, 0);
  surface.points.emplace_back(0, 0, length);
  for (Index i = 0; i < n; ++i) {
    const Index top_ring = static_cast<Index>(rings) * n;
    surface.triangles.push_back({bottom, (i + 1) % n, i});
    surface.triangles.push_back({bottom + 1, top_ring + i, top_ring + (i + 1) % n});
  }
  return surface;
}

std::vector<std::array<double, 2>> circle_section(int sides, double radius) {
  std::vector<std::array<double, 2>> section;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * kPi * i / sides;
    section.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return section;
}

std::vector<std::array<double, 2>> rectangle_section(double width, double height, double step) {
  std::vector<std::array<double, 2>> section;
  const std::array<std::array<double, 2>, 4> corners = {{{-width / 2, -height / 2},
                                                         {width / 2, -height / 2},
                                                         {width / 2, height / 2},
                                                         {-width / 2, height / 2}}};
  for (std::size_t side = 0; side < 4; ++side) {
    const auto& from = corners[side];
    const auto& to = corners[(side + 1) % 4];
    const int pieces =
        static_cast<int>(std::lround(std::hypot(to[0] - from[0], to[1] - from[1]) / step));
    for (int i = 0; i < pieces; ++i) {
      const double t = static_cast<double>(i) / pieces;
      section.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
    }
  }
  return section;
}

/// Median eccentricity, weighted by nothing, over the edges in the middle half of a bar along z.
double median_eccentricity_of_bar(const std::vector<std::array<double, 2>>& section,
                                  double length) {
  const CurveSkeleton skeleton = Study(bar(section, length, 40)).skeleton();
  std::vector<double> values;
  for (std::size_t e = 0; e < skeleton.edge_count(); ++e) {
    const auto& ends = skeleton.edge[e];
    const double z = (skeleton.position[ends[0]].z() + skeleton.position[ends[1]].z()) / 2;
    if (z > 0.25 * length && z < 0.75 * length) values.push_back(skeleton.eccentricity[e]);
  }
  EXPECT_GT(values.size(), 10U);
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

TEST(Pipeline, ATorusHasOneLoopAndNoTip) {
  const Study run(torus(60, 20, 2.0, 0.6));
  EXPECT_EQ(run.axis.interior.certificate.topology, TopologyVerdict::kProven);
  const CurveSkeleton skeleton = run.skeleton();
  EXPECT_EQ(betti_numbers(skeleton), (BettiNumbers{1, 1, 0}));
  EXPECT_EQ(count_kind(skeleton, NodeKind::kTip), 0U);
}

TEST(Pipeline, ATorusOfRevolutionsSkeletonIsItsCentreCircle) {
  // Every four contacts of a quad lie on a circle, so that most circumcentres are ill-conditioned.
  const CurveSkeleton skeleton = Study(torus(80, 24, 2.0, 0.5)).skeleton();
  EXPECT_EQ(count_kind(skeleton, NodeKind::kTip), 0U);
  double length = 0.0;
  for (const auto& ends : skeleton.edge) {
    length += (skeleton.position[ends[0]] - skeleton.position[ends[1]]).norm();
  }
  EXPECT_NEAR(length, 2 * kPi * 2.0, 0.01 * 2 * kPi * 2.0);
}

TEST(Pipeline, ACapsuleHasTwoTips) {
  const CurveSkeleton skeleton = Study(capsule_surface()).skeleton();
  EXPECT_EQ(betti_numbers(skeleton), (BettiNumbers{1, 0, 0}));
  EXPECT_EQ(count_kind(skeleton, NodeKind::kTip), 2U);
}

TEST(Pipeline, AYHasThreeTipsAndOneJunction) {
  const CurveSkeleton skeleton = Study(y_shape()).skeleton();
  EXPECT_EQ(count_kind(skeleton, NodeKind::kTip), 3U);
  EXPECT_EQ(count_kind(skeleton, NodeKind::kJunction), 1U);
}

TEST(Pipeline, ABentArmKeepsItsGraph) {
  // A body with one arm, whose forearm turns at the elbow.
  const Vec3 shoulder(0, 0, 0.7);
  const Vec3 elbow(1.8, 0.1, 0.7);
  for (const double bend : {0.0, 0.7, 1.3, 1.9}) {
    const Vec3 hand = elbow + 1.6 * Vec3(std::cos(bend), 0.1, std::sin(bend));
    const TriangleSurface body =
        polygonise(united({capsule({0, 0, -1.5}, {0, 0, 1.5}, 0.6), capsule(shoulder, elbow, 0.3),
                           capsule(elbow, hand, 0.3)}),
                   {-1, -1, -2.5}, {4, 1, 2.8}, 0.11);
    const Study study(body);
    EXPECT_EQ(count_kind(study.skeleton(), NodeKind::kTip), 3U) << "bent by " << bend;
    EXPECT_EQ(count_kind(study.skeleton(), NodeKind::kJunction), 1U) << "bent by " << bend;
  }
}

TEST(Pipeline, NoiseChangesAtMostOneLeaf) {
  // Along the normals, so that no faces come to cross.
  const TriangleSurface smooth = y_shape();
  std::vector<Vec3> normal(smooth.points.size(), Vec3::Zero());
  for (const Triangle& t : smooth.triangles) {
    const Vec3 side = smooth.points[t[1]] - smooth.points[t[0]];
    const Vec3 area = side.cross(smooth.points[t[2]] - smooth.points[t[0]]);
    for (const Index v : t) normal[v] += area;
  }
  for (const unsigned seed : {1U, 2U, 3U}) {
    TriangleSurface noisy = smooth;
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> shift(-0.002, 0.002);  // of the diagonal
    const double diagonal = bounding_box_diagonal(smooth.points);
    for (std::size_t v = 0; v < normal.size(); ++v) {
      noisy.points[v] += diagonal * shift(engine) * normal[v].normalized();
    }
    const std::size_t tips = count_kind(Study(noisy).skeleton(), NodeKind::kTip);
    EXPECT_GE(tips, 2U);
    EXPECT_LE(tips, 4U);
  }
}

TEST(Pipeline, ACapsulesSkeletonLiesOnItsAxis) {
  const CurveSkeleton skeleton = Study(capsule_surface()).skeleton();
  const SignedDistance to_axis = capsule({-2, 0.1, 0}, {2, 0, 0.1}, 0.0);
  for (const Vec3& position : skeleton.position) EXPECT_LT(to_axis(position), 0.05 * 0.6);
}

TEST(Pipeline, EccentricityOfACylinderIsOne) {
  EXPECT_NEAR(median_eccentricity_of_bar(circle_section(32, 0.5), 4.0), 1.0, 0.03);
}

TEST(Pipeline, EccentricityOfASquareBarIsFourOverPi) {
  EXPECT_NEAR(median_eccentricity_of_bar(rectangle_section(1, 1, 0.1), 4.0), 4 / kPi, 0.04);
}

TEST(Pipeline, EccentricityOfATwoToOneBarIsSixOverPi) {
  EXPECT_NEAR(median_eccentricity_of_bar(rectangle_section(2, 1, 0.1), 4.0), 6 / kPi, 0.06);
}

TEST(Pipeline, NoEdgeOfTheSkeletonLeavesTheShape) {
  for (const TriangleSurface& surface : {y_shape(), torus(40, 12, 2.0, 0.6), l_block()}) {
    EXPECT_EQ(count_outside_edges(Study(surface).skeleton()), 0U);
  }
}

TEST(Pipeline, SkeletonHasTheBettiNumbersOfTheInterior) {
  for (const TriangleSurface& surface :
       {y_shape(), torus(40, 12, 2.0, 0.6), surface_of_cubes(ring_of_cubes(5))}) {
    const Study run(surface);
    EXPECT_EQ(run.result.hierarchy.betti, run.axis.interior.certificate.betti);
    for (const double theta : {-1.1, -0.9, -0.5, -0.1, 0.0}) {
      const CurveSkeleton skeleton = skeleton_at(run.result.hierarchy, theta, 0.0);
      EXPECT_EQ(betti_numbers(skeleton), run.axis.interior.certificate.betti) << theta;
    }
  }
}

TEST(Pipeline, SkeletonsAreNestedInTheta) {
  const Study run(y_shape());
  std::vector<Index> previous;
  for (const double theta : {-1.1, -0.9, -0.7, -0.5, -0.3, -0.1, 0.0}) {
    std::vector<Index> edges = skeleton_at(run.result.hierarchy, theta, 0.0).voronoi_edge;
    std::sort(edges.begin(), edges.end());
    EXPECT_TRUE(std::includes(edges.begin(), edges.end(), previous.begin(), previous.end()));
    previous = edges;
  }
}

TEST(Pipeline, TwoSolidsHaveASkeletonEach) {
  const TriangleSurface two =
      joined(torus(40, 12, 2.0, 0.6), moved(capsule_surface(), Vec3(7, 1, 2)));
  const Study run(two);
  EXPECT_EQ(run.axis.working.solids, 2U);
  EXPECT_EQ(betti_numbers(run.skeleton()), (BettiNumbers{2, 1, 0}));
}

TEST(Pipeline, AHouseWithTwoRoomsHasAClosedPocketThatCanBeOpened) {
  const TriangleSurface house = midpoint_subdivided(surface_of_cubes(house_with_two_rooms()));
  const Study kept(house);
  EXPECT_EQ(kept.axis.interior.certificate.betti, (BettiNumbers{1, 0, 0}));
  EXPECT_GT(kept.result.hierarchy.residual_facets, 0U);
  EXPECT_TRUE(kept.warns_of("closed_pocket"));

  SkeletonOptions options;
  options.open_pockets = true;
  const Study opened(house, options);
  EXPECT_EQ(opened.result.hierarchy.residual_facets, 0U);
  EXPECT_GT(opened.result.hierarchy.pockets_opened, 0U);
  EXPECT_TRUE(opened.warns_of("pocket_opened"));
}

/// Sorted edges, each as its sorted ends' distances from the first point of the surface: numbers
/// that no rigid motion and no renumbering changes.
std::vector<std::array<double, 2>> fingerprint(const CurveSkeleton& skeleton, const Vec3& origin,
                                               double unit) {
  std::vector<std::array<double, 2>> result;
  for (const auto& ends : skeleton.edge) {
    double p = (skeleton.position[ends[0]] - origin).norm() / unit;
    double q = (skeleton.position[ends[1]] - origin).norm() / unit;
    if (p > q) std::swap(p, q);
    result.push_back({p, q});
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_same(const std::vector<std::array<double, 2>>& a,
                 const std::vector<std::array<double, 2>>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i][0], b[i][0], 1e-7);
    EXPECT_NEAR(a[i][1], b[i][1], 1e-7);
  }
}

/// A surface shaken so that no two values tie.
TriangleSurface shaken(TriangleSurface surface, double by) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> offset(-by, by);
  for (Vec3& p : surface.points) p += Vec3(offset(random), offset(random), offset(random));
  return surface;
}

TriangleSurface generic_y() {
  return shaken(y_shape(), 1e-3);
}

TEST(Pipeline, ScaleScalesTheSkeleton) {
  const TriangleSurface surface = generic_y();
  const auto original = fingerprint(Study(surface).skeleton(), surface.points[0], 1.0);
  for (const double factor : {1e-6, 1e6}) {
    const TriangleSurface sized = scaled(surface, factor);
    expect_same(original, fingerprint(Study(sized).skeleton(), sized.points[0], factor));
  }
}

TEST(Pipeline, RigidMotionMovesTheSkeletonAlong) {
  for (const TriangleSurface& surface : {generic_y(), shaken(torus(60, 20, 2.0, 0.6), 0.01)}) {
    const TriangleSurface turned = rotated(surface, 0.7, Vec3(1, 2, 3).normalized());
    expect_same(fingerprint(Study(surface).skeleton(), surface.points[0], 1.0),
                fingerprint(Study(turned).skeleton(), turned.points[0], 1.0));
  }
}

TEST(Pipeline, RenumberingKeepsTheSkeleton) {
  const TriangleSurface surface = generic_y();
  std::vector<Index> number(surface.points.size());
  std::iota(number.begin(), number.end(), Index{0});
  std::mt19937 random(11);
  std::shuffle(number.begin(), number.end(), random);
  TriangleSurface renumbered = surface;
  for (std::size_t v = 0; v < number.size(); ++v) renumbered.points[number[v]] = surface.points[v];
  for (Triangle& t : renumbered.triangles) t = {number[t[1]], number[t[2]], number[t[0]]};
  std::shuffle(renumbered.triangles.begin(), renumbered.triangles.end(), random);
  const Vec3 origin = surface.points[0];
  expect_same(fingerprint(Study(surface).skeleton(), origin, 1.0),
              fingerprint(Study(renumbered).skeleton(), origin, 1.0));
}

TEST(Pipeline, ThreadsDoNotChangeTheResult) {
  const TriangleSurface surface = y_shape();
  const Study one(surface, {}, 1);
  const Study two(surface, {}, 2);
  EXPECT_EQ(one.field.mgf, two.field.mgf);
  EXPECT_EQ(one.skeleton().position, two.skeleton().position);
}

TEST(Pipeline, MgfOnAPrismIsTheUnfoldedDistance) {
  const Index sides = 32;
  const int rings = 40;
  const double length = 4.0;
  const double radius = 0.5;
  const Study study(bar(circle_section(static_cast<int>(sides), radius), length, rings));
  const double side = 2 * radius * std::sin(kPi / sides);
  const std::vector<Vec3>& points = study.axis.surface.surface.points;
  std::size_t checked = 0;
  for (std::size_t f = 0; f < study.field.mgf.size(); ++f) {
    const auto [a, b] = study.axis.complex.facet_contacts[f];
    const double nearest_cap =
        std::min({points[a].z(), points[b].z(), length - points[a].z(), length - points[b].z()});
    if (nearest_cap < 2 * radius) continue;  // a path might cross the cap
    const Index apart = (b % sides + sides - a % sides) % sides;
    const double across = side * std::min(apart, sides - apart);
    const double expected = std::hypot(across, points[b].z() - points[a].z());
    EXPECT_NEAR(study.field.mgf[f], expected, 1e-9 * expected);
    ++checked;
  }
  EXPECT_GT(checked, 100U);
}

}  // namespace
}  // namespace mgf::test
