// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a real model, as a person would count them.
#include "vcg_ext/surface/parts.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/anatomy.h"
#include "tests/fixtures.h"
#include "tests/swept_fixtures.h"

namespace mgf {
namespace {

TEST(Parts, OfAHandAreFiveFingersPalmAndWristEachInOnePiece) {
  const std::string path = fixtures::shared_model("hand");
  if (path.empty()) GTEST_SKIP() << "the shared models aren't here";
  const TriangleSurface surface = fixtures::load_off(path);
  const test::Anatomy hand = test::dissect(surface, 1.3);

  const std::map<Index, int> pieces = test::count_pieces(surface, hand.map.faces.branch);
  EXPECT_EQ(pieces.size(), 7U);
  for (const auto& [branch, count] : pieces) EXPECT_EQ(count, 1) << "branch " << branch;

  Index tips = 0;
  double area = 0.0;
  const Branch* palm = &hand.graph.branches.front();
  for (const Branch& branch : hand.graph.branches) {
    area += branch.area_share;
    if (branch.area_share > palm->area_share) palm = &branch;
    if (hand.graph.node_kind[branch.last_node] != NodeKind::kTip) continue;
    ++tips;
    EXPECT_TRUE(branch.tubular);
    EXPECT_GT(branch.tubular_share, 0.9);
  }
  EXPECT_EQ(tips, 6U);
  EXPECT_NEAR(area, 1.0, 1e-9);
  EXPECT_FALSE(palm->tubular);
  EXPECT_GT(palm->area_share, 0.25);

  EXPECT_EQ(hand.segmentation.unlabelled_faces, 0U);
  EXPECT_GT(hand.segmentation.tubular_area_share, 0.7);
  EXPECT_LT(hand.segmentation.tubular_area_share, 0.85);
  EXPECT_EQ(hand.smooth.outside_edges, 0U);
  EXPECT_LE(hand.smooth.mean_turning, 5 * M_PI / 180);
}

}  // namespace
}  // namespace mgf
