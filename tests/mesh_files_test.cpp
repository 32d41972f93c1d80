// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of mesh files: each format, each way to be wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <ostream>

#include "filter_mgf_skeleton/tools/file_mesh.h"

namespace mgf::files {
namespace {

using Reader = FileMesh (*)(const std::string&);

std::string error_of(Reader read, const std::string& bytes) {
  try {
    read(bytes);
  } catch (const ParseError& error) {
    return error.what();
  }
  return "";
}

template <class Number>
std::string raw(Number value, bool swapped = false) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Number));
  return swapped ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// Area of the triangles seen along z, negative where they face down.
double area_from_above(const FileMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const Point& a = mesh.points[triangle[0]];
    const Point& b = mesh.points[triangle[1]];
    const Point& c = mesh.points[triangle[2]];
    sum += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
  }
  return sum;
}

TEST(MeshFiles, OffKeepsOrderAndEveryDigit) {
  const FileMesh mesh = read_off(
      "OFF # made by hand\n4 2 0\n0.1 0 0\n1 0 0\n0 1 0\n# a comment\n0 0 1.0000000000000002\n"
      "3 0 1 2 0.5 0.5 0.5\n3 3 2 1\n");
  ASSERT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.points[0][0], 0.1);
  EXPECT_EQ(mesh.points[3][2], 1.0000000000000002);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 2, 1}}));
}

TEST(MeshFiles, OffTakesColoursCountsBesideTheHeaderAndNoHeader) {
  const char* const body = "0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n3 0 1 2\n";
  EXPECT_EQ(read_off(std::string("COFF 3 1 0\n") + body).triangles.size(), 1U);
  EXPECT_EQ(read_off(std::string("3 1 0\n") + body).triangles.size(), 1U);
}

TEST(MeshFiles, ObjTakesEachWayToNameACornerAndFacesBeforeVertices) {
  const FileMesh mesh = read_obj(
      "f 1 2/7 3//8\nv 0 0 0\nv 1 0 0\nvt 0 0\nvn 0 0 1\r\nv 0 1 0\nv 1 1 0\nf 2/1/1 \\\n4/1/1 "
      "-2\n");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(MeshFiles, PlyIsTheSameAsTextAndInBothByteOrders) {
  const std::string elements =
      "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n"
      "element face 1\nproperty float quality\nproperty list uchar uint vertex_index\nend_header\n";
  const FileMesh text = read_ply("ply\nformat ascii 1.0\ncomment a\n" + elements +
                                 "0 0 0 9\n0.1 0 0 9\n0 1 0 9\n0 1\n0.5 3 2 0 1\n");
  for (const bool big : {false, true}) {
    const auto bytes = [big](auto value) { return raw(value, big); };
    std::string data = big ? "ply\nformat binary_big_endian 1.0\n" + elements
                           : "ply\nformat binary_little_endian 1.0\n" + elements;
    for (const Point& point : text.points) {
      for (const double coordinate : point) data += bytes(coordinate);
      data += bytes(std::uint8_t{9});
    }
    data += bytes(0) + bytes(1) + bytes(0.5F) + bytes(std::uint8_t{3});
    data += bytes(2U) + bytes(0U) + bytes(1U);
    const FileMesh binary = read_ply(data);
    EXPECT_EQ(binary.points, text.points);
    EXPECT_EQ(binary.triangles, (std::vector<Triangle>{{2, 0, 1}}));
  }
}

TEST(MeshFiles, StlMergesEqualPointsAsTextAndBinary) {
  const std::vector<Point> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                      {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::string text = "solid two\n";
  std::string binary(80, ' ');
  binary.replace(0, 5, "solid");
  binary += raw(std::uint32_t{2});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) text += "facet normal 0 0 1\n outer loop\n";
    if (i % 3 == 0) binary += raw(0.0F) + raw(0.0F) + raw(1.0F);
    text += "  vertex";
    for (const double coordinate : corners[i]) {
      text += " " + std::to_string(coordinate);
      binary += raw(static_cast<float>(coordinate));
    }
    text += "\n";
    if (i % 3 == 2) text += " endloop\nendfacet\n";
    if (i % 3 == 2) binary += raw(std::uint16_t{0});
  }
  for (const FileMesh& mesh : {read_stl(text + "endsolid two\n"), read_stl(binary)}) {
    EXPECT_EQ(mesh.points.size(), 4U);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
  }
}

TEST(MeshFiles, PolygonThatIsNotConvexKeepsItsShape) {
  const std::string arrow = "OFF\n4 1 0\n0 0 0\n2 -1 0\n0 3 0\n-2 -1 0\n4 0 1 2 3\n";
  const FileMesh mesh = read_off(arrow);
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_DOUBLE_EQ(area_from_above(mesh), 6.0);
  // The dent is at vertex 0: the cut must start there, or a triangle would face down.
  for (const Triangle& triangle : mesh.triangles)
    EXPECT_GT(area_from_above({mesh.points, {triangle}}), 0.0);
}

