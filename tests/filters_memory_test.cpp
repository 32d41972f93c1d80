// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept from one run to the next, and when it is computed anew.
#include <gtest/gtest.h>

#include <cstddef>

#include "filter_mgf_skeleton/filter.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/filter_runs.h"
#include "tests/fixtures.h"

namespace mgf::plugin::test {
namespace {

TEST(Workbench, TakesAMeshItHasSeenFromItsMemory) {
  Workbench workbench;
  const TriangleSurface mesh = small_torus();
  const Study first = workbench.study(mesh, {}, Stage::kHierarchy, {});
  const Study second = workbench.study(mesh, {}, Stage::kHierarchy, {});
  EXPECT_EQ(first.axis, second.axis);
  EXPECT_EQ(first.function, second.function);
  EXPECT_EQ(first.result, second.result);
  EXPECT_EQ(workbench.latest_study(mesh, {}).result, first.result);
}

TEST(Workbench, NoticesAnEdit) {
  Workbench workbench;
  TriangleSurface mesh = small_torus();
  const Study before = workbench.study(mesh, {}, Stage::kMedialAxis, {});
  mesh.points[7] *= 1.0 + 1e-15;
  EXPECT_NE(workbench.study(mesh, {}, Stage::kMedialAxis, {}).axis, before.axis);
}

TEST(Workbench, ComputesAnewWhatOtherOptionsChangeAndNothingElse) {
  Workbench workbench;
  const TriangleSurface mesh = small_torus();
  const Study all = workbench.study(mesh, {}, Stage::kHierarchy, {});
  StudyOptions options;
  options.skeleton.marking_rule = MarkingRule::kOnePerFacet;
  options.geodesics.threads = 1;
  const Study paper = workbench.study(mesh, options, Stage::kHierarchy, {});
  EXPECT_EQ(paper.function, all.function);
  EXPECT_NE(paper.result, all.result);
  options.medial_axis.recovery.lift_overlaps = !options.medial_axis.recovery.lift_overlaps;
  EXPECT_NE(workbench.study(mesh, options, Stage::kMedialAxis, {}).axis, all.axis);
}

TEST(LevelOfDetail, ReplacesItsLayersAndNestsInTheta) {
  Workbench workbench;
  const TriangleSurface mesh = fixtures::midpoint_subdivided(
      fixtures::midpoint_subdivided(fixtures::midpoint_subdivided(fixtures::l_block())));
  std::size_t former = 0;
  for (const double theta : {-1.1, -0.9, -0.5, -0.1}) {
    const FilterOutcome outcome =
        run("Curve Skeleton Level of Detail", mesh, workbench, [&](ParameterValues& values) {
          values.set("theta", theta);
          values.set("prune", 0.0);
        });
    ASSERT_FALSE(outcome.failure) << outcome.failure->message;
    for (const Layer& layer : outcome.output.layers) EXPECT_TRUE(layer.replaces_former);
    const std::size_t edges = outcome.output.layers.front().edges.size();
    EXPECT_GE(edges, former);
    former = edges;
  }
}

}  // namespace
}  // namespace mgf::plugin::test
