// SPDX-License-Identifier: GPL-3.0-or-later
// What scripts depend on: names, parameters, pages, sample scripts.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filter.h"
#include "tests/filter_runs.h"

namespace mgf::plugin::test {
namespace {

namespace fs = std::filesystem;

/// The word by which a filter's page and script are called: that of its source file.
std::string slug(const std::string& name) {
  static const std::map<std::string, std::string> slugs = {
      {"Medial Axis (Voronoi)", "medial_axis"},
      {"Medial Geodesic Function", "medial_geodesic_function"},
      {"Curve Skeleton (MGF)", "curve_skeleton"},
      {"Tubular and Flat Segmentation (Geodesic Circles)", "segmentation"},
      {"Curve Skeleton Level of Detail", "level_of_detail"},
      {"Part Decomposition by Curve Skeleton", "part_decomposition"},
      {"Check Mesh for Curve Skeleton", "check_mesh"},
      {"Export Curve Skeleton Files", "export_files"},
  };
  return slugs.at(name);
}

fs::path source_folder() {
  return MGF_SOURCE_DIR;
}

TEST(Filters, KeepTheirFrozenNames) {
  std::vector<std::string> names;
  for (const Filter& filter : all_filters()) names.push_back(filter.name);
  EXPECT_EQ(names, (std::vector<std::string>{
                       "Medial Axis (Voronoi)", "Medial Geodesic Function", "Curve Skeleton (MGF)",
                       "Tubular and Flat Segmentation (Geodesic Circles)",
                       "Curve Skeleton Level of Detail", "Part Decomposition by Curve Skeleton",
                       "Check Mesh for Curve Skeleton", "Export Curve Skeleton Files"}));
}

TEST(Filters, KeepTheirFrozenParameterKeys) {
  const auto keys = [](const std::string& name) {
    std::string all;
    for (const Parameter& parameter : filter_named(name).parameters) all += parameter.key + " ";
    return all;
  };
  EXPECT_EQ(keys("Medial Axis (Voronoi)"),
            "samplingDensity samplingLength ignoreCavities liftOverlaps ");
  EXPECT_EQ(keys("Medial Geodesic Function"),
            "samplingDensity samplingLength ignoreCavities liftOverlaps ");
  EXPECT_EQ(keys("Curve Skeleton (MGF)"),
            "theta prune quality markingRule openPockets "
            "samplingDensity samplingLength ignoreCavities liftOverlaps ");
  EXPECT_EQ(keys("Tubular and Flat Segmentation (Geodesic Circles)"),
            "eccentricityThreshold quality theta prune "
            "samplingDensity samplingLength ignoreCavities liftOverlaps ");
  EXPECT_EQ(keys("Curve Skeleton Level of Detail"), "theta prune quality ");
  EXPECT_EQ(keys("Part Decomposition by Curve Skeleton"),
            "theta prune eccentricityThreshold "
            "samplingDensity samplingLength ignoreCavities liftOverlaps ");
  EXPECT_EQ(keys("Check Mesh for Curve Skeleton"), "");
  EXPECT_EQ(keys("Export Curve Skeleton Files"),
            "outputFolder coordinatesFile theta prune eccentricityThreshold markingRule "
            "openPockets samplingDensity samplingLength ignoreCavities liftOverlaps threads ");
}

TEST(Filters, DescribeEachParameterWithinItsOwnRange) {
  for (const Filter& filter : all_filters()) {
    EXPECT_NO_THROW(check_ranges(filter.parameters, default_values(filter, small_torus())));
    std::set<std::string> keys;
    for (const Parameter& parameter : filter.parameters) {
      EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key << " twice";
      EXPECT_FALSE(parameter.label.empty()) << parameter.key;
      EXPECT_FALSE(parameter.tooltip.empty()) << parameter.key;
      EXPECT_LE(parameter.low, parameter.high) << parameter.key;
      if (parameter.kind == ParameterKind::kChoice) {
        EXPECT_EQ(parameter.choices.size(), static_cast<std::size_t>(parameter.high) + 1)
            << parameter.key;
      }
    }
  }
}

TEST(Filters, HaveAPageWithTheTableOfTheirParameters) {
  for (const Filter& filter : all_filters()) {
    const std::string page =
        text_of(source_folder() / "docs/filters" / (slug(filter.name) + ".md"));
    EXPECT_NE(page.find("# " + filter.name + "\n"), std::string::npos) << filter.name;
    if (filter.parameters.empty()) continue;
    EXPECT_NE(page.find(markdown_table(filter.parameters)), std::string::npos)
        << filter.name << ": the page needs this table:\n"
        << markdown_table(filter.parameters);
  }
}

TEST(Filters, HaveASampleScriptThatListsEveryParameterInOrder) {
  for (const Filter& filter : all_filters()) {
    const std::string script =
        text_of(source_folder() / "scripts/mlx" / (slug(filter.name) + ".mlx"));
    EXPECT_NE(script.find("<filter name=\"" + filter.name + "\""), std::string::npos);
    std::vector<std::string> listed;
    const std::regex parameter("<Param[^>]*? name=\"([A-Za-z]+)\"");
    for (std::sregex_iterator i(script.begin(), script.end(), parameter), end; i != end; ++i) {
      listed.push_back((*i)[1]);
    }
    std::vector<std::string> declared;
    for (const Parameter& p : filter.parameters) declared.push_back(p.key);
    EXPECT_EQ(listed, declared) << filter.name;
  }
}

}  // namespace
}  // namespace mgf::plugin::test
