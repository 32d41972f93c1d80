// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input has its own code.
#include "vcg_ext/input/diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "tests/fixtures.h"
#include "tests/working_copy_checks.h"

namespace mgf {
namespace {

using fixtures::box;
using fixtures::joined;
using fixtures::moved;
using fixtures::reversed;
using fixtures::scaled;
using fixtures::sphere;
using fixtures::tetrahedron;
using test::count_of;
using test::expect_consistent_maps;
using test::same;

/// The code that `prepare` refuses a mesh with; empty if it doesn't.
std::string refusal(const TriangleSurface& surface) {
  try {
    prepare(surface, diagnose(surface));
  } catch (const InputError& error) {
    EXPECT_FALSE(std::string(error.what()).empty());
    return error.code();
  }
  return {};
}

TEST(Diagnosis, FindsNothingInASoundMesh) {
  for (const TriangleSurface& surface :
       {tetrahedron(), sphere(3), box(3, 2, 1), fixtures::torus(24, 12, 2, 0.5)}) {
    const Diagnosis diagnosis = diagnose(surface);
    EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
    const std::size_t coarse = diagnosis.find("too_coarse") == nullptr ? 0 : 1;
    EXPECT_EQ(diagnosis.findings.size(), coarse) << diagnosis.summary();
    const WorkingCopy copy = prepare(surface, diagnosis);
    EXPECT_TRUE(same(copy.surface, surface));
    EXPECT_EQ(copy.solids, 1U);
    expect_consistent_maps(copy, surface);
  }
}

TEST(Diagnosis, MeasuresGenusAndVolume) {
  const Diagnosis ring = diagnose(fixtures::torus(24, 12, 2, 0.5));
  EXPECT_EQ(ring.genus, 1U);
  const Diagnosis block = diagnose(box(3, 2, 1));
  ASSERT_EQ(block.shells.size(), 1U);
  EXPECT_EQ(block.shells[0].genus, 0);
  EXPECT_EQ(block.shells[0].vertices, 8U);
  EXPECT_EQ(block.shells[0].faces, 12U);
  EXPECT_NEAR(block.shells[0].signed_volume, 6.0, 1e-12);
}

TEST(Diagnosis, RefusesNothingAtAll) {
  EXPECT_EQ(refusal({}), "empty");
}

TEST(Diagnosis, RefusesAPointCloud) {
  TriangleSurface cloud = sphere(1);
  cloud.triangles.clear();
  EXPECT_EQ(refusal(cloud), "no_faces");
}

TEST(Diagnosis, RefusesFacesOfMissingVertices) {
  TriangleSurface surface = sphere(1);
  surface.triangles[5][1] = 1000;
  surface.triangles[7][2] = kNone;
  EXPECT_EQ(refusal(surface), "index_out_of_range");
  EXPECT_EQ(diagnose(surface).find("index_out_of_range")->faces, (std::vector<Index>{5, 7}));
}

TEST(Diagnosis, RefusesCoordinatesThatAreNoNumbers) {
  TriangleSurface surface = sphere(1);
  surface.points[3].y() = std::numeric_limits<double>::quiet_NaN();
  surface.points[9].x() = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(surface), "non_finite");
  EXPECT_EQ(diagnose(surface).find("non_finite")->vertices, (std::vector<Index>{3, 9}));
}

TEST(Diagnosis, RefusesSheetsThatTouchInAPoint) {
  const TriangleSurface corner_to_corner = joined(box(1, 1, 1), moved(box(1, 1, 1), Vec3(1, 1, 1)));
  EXPECT_EQ(refusal(corner_to_corner), "non_manifold_vertices");
  EXPECT_EQ(count_of(diagnose(corner_to_corner), "non_manifold_vertices"), 1U);

  TriangleSurface by_number = joined(tetrahedron(), reversed(scaled(tetrahedron(), -1.0)));
  for (Triangle& t : by_number.triangles) {
    for (Index& v : t) v = v == 4 ? 0 : v;
  }
  EXPECT_EQ(refusal(by_number), "non_manifold_vertices");
  EXPECT_EQ(diagnose(by_number).find("non_manifold_vertices")->vertices, (std::vector<Index>{0}));
}

TEST(Diagnosis, RefusesEdgesOfMoreThanTwoFaces) {
  EXPECT_EQ(refusal(joined(box(1, 1, 1), moved(box(1, 1, 1), Vec3(1, 1, 0)))),
            "non_manifold_edges");
  TriangleSurface fin = box(1, 1, 1);
  fin.points.emplace_back(-1, -1, 0.5);
  fin.triangles.push_back({0, 4, 8});
  EXPECT_EQ(refusal(fin), "non_manifold_edges");
  EXPECT_EQ(count_of(diagnose(fin), "non_manifold_edges"), 1U);
  EXPECT_NE(diagnose(fin).find("boundary_loops"), nullptr);
}

TEST(Diagnosis, CountsHoles) {
  TriangleSurface surface = sphere(3);
  surface.triangles.erase(surface.triangles.begin() + 100);
  surface.triangles.erase(surface.triangles.begin());
  EXPECT_EQ(refusal(surface), "boundary_loops");
  EXPECT_EQ(count_of(diagnose(surface), "boundary_loops"), 2U);
  EXPECT_EQ(diagnose(surface).find("boundary_loops")->vertices.size(), 6U);
}

TEST(Diagnosis, RefusesASingleTriangle) {
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), "boundary_loops");
}

