// SPDX-License-Identifier: GPL-3.0-or-later
// Disjoint sets of numbered things (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A partition of 0 .. size-1, at first into singletons. Nearly constant time a call.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size), count_(size) {
    for (Index i = 0; i < size; ++i) parent_[i] = i;
  }

  /// The smallest member of i's set.
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Joins the sets of i and j; false if they are one already.
  bool join(Index i, Index j) {
    i = find(i);
    j = find(j);
    if (i == j) return false;
    parent_[std::max(i, j)] = std::min(i, j);
    --count_;
    return true;
  }

  /// The number of sets.
  std::size_t count() const { return count_; }

 private:
  std::vector<Index> parent_;
  std::size_t count_;
};

}  // namespace mgf
