// SPDX-License-Identifier: GPL-3.0-or-later
// The median of values that count by a weight.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace mgf {

/// The smallest finite value such that those up to it carry half the weight of all finite ones.
/// Values count equally if no weight is positive; 0 if none is finite.
/// `weights` has one entry, not negative, per value. Cost: O(n log n).
inline double weighted_median(const std::vector<double>& values,
                              const std::vector<double>& weights) {
  std::vector<std::pair<double, double>> sorted;
  double total = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    sorted.emplace_back(values[i], weights[i]);
    total += weights[i];
  }
  if (sorted.empty()) return 0.0;
  std::sort(sorted.begin(), sorted.end());
  if (total <= 0.0) return sorted[(sorted.size() - 1) / 2].first;
  double below = 0.0;
  for (const auto& [value, weight] : sorted) {
    below += weight;
    if (below >= 0.5 * total) return value;
  }
  return sorted.back().first;
}

}  // namespace mgf
