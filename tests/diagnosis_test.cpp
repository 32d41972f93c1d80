// SPDX-License-Identifier: GPL-3.0-or-later
// Every bad input with its own code; what is harmless is mended, and nothing else is touched.
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
#include "vcg_ext/input/working_copy.h"

namespace mgf {
namespace {

using fixtures::box;
using fixtures::joined;
using fixtures::moved;
using fixtures::reversed;
using fixtures::scaled;
using fixtures::sphere;
using fixtures::tetrahedron;

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

std::size_t count_of(const Diagnosis& diagnosis, const std::string& code) {
  const Finding* finding = diagnosis.find(code);
  return finding == nullptr ? 0 : finding->count;
}

bool same(const TriangleSurface& a, const TriangleSurface& b) {
  return a.points == b.points && a.triangles == b.triangles;
}

/// Nothing but the sampling is found.
bool is_sound(const TriangleSurface& s) {
  const Diagnosis diagnosis = diagnose(s);
  return diagnosis.servable &&
         std::all_of(diagnosis.findings.begin(), diagnosis.findings.end(),
                     [](const Finding& finding) { return finding.code == "too_coarse"; });
}

double volume(const TriangleSurface& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles) {
    sum += s.points[t[0]].dot(s.points[t[1]].cross(s.points[t[2]])) / 6.0;
  }
  return sum;
}

/// The maps of a working copy are each other's inverse where something stayed, and its positions
/// are the input's.
void expect_consistent_maps(const WorkingCopy& copy, const TriangleSurface& input) {
  ASSERT_EQ(copy.vertex_of_input.size(), input.points.size());
  ASSERT_EQ(copy.face_of_input.size(), input.triangles.size());
  ASSERT_EQ(copy.input_of_vertex.size(), copy.surface.points.size());
  ASSERT_EQ(copy.input_of_face.size(), copy.surface.triangles.size());
  ASSERT_EQ(copy.shell_of_vertex.size(), copy.surface.points.size());
  for (Index v = 0; v < input.points.size(); ++v) {
    const Index w = copy.vertex_of_input[v];
    if (w != kNone) {
      EXPECT_EQ(copy.surface.points[w], input.points[v]);
    }
  }
  for (Index v = 0; v < copy.surface.points.size(); ++v) {
    EXPECT_EQ(copy.vertex_of_input[copy.input_of_vertex[v]], v);
    EXPECT_LT(copy.shell_of_vertex[v], copy.solids);
  }
  for (Index f = 0; f < input.triangles.size(); ++f) {
    const Index g = copy.face_of_input[f];
    if (g != kNone) {
      EXPECT_EQ(copy.input_of_face[g], f);
    }
  }
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

TEST(Diagnosis, IgnoresWhatBelongsToNoFace) {
  TriangleSurface surface = sphere(1);
  const TriangleSurface sound = surface;
  surface.points.insert(surface.points.begin() + 2,
                        Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  for (Triangle& t : surface.triangles) {
    for (Index& v : t) v += v >= 2 ? 1 : 0;
  }
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(diagnosis.find("unreferenced_vertices")->vertices, (std::vector<Index>{2}));
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(same(copy.surface, sound));
  EXPECT_EQ(copy.vertex_of_input[2], kNone);
  ASSERT_EQ(copy.warnings.size(), 1U);
  EXPECT_EQ(copy.warnings[0].code, "unreferenced_vertices");
}

TEST(Diagnosis, ClosesASoupByMergingEqualPoints) {
  const TriangleSurface soup = fixtures::soup(sphere(2));
  const Diagnosis diagnosis = diagnose(soup);
  EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
  EXPECT_EQ(count_of(diagnosis, "duplicate_vertices"), soup.points.size() - 66U);
  const WorkingCopy copy = prepare(soup, diagnosis);
  EXPECT_EQ(copy.surface.points.size(), 66U);
  EXPECT_EQ(copy.surface.triangles.size(), soup.triangles.size());
  expect_consistent_maps(copy, soup);
}

TEST(Diagnosis, NeverMergesZeroAndItsNegativeApart) {
  TriangleSurface surface = fixtures::soup(box(1, 1, 1));
  for (std::size_t i = 0; i < surface.points.size(); i += 2) {
    for (double& x : surface.points[i]) x = x == 0.0 ? -0.0 : x;
  }
  EXPECT_EQ(prepare(surface, diagnose(surface)).surface.points.size(), 8U);
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

TEST(Diagnosis, TurnsAnInsideOutSurface) {
  const TriangleSurface surface = reversed(sphere(2));
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(count_of(diagnosis, "inside_out"), 1U);
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_NEAR(volume(copy.surface), volume(sphere(2)), 1e-12);
  expect_consistent_maps(copy, surface);
}

TEST(Diagnosis, TurnsOnlyThePieceThatIsInsideOut) {
  const TriangleSurface surface =
      joined(box(1, 1, 1), reversed(moved(box(1, 1, 1), Vec3(5, 0, 0))));
  const WorkingCopy copy = prepare(surface, diagnose(surface));
  EXPECT_NEAR(volume(copy.surface), 2.0, 1e-12);
  EXPECT_EQ(copy.surface.triangles[0], surface.triangles[0]);
}

TEST(Diagnosis, NumbersSeparateSolids) {
  const TriangleSurface surface =
      joined(joined(sphere(1), moved(fixtures::torus(12, 8, 2, 0.5), Vec3(10, 0, 0))),
             moved(box(1, 1, 1), Vec3(0, 10, 0)));
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(count_of(diagnosis, "several_shells"), 3U);
  EXPECT_EQ(diagnosis.genus, 1U);
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(same(copy.surface, surface));
  EXPECT_EQ(copy.solids, 3U);
  EXPECT_EQ(copy.shell_of_vertex.front(), 0U);
  EXPECT_EQ(copy.shell_of_vertex.back(), 2U);
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

TEST(Diagnosis, FillsACavityOnDemand) {
  for (const TriangleSurface& inner : {sphere(1), reversed(sphere(1))}) {
    const TriangleSurface hollow = joined(inner, sphere(2, 2.0));
    const DiagnosisOptions options{true};
    const WorkingCopy copy = prepare(hollow, diagnose(hollow, options), options);
    EXPECT_TRUE(same(copy.surface, sphere(2, 2.0)));
    EXPECT_EQ(copy.solids, 1U);
    EXPECT_EQ(copy.face_of_input[0], kNone);
    expect_consistent_maps(copy, hollow);
  }
}

TEST(Diagnosis, TakesASolidWithinACavityForASolid) {
  const TriangleSurface nested =
      joined(joined(sphere(1), reversed(sphere(1, 2.0))), sphere(1, 3.0));
  const Diagnosis diagnosis = diagnose(nested);
  ASSERT_EQ(diagnosis.shells.size(), 3U);
  EXPECT_EQ(diagnosis.shells[0].inside_shell, kNone);
  EXPECT_EQ(diagnosis.shells[1].inside_shell, 2U);
  EXPECT_EQ(diagnosis.shells[2].inside_shell, kNone);
}

TEST(Diagnosis, DoesNotTakeAnOverlapForACavity) {
  const TriangleSurface overlapping = joined(box(2, 2, 2), moved(box(2, 2, 2), Vec3(1, 1.1, 1.2)));
  const Diagnosis diagnosis = diagnose(overlapping);
  EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
  EXPECT_GT(count_of(diagnosis, "self_intersections"), 0U);
  EXPECT_EQ(count_of(diagnosis, "several_shells"), 2U);
}

TEST(Diagnosis, DropsRepeatedFaces) {
  TriangleSurface surface = sphere(1);
  const Triangle& t = surface.triangles[4];
  surface.triangles.push_back({t[1], t[2], t[0]});
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(diagnosis.find("duplicate_faces")->faces, (std::vector<Index>{32}));
  EXPECT_TRUE(same(prepare(surface, diagnosis).surface, sphere(1)));
}

TEST(Diagnosis, FlipsACapAwayWithoutMovingTheSurface) {
  // A vertex on an edge of a box belongs to one side only: the other has a face without area.
  TriangleSurface surface = box(2, 2, 2);
  const auto at = std::find(surface.triangles.begin(), surface.triangles.end(), Triangle{0, 1, 5});
  ASSERT_NE(at, surface.triangles.end());
  surface.points.emplace_back(1.0, 0.0, 0.0);
  *at = {0, 8, 5};
  surface.triangles.push_back({8, 1, 5});
  surface.triangles.push_back({0, 1, 8});
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_TRUE(diagnosis.servable) << diagnosis.summary();
  EXPECT_EQ(diagnosis.find("degenerate_faces")->faces, (std::vector<Index>{13}));
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(is_sound(copy.surface)) << diagnose(copy.surface).summary();
  EXPECT_NEAR(volume(copy.surface), 8.0, 1e-12);
  EXPECT_EQ(copy.face_of_input[13], kNone);
  expect_consistent_maps(copy, surface);
}

TEST(Diagnosis, FlipsAWholeFanOfCaps) {
  // Three vertices on one edge; the side below reaches them through caps only.
  TriangleSurface surface = box(4, 2, 2);
  const auto at = std::find(surface.triangles.begin(), surface.triangles.end(), Triangle{0, 1, 5});
  ASSERT_NE(at, surface.triangles.end());
  for (const double x : {1.0, 2.0, 3.0}) surface.points.emplace_back(x, 0.0, 0.0);
  *at = {0, 8, 5};
  for (const Triangle& t : {Triangle{8, 9, 5}, Triangle{9, 10, 5}, Triangle{10, 1, 5},
                            Triangle{8, 0, 9}, Triangle{9, 0, 1}, Triangle{10, 9, 1}}) {
    surface.triangles.push_back(t);
  }
  const Diagnosis diagnosis = diagnose(surface);
  EXPECT_EQ(count_of(diagnosis, "degenerate_faces"), 3U);
  ASSERT_TRUE(diagnosis.servable) << diagnosis.summary();
  const WorkingCopy copy = prepare(surface, diagnosis);
  EXPECT_TRUE(is_sound(copy.surface)) << diagnose(copy.surface).summary();
  EXPECT_NEAR(volume(copy.surface), 16.0, 1e-12);
  expect_consistent_maps(copy, surface);
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

TEST(Diagnosis, LeavesRealMeshesAlone) {
  for (const std::string name : {"hand", "knot", "octopus", "femur", "genus3_6652"}) {
    const std::string path = fixtures::shared_model(name);
    if (path.empty()) GTEST_SKIP() << "no shared models";
    const TriangleSurface surface = fixtures::load_off(path);
    const Diagnosis diagnosis = diagnose(surface);
    EXPECT_TRUE(diagnosis.servable) << name;
    EXPECT_EQ(count_of(diagnosis, "self_intersections"), 0U) << name;
    EXPECT_TRUE(same(prepare(surface, diagnosis).surface, surface)) << name;
  }
}

}  // namespace
}  // namespace mgf
