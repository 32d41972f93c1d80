// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/core/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "vcg_ext/core/spatial_order.h"

namespace mgf::test {
namespace {

TEST(RadixSort, OrdersByKeyAndEqualKeysByNumber) {
  std::mt19937_64 random(1);
  for (const unsigned bits : {0U, 1U, 8U, 13U, 37U, 63U}) {
    for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
      std::vector<std::uint64_t> keys(count);
      for (std::uint64_t& key : keys) key = random() >> (63U - bits) >> 1U;
      std::vector<Index> expected(count);
      std::iota(expected.begin(), expected.end(), Index{0});
      std::stable_sort(expected.begin(), expected.end(),
                       [&](Index i, Index j) { return keys[i] < keys[j]; });
      EXPECT_EQ(sorted_by_key(keys), expected) << bits << " bits, " << count;
    }
  }
}

TEST(RadixSort, KeysOfNumbersAreOrderedAsTheNumbers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<double> ascending{-kInfinity, -1e300, -2.0, -1.0, -1e-300,  0.0,
                                      5e-324,     1e-300, 1.0,  1.5,  kInfinity};
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    EXPECT_LT(ascending_key(ascending[i - 1]), ascending_key(ascending[i]));
    EXPECT_GT(descending_key(ascending[i - 1]), descending_key(ascending[i]));
  }
  EXPECT_EQ(ascending_key(0.0), ascending_key(-0.0));
}

TEST(SpatialOrder, DoesNotDependOnTheNumbering) {
  // A corner far away puts all other points into few cells of the grid.
  std::vector<Vec3> points{{1e7, 1e7, 1e7}};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(0.0, 10.0);
  for (int i = 0; i < 300; ++i) {
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  std::vector<Vec3> shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), random);
  std::vector<Index> all(points.size());
  std::iota(all.begin(), all.end(), Index{0});
  const std::vector<Index> order = spatial_order(points, all);
  const std::vector<Index> other = spatial_order(shuffled, all);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(points[order[i]], shuffled[other[i]]);
}

}  // namespace
}  // namespace mgf::test
