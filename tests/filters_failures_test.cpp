// SPDX-License-Identifier: GPL-3.0-or-later
// What the filters say and leave where they can give no result.
#include <gtest/gtest.h>

#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filter.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/filter_runs.h"

namespace mgf::plugin::test {
namespace {

TEST(Filters, RefuseABrokenMeshWithTheDoctorsCodeAndItsCulprits) {
  Workbench workbench;
  for (const Filter& filter : all_filters()) {
    if (filter.effect == FilterEffect::kSelects || filter.effect == FilterEffect::kWritesFiles) {
      continue;
    }
    const FilterOutcome outcome = run(filter.name, open_box(), workbench);
    ASSERT_TRUE(outcome.failure) << filter.name;
    EXPECT_EQ(outcome.failure->code, "boundary_loops") << filter.name;
    EXPECT_TRUE(outcome.output.layers.empty());
    EXPECT_FALSE(outcome.output.paint);
    ASSERT_TRUE(outcome.output.selection);
    EXPECT_EQ(outcome.output.selection->faces.empty() && outcome.output.selection->points.empty(),
              false);
  }
}

TEST(CheckMesh, SucceedsOnABrokenMeshAndSelectsTheCulprits) {
  Workbench workbench;
  const FilterOutcome outcome = run("Check Mesh for Curve Skeleton", open_box(), workbench);
  EXPECT_FALSE(outcome.failure);
  ASSERT_TRUE(outcome.output.selection);
  EXPECT_FALSE(outcome.output.selection->faces.empty() && outcome.output.selection->points.empty());
  EXPECT_TRUE(outcome.output.layers.empty());
}

TEST(CheckMesh, SelectsNothingOnASoundMesh) {
  Workbench workbench;
  const FilterOutcome outcome = run("Check Mesh for Curve Skeleton", small_torus(), workbench);
  ASSERT_TRUE(outcome.output.selection);
  EXPECT_TRUE(outcome.output.selection->faces.empty());
  EXPECT_TRUE(outcome.output.selection->points.empty());
}

TEST(Filters, StopWhenTheUserAsks) {
  Workbench workbench;
  const Filter& filter = filter_named("Curve Skeleton (MGF)");
  const TriangleSurface mesh = small_torus();
  const ParameterValues values = default_values(filter, mesh);
  const Progress stop([](double, const char*) { return false; });
  const FilterOutcome outcome = run_filter(filter, {mesh, "mesh", values, workbench, stop});
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code, "cancelled");
}

}  // namespace
}  // namespace mgf::plugin::test
