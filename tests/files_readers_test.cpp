// SPDX-License-Identifier: GPL-3.0-or-later
// Every file opened by software that isn't ours: readers/check_skeleton.py does the looking.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "files_samples.h"
#include "filter_mgf_skeleton/io/branches_csv.h"
#include "filter_mgf_skeleton/io/circles_file.h"
#include "filter_mgf_skeleton/io/graphml_file.h"
#include "filter_mgf_skeleton/io/medial_axis_file.h"
#include "filter_mgf_skeleton/io/report_json.h"
#include "filter_mgf_skeleton/io/skeleton_file.h"
#include "filter_mgf_skeleton/io/surface_files.h"
#include "filter_mgf_skeleton/io/swc_file.h"
#include "filter_mgf_skeleton/io/tubes_file.h"
#include "filter_mgf_skeleton/io/vtp_file.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/smoothing.h"

namespace mgf::io {
namespace {

// Debian's Python: the one that its modules are installed for.
constexpr const char* kPython = "/usr/bin/python3";

bool readers_are_installed() {
  const std::string command =
      std::string(kPython) + " -c 'import meshio, networkx, numpy, vtk' 2>/dev/null";
  return std::system(command.c_str()) == 0;  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
}

int status_of_readers(const std::filesystem::path& folder) {
  const std::filesystem::path script =
      std::filesystem::path(__FILE__).parent_path() / "readers" / "check_skeleton.py";
  const std::string command =
      std::string(kPython) + " '" + script.string() + "' '" + folder.string() + "'";
  return std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
}

Report report_of(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  Report report;
  report.input = {"tetrahedron.ply", 4, 4, 1, 0};
  report.medial_axis = {0, 5, 6, 2, {1, 0, 0}};
  report.mgf = {2, 2};
  SkeletonReport part;
  part.nodes = to_index(skeleton.node_count());
  part.edges = to_index(skeleton.edge_count());
  part.b0 = graph.components;
  part.b1 = graph.cycles;
  for (const NodeKind kind : graph.node_kind) {
    if (kind == NodeKind::kTip) ++part.leaves;
    if (kind == NodeKind::kJunction) ++part.junctions;
  }
  report.skeleton = part;
  report.branches = graph;
  report.segmentation = {1.3, 0.5, 0};
  return report;
}

void write_all(const std::filesystem::path& folder, const CurveSkeleton& skeleton) {
  const BranchGraph graph = build_branches(skeleton);
  const SmoothSkeleton smooth = smooth_skeleton(skeleton, graph, test::everywhere());
  write_medial_axis(folder / "medial_axis.ply", test::two_facets(), {3.0, 0.1},
                    {{1, 0, 0}, {0, 0, -1}}, same_numbers(6));
  write_skeleton(folder / "skeleton.ply", skeleton, graph);
  write_skeleton_smooth(folder / "skeleton_smooth.ply", smooth, graph);
  write_swc(folder / "skeleton.swc", skeleton, graph);
  write_graphml(folder / "skeleton.graphml", skeleton, graph);
  write_vtp(folder / "skeleton.vtp", skeleton, graph);
  write_branches_csv(folder / "branches.csv", graph);
  write_circles(folder / "circles.ply", test::three_circles());
  write_segmentation(folder / "segmentation.ply", test::tetrahedron_surface(),
                     test::tetrahedron_segmentation());
  SkeletonCorrespondence parts = test::tetrahedron_parts();
  for (Index& branch : parts.branch) {
    if (branch != kNone && branch >= graph.branches.size()) branch = kNone;
  }
  write_parts(folder / "parts.ply", test::tetrahedron_surface(), parts, graph);
  const TubeMesh tubes = make_tubes(tube_paths(skeleton, graph, skeleton.eccentricity, 0.0),
                                    default_tube_radius(skeleton));
  write_tubes(folder / "tubes.ply", tubes, quantile_scale(skeleton.eccentricity, 0.05));
  write_report_json(folder / "report.json", report_of(skeleton, graph));
}

class Readers : public testing::Test {
 protected:
  void SetUp() override {
    if (!readers_are_installed()) {
      GTEST_SKIP() << "needs python3-meshio, python3-networkx and python3-vtk9";
    }
  }
};

TEST_F(Readers, OpenEveryFile) {
  const test::TemporaryFolder folder;
  write_all(folder.path(), test::renumbered(test::ring_with_tail(), 3));
  EXPECT_EQ(status_of_readers(folder.path()), 0);
}

TEST_F(Readers, OpenEveryFileOfASkeletonOfOneNode) {
  const test::TemporaryFolder folder;
  write_all(folder.path(), test::single_node_skeleton());
  EXPECT_EQ(status_of_readers(folder.path()), 0);
}

TEST_F(Readers, OpenTheFilesOfTwoNodesJoinedTwice) {
  const test::TemporaryFolder folder;
  write_all(folder.path(), test::tube_skeleton({{0, 0, 0}, {1, 0, 0}}, {{0, 1}, {1, 0}}, 0.5));
  EXPECT_EQ(status_of_readers(folder.path()), 0);
}

// A check that can't fail would prove nothing.
TEST_F(Readers, NoticeADifference) {
  const test::TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  write_all(folder.path(), skeleton);
  write_swc(folder / "skeleton.swc", test::single_node_skeleton(),
            build_branches(test::single_node_skeleton()));
  EXPECT_NE(status_of_readers(folder.path()), 0);
}

}  // namespace
}  // namespace mgf::io
