// SPDX-License-Identifier: GPL-3.0-or-later
// Each file's properties and values, read back with vcglib or as text.
#include <gtest/gtest.h>
#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/import_ply.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "files_samples.h"
#include "files_vcg_reader.h"
#include "filter_mgf_skeleton/io/branches_csv.h"
#include "filter_mgf_skeleton/io/circles_file.h"
#include "filter_mgf_skeleton/io/medial_axis_file.h"
#include "filter_mgf_skeleton/io/skeleton_file.h"
#include "filter_mgf_skeleton/io/surface_files.h"
#include "filter_mgf_skeleton/io/swc_file.h"
#include "vcg_ext/skeleton/smoothing.h"

namespace mgf::io {
namespace {

using test::bytes_of;
using test::TemporaryFolder;
using test::VcgPlyElement;
using Names = std::vector<std::string>;

class PlainVertex;
class PlainEdge;
class PlainFace;
struct PlainTypes
    : public vcg::UsedTypes<vcg::Use<PlainVertex>::AsVertexType, vcg::Use<PlainEdge>::AsEdgeType,
                            vcg::Use<PlainFace>::AsFaceType> {};
class PlainVertex : public vcg::Vertex<PlainTypes, vcg::vertex::Coord3d, vcg::vertex::Qualityd,
                                       vcg::vertex::Color4b, vcg::vertex::BitFlags> {};
class PlainEdge : public vcg::Edge<PlainTypes, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class PlainFace : public vcg::Face<PlainTypes, vcg::face::VertexRef, vcg::face::Qualityd,
                                   vcg::face::Color4b, vcg::face::BitFlags> {};
class PlainMesh : public vcg::tri::TriMesh<std::vector<PlainVertex>, std::vector<PlainEdge>,
                                           std::vector<PlainFace>> {};

// As MeshLab opens it.
void import(const std::filesystem::path& path, PlainMesh& mesh) {
  int mask = 0;
  ASSERT_EQ(vcg::tri::io::ImporterPLY<PlainMesh>::Open(mesh, path.c_str(), mask), 0);
}

TEST(MedialAxisFile, HasTheFrozenPropertiesAndTheirValues) {
  const TemporaryFolder folder;
  const MedialComplex complex = test::two_facets();
  const std::vector<double> mgf{3.0, 0.1};
  write_medial_axis(folder / "m.ply", complex, mgf, {{1, 0, 0}, {0, 0, -1}}, same_numbers(6));
  const VcgPlyElement vertex(folder / "m.ply", "vertex");
  const VcgPlyElement face(folder / "m.ply", "face");
  EXPECT_EQ(vertex.properties(), (Names{"x", "y", "z", "radius"}));
  EXPECT_EQ(face.properties(), (Names{"vertex_indices", "contact_a", "contact_b", "mgf",
                                      "gradient_x", "gradient_y", "gradient_z"}));
  EXPECT_EQ(vertex.scalars<double>("radius"), complex.radius);
  EXPECT_EQ(vertex.scalars<double>("z"), (std::vector<double>{0, 0, 0, 0, 1.0 / 3.0}));
  EXPECT_EQ(face.lists("vertex_indices"), (std::vector<std::vector<int>>{{0, 1, 2, 3}, {1, 4, 2}}));
  EXPECT_EQ(face.scalars<int>("contact_a"), (std::vector<int>{0, 2}));
  EXPECT_EQ(face.scalars<int>("contact_b"), (std::vector<int>{3, 5}));
  EXPECT_EQ(face.scalars<double>("mgf"), mgf);
  EXPECT_EQ(face.scalars<double>("gradient_x"), (std::vector<double>{1, 0}));
  EXPECT_EQ(face.scalars<double>("gradient_z"), (std::vector<double>{0, -1}));
}

TEST(MedialAxisFile, NumbersContactsAsTheUserDoes) {
  const TemporaryFolder folder;
  // The user's mesh has 7 vertices; numbers 1 and 3 were left out of the working copy. Vertex 5 of
  // the surface is the first added point.
  const VertexNumbers numbers{{0, 2, 4, 5, 6}, 7};
  write_medial_axis(folder / "m.ply", test::two_facets(), {1, 1}, {{1, 0, 0}, {1, 0, 0}}, numbers);
  const VcgPlyElement face(folder / "m.ply", "face");
  EXPECT_EQ(face.scalars<int>("contact_a"), (std::vector<int>{0, 4}));
  EXPECT_EQ(face.scalars<int>("contact_b"), (std::vector<int>{5, 7}));
}

TEST(MedialAxisFile, OpensInVcglib) {
  const TemporaryFolder folder;
  write_medial_axis(folder / "m.ply", test::two_facets(), {3.0, 0.1}, {{1, 0, 0}, {0, 0, -1}},
                    same_numbers(6));
  PlainMesh mesh;
  import(folder / "m.ply", mesh);
  EXPECT_EQ(mesh.vert.size(), 5U);
  EXPECT_EQ(mesh.face.size(), 3U);  // the square as two triangles
}

TEST(SkeletonFile, HasTheFrozenPropertiesAndTheirValues) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  const BranchGraph graph = build_branches(skeleton);
  write_skeleton(folder / "s.ply", skeleton, graph);
  const VcgPlyElement vertex(folder / "s.ply", "vertex");
  const VcgPlyElement edge(folder / "s.ply", "edge");
  EXPECT_EQ(vertex.properties(),
            (Names{"x", "y", "z", "radius", "mgf", "eccentricity", "branch", "kind"}));
  EXPECT_EQ(edge.properties(), (Names{"vertex1", "vertex2", "mgf", "eccentricity", "girth",
                                      "theta_birth", "branch", "circumference"}));
  EXPECT_EQ(edge.scalars<int>("vertex1"), (std::vector<int>{0, 1, 2, 3, 0, 4}));
  EXPECT_EQ(edge.scalars<int>("vertex2"), (std::vector<int>{1, 2, 3, 0, 4, 5}));
  EXPECT_EQ(edge.scalars<double>("mgf"), skeleton.mgf);
  EXPECT_EQ(edge.scalars<double>("eccentricity"), skeleton.eccentricity);
  EXPECT_EQ(edge.scalars<double>("girth"), skeleton.girth);
  EXPECT_EQ(edge.scalars<double>("theta_birth"), skeleton.theta_birth);
  EXPECT_EQ(edge.scalars<double>("circumference"), skeleton.circumference);
  EXPECT_EQ(edge.scalars<int>("branch"), (std::vector<int>{0, 0, 0, 0, 1, 1}));
  EXPECT_EQ(vertex.scalars<double>("radius"), skeleton.radius);
  EXPECT_EQ(vertex.scalars<int>("branch"), (std::vector<int>{0, 0, 0, 0, 1, 1, -1}));
  // 0 regular, 1 tip, 2 junction, 3 isolated
  EXPECT_EQ(vertex.scalars<unsigned char>("kind"),
            (std::vector<unsigned char>{2, 0, 0, 0, 0, 1, 3}));
}

TEST(SkeletonFile, WritesZeroForAMeasureThatIsUndefined) {
  const TemporaryFolder folder;
  CurveSkeleton skeleton = test::ring_with_tail();
  skeleton.circumference[2] = std::numeric_limits<double>::infinity();
  skeleton.eccentricity[2] = 0.0;
  write_skeleton(folder / "s.ply", skeleton, build_branches(skeleton));
  EXPECT_EQ(VcgPlyElement(folder / "s.ply", "edge").scalars<double>("circumference")[2], 0.0);
}

TEST(SkeletonFile, WritesZeroWhereNoPathJoinsTheContacts) {
  const TemporaryFolder folder;
  CurveSkeleton skeleton = test::ring_with_tail();
  skeleton.mgf[2] = skeleton.girth[2] = std::numeric_limits<double>::infinity();
  skeleton.node_mgf[1] = std::numeric_limits<double>::infinity();
  write_skeleton(folder / "s.ply", skeleton, build_branches(skeleton));
  for (const char* name : {"mgf", "girth"}) {
    EXPECT_EQ(VcgPlyElement(folder / "s.ply", "edge").scalars<double>(name)[2], 0.0) << name;
  }
  EXPECT_EQ(VcgPlyElement(folder / "s.ply", "vertex").scalars<double>("mgf")[1], 0.0);
}

TEST(SkeletonFile, RefusesALengthThatIsNoNumber) {
  const TemporaryFolder folder;
  CurveSkeleton skeleton = test::ring_with_tail();
  const BranchGraph graph = build_branches(skeleton);
  skeleton.girth[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_skeleton(folder / "s.ply", skeleton, graph), FileError);
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(SkeletonFile, OpensInVcglibWithItsEdges) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  write_skeleton(folder / "s.ply", skeleton, build_branches(skeleton));
  PlainMesh mesh;
  import(folder / "s.ply", mesh);
  EXPECT_EQ(mesh.vert.size(), 7U);
  ASSERT_EQ(mesh.edge.size(), 6U);
  EXPECT_EQ(mesh.edge[3].V(0), &mesh.vert[3]);
  EXPECT_EQ(mesh.edge[3].V(1), &mesh.vert[0]);
}

TEST(SkeletonFile, HoldsASkeletonOfOneNode) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::single_node_skeleton();
  write_skeleton(folder / "s.ply", skeleton, build_branches(skeleton));
  EXPECT_EQ(VcgPlyElement(folder / "s.ply", "vertex").scalars<double>("y"),
            (std::vector<double>{2.0}));
  EXPECT_TRUE(VcgPlyElement(folder / "s.ply", "edge").scalars<double>("mgf").empty());
}

