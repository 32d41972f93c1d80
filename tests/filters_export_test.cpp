// SPDX-License-Identifier: GPL-3.0-or-later
// The files that the exporter leaves.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <string>

#include "filter_mgf_skeleton/filter.h"
#include "filter_mgf_skeleton/workbench.h"
#include "tests/filter_runs.h"

namespace mgf::plugin::test {
namespace {

namespace fs = std::filesystem;

/// A folder that lives as long as a test.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(fs::temp_directory_path() /
              ("mgf_filters_export_test_" +
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

TEST(ExportFiles, WritesVerticesThatNoFaceUsesAsNumbers) {
  const TemporaryFolder folder;
  Workbench workbench;
  TriangleSurface stray = small_torus();
  stray.points.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  const FilterOutcome outcome =
      run("Export Curve Skeleton Files", stray, workbench,
          [&](ParameterValues& values) { values.set("outputFolder", folder.path().string()); });
  ASSERT_FALSE(outcome.failure) << outcome.failure->message;
  const std::string header = text_of(folder.path() / "segmentation.ply").substr(0, 1000);
  EXPECT_NE(header.find("element vertex " + std::to_string(stray.points.size())),
            std::string::npos);
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
}  // namespace mgf::plugin::test
