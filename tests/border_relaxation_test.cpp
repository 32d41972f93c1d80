// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/surface/border_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/swept_fixtures.h"

namespace mgf::test {
namespace {

/// `n` x `n` unit squares, each cut into two triangles, and labels by the triangles' centroids.
struct LabelledPlate {
  TriangleSurface surface;
  FaceGraph faces;
  std::vector<Index> label;

  LabelledPlate(Index n, const std::function<Index(const Vec3&)>& label_at) {
    for (Index i = 0; i <= n; ++i) {
      for (Index j = 0; j <= n; ++j) surface.points.emplace_back(i, j, 0.0);
    }
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const Index a = i * (n + 1) + j;
        const Index c = a + n + 1;
        surface.triangles.push_back({a, c, c + 1});
        surface.triangles.push_back({a, c + 1, a + 1});
      }
    }
    faces = build_face_graph(surface);
    for (const Vec3& p : faces.centroid) label.push_back(label_at(p));
  }

  double border_length() const { return test::border_length(faces, label); }

  void relax(double reach, unsigned threads = 1) {
    relax_borders(faces, std::vector<double>(label.size(), reach), threads, label);
  }
};

TEST(BorderRelaxation, LevelsStepsOfSeveralFaces) {
  LabelledPlate plate(40, [](const Vec3& p) {
    const bool step = static_cast<int>(p.y() / 4) % 2 == 0;  // four squares wide, three high
    return p.x() < (step ? 18.5 : 21.5) ? 3U : 8U;
  });
  const double stepped = plate.border_length();
  plate.relax(6.0);
  EXPECT_LT(plate.border_length(), 50.0);
  EXPECT_GT(stepped, 65.0);
  for (Index f = 0; f < plate.label.size(); ++f) {
    const double x = plate.faces.centroid[f].x();
    EXPECT_TRUE(x > 17 || plate.label[f] == 3U);
    EXPECT_TRUE(x < 23 || plate.label[f] == 8U);
  }
}

TEST(BorderRelaxation, LeavesAStraightBorder) {
  LabelledPlate plate(30, [](const Vec3& p) { return p.x() < 15 ? 1U : 0U; });
  const std::vector<Index> before = plate.label;
  plate.relax(5.0);
  EXPECT_EQ(plate.label, before);
}

TEST(BorderRelaxation, RemovesWhatIsThinnerThanItsReachOnly) {
  LabelledPlate plate(40, [](const Vec3& p) {
    if (std::abs(p.x() - 10) < 1) return 1U;          // a thin strip
    return std::abs(p.x() - 28) < 6 ? 2U : Index{0};  // a wide one
  });
  plate.relax(5.0);
  EXPECT_EQ(std::count(plate.label.begin(), plate.label.end(), 1U), 0);
  EXPECT_NEAR(static_cast<double>(std::count(plate.label.begin(), plate.label.end(), 2U)),
              2 * 12 * 40, 60);
}

TEST(BorderRelaxation, GivesUnlabelledFacesNothing) {
  LabelledPlate plate(20, [](const Vec3& p) { return p.x() < 10 ? Index{5} : kNone; });
  const std::vector<Index> before = plate.label;
  plate.relax(4.0);
  EXPECT_EQ(plate.label, before);
}

TEST(BorderRelaxation, DoesntDependOnThreads) {
  const auto wavy = [](const Vec3& p) {
    return static_cast<Index>((p.x() + 3 * std::sin(p.y())) / 9);
  };
  LabelledPlate one(40, wavy);
  LabelledPlate four(40, wavy);
  one.relax(4.0, 1);
  four.relax(4.0, 4);
  EXPECT_EQ(one.label, four.label);
}

}  // namespace
}  // namespace mgf::test