TEST(Diagnosis, RefusesTwoTrianglesBackToBack) {
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}}), "flat");
}

TEST(Diagnosis, RefusesACollapsedTriangle) {
  EXPECT_EQ(refusal({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}}), "no_faces");
  EXPECT_EQ(refusal({{{0, 0, 0}}, {{0, 0, 0}}}), "no_faces");
}

TEST(Diagnosis, RefusesALineOfFaces) {
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {2, 1, 0}}}),
            "degenerate_faces");
}

TEST(Diagnosis, RefusesATetrahedronInAPlane) {
  TriangleSurface flat = tetrahedron();
  flat.points[3] = Vec3(0.25, 0.25, 0.0);
  EXPECT_EQ(refusal(flat), "flat");
  EXPECT_GT(count_of(diagnose(flat), "self_intersections"), 0U);
}

TEST(Diagnosis, ServesAThinPlate) {
  EXPECT_EQ(refusal(box(1, 1, 1e-6)), "");
}

TEST(Diagnosis, NamesTheFacesThatLookTheOtherWay) {
  TriangleSurface surface = sphere(2);
  for (const std::size_t f : {3U, 4U, 60U})
    std::swap(surface.triangles[f][0], surface.triangles[f][1]);
  EXPECT_EQ(refusal(surface), "inconsistent_orientation");
  EXPECT_EQ(diagnose(surface).find("inconsistent_orientation")->faces,
            (std::vector<Index>{3, 4, 60}));
}