TEST(SkeletonFile, IsTheSameBytesEachTime) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  write_skeleton(folder / "1.ply", skeleton, build_branches(skeleton));
  write_skeleton(folder / "2.ply", skeleton, build_branches(skeleton));
  EXPECT_EQ(bytes_of(folder / "1.ply"), bytes_of(folder / "2.ply"));
}

TEST(SmoothSkeletonFile, HasTheBranchesAndKindsOfTheRawOne) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  const BranchGraph graph = build_branches(skeleton);
  const SmoothSkeleton smooth = smooth_skeleton(skeleton, graph, test::everywhere());
  write_skeleton_smooth(folder / "s.ply", smooth, graph);
  const VcgPlyElement vertex(folder / "s.ply", "vertex");
  const VcgPlyElement edge(folder / "s.ply", "edge");
  EXPECT_EQ(vertex.properties(),
            (Names{"x", "y", "z", "radius", "mgf", "eccentricity", "branch", "kind"}));
  const std::vector<int> branches = edge.scalars<int>("branch");
  EXPECT_EQ(std::set<int>(branches.begin(), branches.end()), (std::set<int>{0, 1}));
  const std::vector<unsigned char> kinds = vertex.scalars<unsigned char>("kind");
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), 1), 1);  // tips
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), 2), 1);  // junctions
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), 3), 1);  // isolated
  const std::vector<int> of_nodes = vertex.scalars<int>("branch");
  EXPECT_EQ(std::count(of_nodes.begin(), of_nodes.end(), -1), 1);
}

