// SPDX-License-Identifier: GPL-3.0-or-later
// The layers and colours that the filters give back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filter.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/filter_runs.h"
#include "tests/fixtures.h"
#include "vcg_ext/core/constants.h"

namespace mgf::plugin::test {
namespace {

void expect_whole(const Layer& layer) {
  const auto full_or_empty = [&](std::size_t size, std::size_t count) {
    EXPECT_TRUE(size == 0 || size == count) << layer.name;
  };
  full_or_empty(layer.point_quality.size(), layer.points.size());
  full_or_empty(layer.point_colour.size(), layer.points.size());
  full_or_empty(layer.faux_edges.size(), layer.triangles.size());
  full_or_empty(layer.face_quality.size(), layer.triangles.size());
  full_or_empty(layer.face_colour.size(), layer.triangles.size());
  for (const Attribute& attribute : layer.point_attributes) {
    EXPECT_EQ(attribute.values.size(), layer.points.size()) << attribute.name;
  }
  for (const Attribute& attribute : layer.face_attributes) {
    EXPECT_EQ(attribute.values.size(), layer.triangles.size()) << attribute.name;
  }
  for (const Triangle& t : layer.triangles) {
    for (const Index corner : t) ASSERT_LT(corner, layer.points.size()) << layer.name;
  }
  for (const auto& ends : layer.edges) {
    for (const Index end : ends) ASSERT_LT(end, layer.points.size()) << layer.name;
  }
  for (const Vec3& p : layer.points) ASSERT_TRUE(p.allFinite()) << layer.name;
  for (const double q : layer.point_quality) ASSERT_TRUE(std::isfinite(q)) << layer.name;
  for (const double q : layer.face_quality) ASSERT_TRUE(std::isfinite(q)) << layer.name;
}

TEST(Filters, GiveWholeLayersAndPaintOnEveryElement) {
  Workbench workbench;
  const TriangleSurface mesh = small_torus();
  for (const Filter& filter : all_filters()) {
    if (filter.effect == FilterEffect::kWritesFiles) continue;
    const FilterOutcome outcome = run(filter.name, mesh, workbench);
    ASSERT_FALSE(outcome.failure) << filter.name << ": " << outcome.failure->message;
    for (const Layer& layer : outcome.output.layers) {
      EXPECT_FALSE(layer.points.empty()) << layer.name;
      expect_whole(layer);
    }
    if (!outcome.output.paint) continue;
    const Paint& paint = *outcome.output.paint;
    EXPECT_EQ(paint.face_quality.size(), mesh.triangles.size());
    EXPECT_EQ(paint.face_colour.size(), mesh.triangles.size());
    EXPECT_TRUE(paint.point_quality.empty() || paint.point_quality.size() == mesh.points.size());
  }
}

// Of solids that overlap some contacts lie on different ones, so that no path joins them.
TEST(Filters, GiveWholeLayersOfSolidsThatOverlap) {
  Workbench workbench;
  const TriangleSurface torus = fixtures::torus(20, 8, 2.0, 0.7);
  const TriangleSurface mesh =
      fixtures::joined(torus, fixtures::moved(torus, Vec3(0.5, 0.1, 0.05)));
  StudyOptions options;
  options.medial_axis.sampling.length = 0.0;
  const Study study = workbench.study(mesh, options, Stage::kField, {});
  const std::vector<double>& mgf = study.function->field.mgf;
  ASSERT_FALSE(std::all_of(mgf.begin(), mgf.end(), [](double f) { return std::isfinite(f); }));
  for (const Filter& filter : all_filters()) {
    if (filter.effect == FilterEffect::kWritesFiles) continue;
    const FilterOutcome outcome = run(filter.name, mesh, workbench, [](ParameterValues& values) {
      values.set("samplingDensity", static_cast<int>(parameters::Sampling::kOff));
    });
    ASSERT_FALSE(outcome.failure) << filter.name << ": " << outcome.failure->message;
    for (const Layer& layer : outcome.output.layers) expect_whole(layer);
    if (!outcome.output.paint) continue;
    for (const double q : outcome.output.paint->face_quality) {
      ASSERT_TRUE(std::isfinite(q)) << filter.name;
    }
    for (const double q : outcome.output.paint->point_quality) {
      ASSERT_TRUE(std::isfinite(q)) << filter.name;
    }
  }
}

TEST(MedialAxisLayer, ShowsEachPolygonsOwnSidesOnce) {
  Workbench workbench;
  const FilterOutcome outcome = run("Medial Axis (Voronoi)", small_torus(), workbench);
  ASSERT_FALSE(outcome.failure);
  const Layer& layer = outcome.output.layers.front();
  const std::vector<double>& facet = layer.face_attributes[2].values;
  for (std::size_t first = 0; first < facet.size();) {
    std::size_t last = first;
    int sides = 0;
    while (last < facet.size() && facet[last] == facet[first]) {
      for (unsigned i = 0; i < 3; ++i) sides += ((layer.faux_edges[last] >> i) & 1U) == 0 ? 1 : 0;
      ++last;
    }
    EXPECT_EQ(sides, static_cast<int>(last - first) + 2);  // a polygon of n sides: n - 2 triangles
    first = last;
  }
}

TEST(MedialAxisLayer, GivesEachSheetOneOrientation) {
  Workbench workbench;
  const FilterOutcome outcome = run("Medial Axis (Voronoi)", small_torus(), workbench);
  ASSERT_FALSE(outcome.failure);
  std::map<std::pair<Index, Index>, int> runs;  // directed sides: how often
  for (const Triangle& t : outcome.output.layers.front().triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++runs[{t[i], t[(i + 1) % 3]}];
  }
  int agreeing = 0;
  int clashing = 0;
  for (const auto& [side, count] : runs) {
    const auto opposite = runs.find({side.second, side.first});
    const int back = opposite == runs.end() ? 0 : opposite->second;
    if (count + back != 2) continue;
    (back == 1 ? agreeing : clashing) += 1;
  }
  EXPECT_GT(agreeing, 0);
  EXPECT_LE(clashing, agreeing / 100);
}

TEST(MedialGeodesicFunctionPaint, ReachesHalfTheGirthOfARoundTubeAndNoMore) {
  Workbench workbench;
  const TriangleSurface torus = fixtures::torus(60, 24, 3.0, 0.5);
  const FilterOutcome outcome = run("Medial Geodesic Function", torus, workbench);
  ASSERT_FALSE(outcome.failure);
  // Rings of 24 corners are cocircular: not each corner need have a facet to the one opposite.
  const std::vector<double>& quality = outcome.output.paint->face_quality;
  const double half_girth = kPi * 0.5;
  EXPECT_NEAR(*std::max_element(quality.begin(), quality.end()), half_girth, 0.02 * half_girth);
  EXPECT_GT(*std::min_element(quality.begin(), quality.end()), 0.0);
}

TEST(CurveSkeletonLayers, AreOneLoopInATorus) {
  Workbench workbench;
  const FilterOutcome outcome = run("Curve Skeleton (MGF)", small_torus(), workbench);
  ASSERT_FALSE(outcome.failure);
  ASSERT_EQ(outcome.output.layers.size(), 3U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Layer& lines = outcome.output.layers[i];
    EXPECT_EQ(lines.edges.size(), lines.points.size()) << lines.name;
  }
  for (const Measurement& measure : outcome.output.measures) {
    if (measure.key == "skeleton_b0" || measure.key == "skeleton_b1") {
      EXPECT_EQ(measure.value, 1.0) << measure.key;
    }
    if (measure.key == "outside_edges" || measure.key == "skeleton_tips") {
      EXPECT_EQ(measure.value, 0.0) << measure.key;
    }
  }
}

}  // namespace
}  // namespace mgf::plugin::test