TEST(Diagnosis, RefusesAOneSidedSurface) {
  // A torus grid closed with a flip is a Klein bottle.
  constexpr Index kSize = 8;
  TriangleSurface bottle = fixtures::torus(kSize, kSize, 2, 0.5);
  const auto vertex = [](Index i, Index j) {
    return i < kSize ? i * kSize + j % kSize : (kSize - j % kSize) % kSize;
  };
  bottle.triangles.clear();
  for (Index i = 0; i < kSize; ++i) {
    for (Index j = 0; j < kSize; ++j) {
      bottle.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      bottle.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  EXPECT_EQ(refusal(bottle), "inconsistent_orientation");
}

TEST(Diagnosis, RefusesACavityAndNamesBothPieces) {
  const TriangleSurface hollow = joined(reversed(sphere(1)), sphere(2, 2.0));
  EXPECT_EQ(refusal(hollow), "cavities");
  const Diagnosis diagnosis = diagnose(hollow);
  ASSERT_EQ(diagnosis.shells.size(), 2U);
  EXPECT_EQ(diagnosis.shells[0].inside_shell, 1U);
  EXPECT_EQ(diagnosis.shells[1].inside_shell, kNone);
  EXPECT_NE(diagnosis.find("cavities")->meaning.find("piece 0 (32 faces) inside piece 1"),
            std::string::npos);
  EXPECT_EQ(diagnosis.find("cavities")->faces.size(), 32U);
}

TEST(Diagnosis, DoesNotTakeAnOverlapForACavity) {
  const TriangleSurface overlapping = joined(box(2, 2, 2), moved(box(2, 2, 2), Vec3(1, 1.1, 1.2)));
  const Diagnosis diagnosis = diagnose(overlapping);
  EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
  EXPECT_GT(count_of(diagnosis, "self_intersections"), 0U);
  EXPECT_EQ(count_of(diagnosis, "several_shells"), 2U);
}

TEST(Diagnosis, CountsPairsOfIntersectingFaces) {
  TriangleSurface surface = sphere(3);
  surface.points[0] = Vec3(-1.5, 0, 0);  // one vertex pulled through the other side
  const Diagnosis diagnosis = diagnose(surface);
  ASSERT_TRUE(diagnosis.servable);
  EXPECT_GT(count_of(diagnosis, "self_intersections"), 3U);
  EXPECT_FALSE(diagnosis.find("self_intersections")->faces.empty());
}

TEST(Diagnosis, TellsOfExtremeCoordinates) {
  EXPECT_EQ(refusal(scaled(sphere(1), 1e-6)), "");
  EXPECT_EQ(count_of(diagnose(scaled(sphere(1), 1e-6)), "huge_or_tiny_coordinates"), 0U);
  EXPECT_EQ(count_of(diagnose(scaled(sphere(1), 1e6)), "huge_or_tiny_coordinates"), 0U);
  for (const double factor : {1e30, 1e-30}) {
    EXPECT_EQ(refusal(scaled(sphere(1), factor)), "");
    EXPECT_EQ(count_of(diagnose(scaled(sphere(1), factor)), "huge_or_tiny_coordinates"), 1U);
  }
  for (const double factor : {1e200, 1e308, 1e-200, 5e-324}) {
    EXPECT_EQ(refusal(scaled(sphere(1), factor)), "huge_or_tiny_coordinates") << factor;
  }
}

TEST(Diagnosis, TellsOfTooFewVertices) {
  for (const TriangleSurface& surface : {box(3, 2, 1), reversed(box(3, 2, 1))}) {
    const Diagnosis diagnosis = diagnose(surface);
    EXPECT_TRUE(diagnosis.servable);
    EXPECT_GT(count_of(diagnosis, "too_coarse"), 0U);
  }
  EXPECT_EQ(count_of(diagnose(sphere(2)), "too_coarse"), 0U);
}

TEST(Diagnosis, TellsOfADistantOrigin) {
  EXPECT_EQ(count_of(diagnose(moved(sphere(2), Vec3(100, 0, 0))), "far_from_origin"), 0U);
  EXPECT_EQ(count_of(diagnose(moved(sphere(2), Vec3(1e7, 0, 0))), "far_from_origin"), 1U);
}

TEST(Diagnosis, GivesTheSameFindingsAtAnyScale) {
  const TriangleSurface surface = joined(fixtures::soup(sphere(1)), sphere(2, 2.0));
  const std::string words = diagnose(surface).summary();
  for (const double factor : {1.0 / 1048576.0, 1048576.0}) {
    EXPECT_EQ(diagnose(scaled(surface, factor)).summary(), words);
  }
}

TEST(Diagnosis, SaysAllThatIsWrongInTheError) {
  TriangleSurface surface = sphere(2);
  surface.triangles.pop_back();
  std::swap(surface.triangles[0][0], surface.triangles[0][1]);
  try {
    require_servable(diagnose(surface));
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), "boundary_loops");
    const std::string words = error.what();
    EXPECT_NE(words.find("1 hole"), std::string::npos) << words;
    EXPECT_NE(words.find("'Close Holes'"), std::string::npos) << words;
    EXPECT_NE(words.find("inconsistent_orientation"), std::string::npos) << words;
  }
}

TEST(Diagnosis, HasAPlaceInTheDocumentationForEveryFinding) {
  const auto path = std::filesystem::path(__FILE__).parent_path() / ".." / "docs" / "input.md";
  std::ifstream file(path);
  std::ostringstream stream;
  stream << file.rdbuf();
  const std::string page = stream.str();
  ASSERT_FALSE(page.empty());
  for (const FindingText& text : kFindingTexts) {
    EXPECT_NE(page.find("`" + std::string(text.code) + "`"), std::string::npos) << text.code;
  }
}

}  // namespace
}  // namespace mgf