TEST(SegmentationFile, IsTheMeshWithTubularBlueAndFlatWhite) {
  const TemporaryFolder folder;
  write_segmentation(folder / "s.ply", test::tetrahedron_surface(),
                     test::tetrahedron_segmentation());
  EXPECT_EQ(
      VcgPlyElement(folder / "s.ply", "face").properties(),
      (Names{"vertex_indices", "quality", "red", "green", "blue", "eccentricity", "confidence"}));
  PlainMesh mesh;
  import(folder / "s.ply", mesh);
  ASSERT_EQ(mesh.vert.size(), 4U);
  ASSERT_EQ(mesh.face.size(), 4U);
  EXPECT_EQ(mesh.face[1].V(2), &mesh.vert[3]);
  EXPECT_EQ(mesh.face[0].Q(), 1.0);
  EXPECT_EQ(mesh.face[1].Q(), 0.0);
  EXPECT_EQ(mesh.face[0].C()[2], kTubularColour.blue);
  EXPECT_EQ(mesh.face[1].C()[0], kFlatColour.red);
}

TEST(SegmentationFile, IsGreyWithoutLabels) {
  const TemporaryFolder folder;
  Segmentation segmentation = test::tetrahedron_segmentation();
  segmentation.unlabelled_faces = 4;
  write_segmentation(folder / "s.ply", test::tetrahedron_surface(), segmentation);
  EXPECT_EQ(VcgPlyElement(folder / "s.ply", "face").scalars<unsigned char>("green"),
            (std::vector<unsigned char>(4, kUnlabelledColour.green)));
}