TEST(MeshFiles, PolygonOfManyCornersBecomesTwoTrianglesLess) {
  FileMesh star;
  std::vector<std::int64_t> corners;
  for (int i = 0; i < 24; ++i) {
    const double radius = i % 2 == 0 ? 2.0 : 1.0;
    const double angle = i * std::acos(-1.0) / 12.0;
    star.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 5.0});
    corners.push_back(i);
  }
  append_polygon(star, corners);
  ASSERT_EQ(star.triangles.size(), 22U);
  EXPECT_NEAR(area_from_above(star), 24 * std::sin(std::acos(-1.0) / 12.0), 1e-12);
}

TEST(MeshFiles, NumbersBeyondDoubleAreReadAsWhatTheyAre) {
  const FileMesh mesh = read_off("OFF\n1 0 0\n1e999 nan 1e-999\n");
  EXPECT_TRUE(std::isinf(mesh.points[0][0]));
  EXPECT_TRUE(std::isnan(mesh.points[0][1]));
  EXPECT_EQ(mesh.points[0][2], 0.0);
}

struct BadFile {
  const char* name;
  Reader read;
  std::string bytes;
  std::string error;  ///< part of the message

  /// So that the test is listed by its name, not by the bytes of this.
  friend std::ostream& operator<<(std::ostream& out, const BadFile& file) {
    return out << file.name;
  }
};

class BadMeshFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadMeshFile, SaysWhatIsWrongAndWhere) {
  const std::string message = error_of(GetParam().read, GetParam().bytes);
  EXPECT_NE(message.find(GetParam().error), std::string::npos) << "said: " << message;
}

const std::string kPlyHead =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\n";

INSTANTIATE_TEST_SUITE_P(
    MeshFiles, BadMeshFile,
    testing::Values(
        BadFile{"OffEndsEarly", read_off, "OFF\n2 0 0\n0 0 0\n", "line 4: the file ends"},
        BadFile{"OffHasALetter", read_off, "OFF\n1 0 0\n0 x 0\n", "line 3: 'x' stands"},
        BadFile{"OffHasNoText", read_off, std::string("\0\1\2", 3), "something that is no text"},
        BadFile{"OffIsBinary", read_off, "OFF BINARY\n", "binary OFF"},
        BadFile{"OffNamesNoVertex", read_off, "OFF\n1 1 0\n0 0 0\n3 0 0 7\n",
                "line 4: a face names vertex 7"},
        BadFile{"OffHasAnEdgeAsFace", read_off, "OFF\n1 1 0\n0 0 0\n2 0 0\n", "fewer than three"},
        BadFile{"OffCountsBelowZero", read_off, "OFF\n-1 0 0\n", "negative"},
        BadFile{"ObjCountsFromZero", read_obj, "v 0 0 0\nf 0 1 1\n",
                "line 2: a face names vertex 0"},
        BadFile{"ObjNamesNoVertex", read_obj, "v 0 0 0\n\nf 1 1 2\n",
                "line 3: a face names vertex 1"},
        BadFile{"ObjHasAFlatVertex", read_obj, "v 0 0\n", "line 1: a vertex has fewer"},
        BadFile{"PlyIsSomethingElse", read_ply, "OFF\n", "'ply' should stand here"},
        BadFile{"PlyHasAnUnknownType", read_ply,
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n",
                "'real' is no number type"},
        BadFile{"PlyHasNoHeight", read_ply,
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
                "no x, y and z"},
        BadFile{"PlyEndsEarly", read_ply,
                "ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float "
                "x\nproperty float y\nproperty float z\nend_header\nabc",
                "the file ends at byte 3"},
        BadFile{"PlyNamesHalfAVertex", read_ply,
                kPlyHead + "element face 1\nproperty list uchar float "
                           "vertex_indices\nend_header\n0 0 0\n3 0 0 0.5\n",
                "no whole number"},
        BadFile{"PlyHasStrips", read_ply,
                kPlyHead + "element tristrips 1\nproperty list int int "
                           "vertex_indices\nend_header\n0 0 0\n1 0\n",
                "triangle strips"},
        BadFile{"StlEndsEarly", read_stl, "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
                "'vertex' should stand"},
        BadFile{"StlBinaryEndsEarly", read_stl, std::string(80, 'x') + raw(std::uint32_t{3}),
                "in the middle of its data"}),
    [](const auto& bad) { return std::string(bad.param.name); });

}  // namespace
}  // namespace mgf::files
