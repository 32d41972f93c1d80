// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/skeleton/rank_queue.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace mgf::test {
namespace {

TEST(RankQueue, GivesTheLeastNumberWhateverTheOrderOfCalls) {
  for (const std::size_t bound : {1U, 2U, 63U, 64U, 65U, 4096U, 4097U, 300000U}) {
    std::mt19937 random(static_cast<unsigned>(bound));
    RankQueue queue(bound);
    std::set<Index> expected;
    for (int i = 0; i < 5000; ++i) {
      if (random() % 3 != 0) {
        const Index number = static_cast<Index>(random() % bound);
        queue.push(number);
        expected.insert(number);
      } else if (!expected.empty()) {
        ASSERT_EQ(queue.pop(), *expected.begin());
        expected.erase(expected.begin());
      }
      ASSERT_EQ(queue.empty(), expected.empty());
    }
    for (const Index number : expected) ASSERT_EQ(queue.pop(), number);
    EXPECT_TRUE(queue.empty());
  }
}

TEST(RankQueue, OfNothingIsEmpty) {
  EXPECT_TRUE(RankQueue(0).empty());
}

}  // namespace
}  // namespace mgf::test