TEST(PartsFile, IsTheMeshWithAColourPerBranch) {
  const TemporaryFolder folder;
  const BranchGraph graph = build_branches(test::ring_with_tail());
  write_parts(folder / "p.ply", test::tetrahedron_surface(), test::tetrahedron_parts(), graph);
  EXPECT_EQ(VcgPlyElement(folder / "p.ply", "face").properties(),
            (Names{"vertex_indices", "quality", "red", "green", "blue", "arc_length", "distance",
                   "girth"}));
  PlainMesh mesh;
  import(folder / "p.ply", mesh);
  ASSERT_EQ(mesh.face.size(), 4U);
  EXPECT_EQ(mesh.face[0].Q(), 0.0);
  EXPECT_EQ(mesh.face[1].Q(), 1.0);
  EXPECT_EQ(mesh.face[3].Q(), -1.0);
  EXPECT_EQ(mesh.face[0].C(), mesh.face[2].C());
  EXPECT_NE(mesh.face[0].C(), mesh.face[1].C());
  EXPECT_NE(mesh.face[0].C(), mesh.face[3].C());
}

TEST(CirclesFile, ClosesEachCircle) {
  const TemporaryFolder folder;
  write_circles(folder / "c.ply", test::three_circles());
  const VcgPlyElement edge(folder / "c.ply", "edge");
  EXPECT_EQ(edge.properties(), (Names{"vertex1", "vertex2", "eccentricity", "circle"}));
  EXPECT_EQ(edge.scalars<int>("vertex1"), (std::vector<int>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(edge.scalars<int>("vertex2"), (std::vector<int>{1, 2, 0, 4, 5, 6, 3}));
  EXPECT_EQ(edge.scalars<double>("eccentricity"),
            (std::vector<double>{1.0, 1.0, 1.0, 1.4, 1.4, 1.4, 1.4}));
  EXPECT_EQ(VcgPlyElement(folder / "c.ply", "vertex").scalars<int>("circle"),
            (std::vector<int>{0, 0, 0, 1, 1, 1, 1, 2}));
}

TEST(SwcFile, CutsEachLoopWhereItIsNarrowest) {
  const CurveSkeleton skeleton = test::ring_with_tail();
  const SkeletonForest forest = skeleton_forest(skeleton, build_branches(skeleton));
  EXPECT_EQ(forest.cut, std::vector<Index>{1});
  EXPECT_EQ(forest.order.size(), skeleton.node_count());
}

TEST(SwcFile, ListsEveryNodeAfterItsParent) {
  const CurveSkeleton skeleton = test::renumbered(test::ring_with_tail(), 5);
  const SkeletonForest forest = skeleton_forest(skeleton, build_branches(skeleton));
  std::vector<bool> listed(skeleton.node_count(), false);
  std::size_t roots = 0;
  for (const Index node : forest.order) {
    if (forest.parent[node] == kNone) {
      ++roots;
    } else {
      EXPECT_TRUE(listed[forest.parent[node]]);
    }
    EXPECT_FALSE(listed[node]);
    listed[node] = true;
  }
  EXPECT_EQ(roots, 2U);
  EXPECT_EQ(std::count(listed.begin(), listed.end(), true), 7);
}

TEST(SwcFile, NamesTheCutsInComments) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  write_swc(folder / "s.swc", skeleton, build_branches(skeleton));
  std::istringstream text(bytes_of(folder / "s.swc"));
  std::string line;
  std::size_t cuts = 0;
  std::size_t nodes = 0;
  while (std::getline(text, line)) {
    if (line.rfind("# cut ", 0) == 0) ++cuts;
    if (line[0] != '#') ++nodes;
  }
  EXPECT_EQ(cuts, 1U);
  EXPECT_EQ(nodes, 7U);
}

TEST(BranchesCsv, HasALinePerBranch) {
  const TemporaryFolder folder;
  const CurveSkeleton skeleton = test::ring_with_tail();
  write_branches_csv(folder / "b.csv", build_branches(skeleton));
  const std::string text = bytes_of(folder / "b.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_EQ(text.rfind("branch,first_node,last_node,parent,component,on_cycle,", 0), 0U);
}

TEST(BranchesCsv, OfOneNodeIsTheHeader) {
  const TemporaryFolder folder;
  write_branches_csv(folder / "b.csv", build_branches(test::single_node_skeleton()));
  const std::string text = bytes_of(folder / "b.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

}  // namespace
}  // namespace mgf::io
