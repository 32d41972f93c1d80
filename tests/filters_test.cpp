// SPDX-License-Identifier: GPL-3.0-or-later
// The filters without a host: what they ask for, what they give back, what they keep.
#include "filter_mgf_skeleton/filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/fixtures.h"

namespace mgf::plugin {
namespace {

namespace fs = std::filesystem;

const Filter& filter_named(const std::string& name) {
  for (const Filter& filter : all_filters()) {
    if (filter.name == name) return filter;
  }
  throw std::logic_error("no filter " + name);
}

ParameterValues default_values(const Filter& filter, const TriangleSurface& mesh) {
  ParameterValues values;
  for (const Parameter& parameter : filter.parameters) {
    values.set(parameter.key, initial_value(parameter, bounding_box_diagonal(mesh.points)));
  }
  return values;
}

/// A filter run with its defaults, but for what `change` sets.
FilterOutcome run(const std::string& name, const TriangleSurface& mesh, Workbench& workbench,
                  const std::function<void(ParameterValues&)>& change = {}) {
  const Filter& filter = filter_named(name);
  ParameterValues values = default_values(filter, mesh);
  if (change) change(values);
  return run_filter(filter, {mesh, "mesh", values, workbench, {}});
}

TriangleSurface small_torus() {
  return fixtures::torus(36, 14, 2.0, 0.7);
}

TriangleSurface open_box() {
  TriangleSurface mesh = fixtures::midpoint_subdivided(fixtures::box(3, 1, 1));
  mesh.triangles.pop_back();
  return mesh;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  EXPECT_TRUE(stream) << path;
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

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

/// A folder that lives as long as a test.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(fs::temp_directory_path() /
              ("mgf_filters_test_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    fs::remove_all(path_);
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// --- What scripts depend on ---

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

// --- Parameters ---

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

// --- Failures ---

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

// --- Results ---

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

// --- What is kept ---

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

// --- Files ---

TEST(ExportFiles, LeavesAllFilesAndNoLayer) {
  const TemporaryFolder folder;
  Workbench workbench;
  const FilterOutcome outcome =
      run("Export Curve Skeleton Files", small_torus(), workbench, [&](ParameterValues& values) {
        values.set("outputFolder", (folder.path() / "torus").string());
      });
  ASSERT_FALSE(outcome.failure) << outcome.failure->message;
  EXPECT_TRUE(outcome.output.layers.empty());
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path() / "torus")) {
    names.insert(entry.path().filename().string());
  }
  EXPECT_EQ(names, (std::set<std::string>{"branches.csv", "circles.ply", "medial_axis.ply",
                                          "parts.ply", "report.json", "segmentation.ply",
                                          "skeleton.graphml", "skeleton.ply", "skeleton.swc",
                                          "skeleton.vtp", "skeleton_smooth.ply", "tubes.ply"}));
}

TEST(ExportFiles, OfARefusedMeshLeavesTheReasonAlone) {
  const TemporaryFolder folder;
  Workbench workbench;
  const auto to_folder = [&](ParameterValues& values) {
    values.set("outputFolder", folder.path().string());
  };
  run("Export Curve Skeleton Files", small_torus(), workbench, to_folder);
  const FilterOutcome outcome =
      run("Export Curve Skeleton Files", open_box(), workbench, to_folder);
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code, "boundary_loops");
  const std::string report = text_of(folder.path() / "report.json");
  EXPECT_NE(report.find("\"failed\""), std::string::npos);
  EXPECT_NE(report.find("\"boundary_loops\""), std::string::npos);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(ExportFiles, LeavesANumberThatIsNoneToTheDiagnosis) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path());
  TriangleSurface broken = small_torus();
  broken.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  std::ofstream file(folder.path() / "precise.off");
  file.precision(17);
  file << "OFF\n" << broken.points.size() << ' ' << broken.triangles.size() << " 0\n";
  for (const Vec3& p : broken.points) file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const Triangle& t : broken.triangles) {
    file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
  file.close();
  Workbench workbench;
  const FilterOutcome outcome =
      run("Export Curve Skeleton Files", broken, workbench, [&](ParameterValues& values) {
        values.set("outputFolder", (folder.path() / "out").string());
        values.set("coordinatesFile", (folder.path() / "precise.off").string());
      });
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code, "non_finite");
}

TEST(ExportFiles, TakesTheDigitsOfTheCoordinatesFile) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path());
  TriangleSurface rounded = small_torus();
  std::ofstream file(folder.path() / "precise.off");
  file.precision(17);
  file << "OFF\n" << rounded.points.size() << ' ' << rounded.triangles.size() << " 0\n";
  for (Vec3& p : rounded.points) {
    file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    p = p.cast<float>().cast<double>();
  }
  for (const Triangle& t : rounded.triangles) {
    file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  }
  file.close();

  Workbench workbench;
  const auto given = [&](ParameterValues& values) {
    values.set("outputFolder", (folder.path() / "out").string());
    values.set("coordinatesFile", (folder.path() / "precise.off").string());
  };
  ASSERT_FALSE(run("Export Curve Skeleton Files", rounded, workbench, given).failure);
  const Progress no_time_to_compute([](double, const char*) { return false; });
  EXPECT_NO_THROW(workbench.latest_study(small_torus(), no_time_to_compute));

  rounded.points[3].x() += 1e-3;
  const FilterOutcome outcome = run("Export Curve Skeleton Files", rounded, workbench, given);
  ASSERT_TRUE(outcome.failure);
  EXPECT_EQ(outcome.failure->code, "coordinates_file");
}

}  // namespace
}  // namespace mgf::plugin
