// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "files_samples.h"
#include "filter_mgf_skeleton/io/peak_memory.h"
#include "filter_mgf_skeleton/io/report_json.h"
#include "vcg_ext/skeleton/branches.h"

namespace mgf::io {
namespace {

using nlohmann::json;
using test::bytes_of;
using test::TemporaryFolder;

Report full_report() {
  Report report;
  report.status = ReportStatus::kWarning;
  report.input = {"hand \"left\".off", 4780, 9556, 1, 0};
  report.crossings = {417, 3, 459, 0.25};
  report.medial_axis = {12, 100, 200, 101, {1, 0, 0}};
  report.certificate = TopologyCertificate{};
  report.certificate->topology = TopologyVerdict::kProven;
  report.mgf = {101, 99};
  report.skeleton = {-0.7, 0.75, 7, 6, 2, 1, 1, 1, 0, 0};
  report.branches = build_branches(test::ring_with_tail());
  report.segmentation = {1.3, 0.75, 0};
  report.stages = {{"topology", 0.5}, {"skeleton", 0.25}, {"topology", 0.125}};
  report.total_seconds = 1.0;
  report.threads = 2;
  report.peak_memory_mb = 33.5;
  report.warnings = {{"topology_counted", "Counted, not proven."}};
  return report;
}

json written(const Report& report) {
  const TemporaryFolder folder;
  write_report_json(folder / "report.json", report);
  return json::parse(bytes_of(folder / "report.json"));
}

TEST(ReportJson, HasTheFrozenMembers) {
  const json report = written(full_report());
  const auto has = [&](const char* section, const std::vector<std::string>& members) {
    for (const std::string& member : members) {
      EXPECT_TRUE(report.at(section).contains(member)) << section << "." << member;
    }
  };
  has("input", {"vertices", "faces", "components", "genus"});
  has("crossings", {"pairs_mended", "pairs_left", "vertices_moved", "largest_move"});
  has("medial_axis", {"samples_added", "vertices", "edges", "facets", "b0", "b1", "b2"});
  has("mgf", {"facets", "certified"});
  has("skeleton", {"nodes", "edges", "b0", "b1", "leaves", "junctions", "residual_facets"});
  has("segmentation", {"tubular_area_share", "unlabelled_faces"});
  has("seconds", {"total"});
  EXPECT_EQ(report.at("certificate").at("topology"), "proven");
  EXPECT_EQ(report.at("skeleton").at("outside_edges"), 0);
  EXPECT_EQ(report.at("theta"), -0.7);
  EXPECT_EQ(report.at("threads"), 2);
  EXPECT_EQ(report.at("peak_memory_mb"), 33.5);
  EXPECT_EQ(report.at("status"), "warning");
  EXPECT_EQ(report.at("warnings").at(0).at("code"), "topology_counted");
  EXPECT_EQ(report.at("input").at("file"), "hand \"left\".off");
}

TEST(ReportJson, AddsUpTheTimesOfAStage) {
  const json seconds = written(full_report()).at("seconds");
  EXPECT_EQ(seconds.at("topology"), 0.625);
  EXPECT_EQ(seconds.at("skeleton"), 0.25);
  EXPECT_EQ(seconds.at("total"), 1.0);
}

TEST(ReportJson, ListsTheBranches) {
  const json branches = written(full_report()).at("branches");
  ASSERT_EQ(branches.size(), 2U);
  EXPECT_EQ(branches[0].at("on_cycle"), true);
  EXPECT_TRUE(branches[0].at("parent").is_null());
  EXPECT_EQ(branches[1].at("edges"), 2);
  EXPECT_TRUE(branches[1].at("cycle").is_null());
}

TEST(ReportJson, OfAFailureHasItsReasonAndNoResults) {
  Report report;
  report.status = ReportStatus::kFailed;
  report.error = Warning{"open_boundary", "The mesh has 3 holes."};
  const json written_report = written(report);
  EXPECT_EQ(written_report.at("status"), "failed");
  EXPECT_EQ(written_report.at("error").at("code"), "open_boundary");
  EXPECT_FALSE(written_report.contains("skeleton"));
  EXPECT_TRUE(written_report.at("warnings").is_array());
  EXPECT_EQ(written_report.at("seconds").at("total"), 0.0);
}

TEST(ReportJson, RefusesNumbersThatJsonHasNot) {
  const TemporaryFolder folder;
  Report report = full_report();
  report.segmentation->tubular_area_share = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_report_json(folder / "r.json", report), FileError);
  report = full_report();
  report.branches->branches[1].length = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write_report_json(folder / "r.json", report), FileError);
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(ReportJson, SurvivesANameInAnotherEncoding) {
  Report report = full_report();
  report.input.file = "h\xE4nd.off";
  EXPECT_EQ(written(report).at("input").at("file"), "h\xEF\xBF\xBDnd.off");
}

TEST(PeakMemory, GrowsWithWhatIsUsed) {
  const double before = peak_memory_mb();
  constexpr std::size_t kMegabytes = 64;
  const std::vector<char> block((static_cast<std::size_t>(before) + kMegabytes) << 20, 'x');
  EXPECT_EQ(block.back(), 'x');
  EXPECT_GT(peak_memory_mb(), before + kMegabytes / 2.0);
}

}  // namespace
}  // namespace mgf::io
