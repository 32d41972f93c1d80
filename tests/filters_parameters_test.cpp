// SPDX-License-Identifier: GPL-3.0-or-later
// What values the filters take.
#include <gtest/gtest.h>

#include <limits>

#include "filter_mgf_skeleton/filter.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/filter_runs.h"
#include "vcg_ext/core/errors.h"

namespace mgf::plugin::test {
namespace {

TEST(Parameters, OutOfRangeIsRefusedWithTheName) {
  Workbench workbench;
  for (const double theta : {-1.2, 0.1, std::numeric_limits<double>::quiet_NaN()}) {
    const FilterOutcome outcome = run("Curve Skeleton (MGF)", small_torus(), workbench,
                                      [&](ParameterValues& values) { values.set("theta", theta); });
    ASSERT_TRUE(outcome.failure);
    EXPECT_EQ(outcome.failure->code, "parameter_out_of_range");
    EXPECT_NE(outcome.failure->message.find("theta"), std::string::npos);
  }
}

TEST(Parameters, ALimitThatPassedThroughSinglePrecisionIsAccepted) {
  EXPECT_NO_THROW(check_range(parameters::theta(), static_cast<double>(-1.1F), 1.0));
}

TEST(Parameters, ALengthThatIsNotUsedIsNotChecked) {
  ParameterValues values = default_values(filter_named("Medial Axis (Voronoi)"), small_torus());
  values.set("samplingLength", 1e9);
  EXPECT_NO_THROW(parameters::medial_axis_options(values, small_torus()));
  values.set("samplingDensity", static_cast<int>(parameters::Sampling::kFixed));
  EXPECT_THROW(parameters::medial_axis_options(values, small_torus()), InputError);
}

TEST(Parameters, AMissingOrMistypedValueIsAnInputError) {
  ParameterValues values;
  EXPECT_THROW(values.number(parameters::theta()), InputError);
  values.set("theta", true);
  EXPECT_THROW(values.number(parameters::theta()), InputError);
}

}  // namespace
}  // namespace mgf::plugin::test
