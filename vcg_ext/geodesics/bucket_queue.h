// SPDX-License-Identifier: GPL-3.0-or-later
// A queue by distance, in buckets, for searches whose answer does not depend on the exact order.
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Entries come out by distance, rounded down to buckets; last in, first out within one. Keeps its
/// memory.
class BucketQueue {
 public:
  /// width: what distances are rounded to, more than 0.
  explicit BucketQueue(double width) : buckets_per_length_(1.0 / width) {}

  void clear() {
    for (std::vector<Index>& bucket : buckets_) bucket.clear();
    current_ = 0;
  }

  /// Distances that are smaller than the last one popped count as that one; those of over 1e8
  /// buckets are dropped.
  void push(double distance, Index entry) {
    const double position = distance * buckets_per_length_;
    if (!(position <= kMostBuckets)) return;
    const std::size_t bucket = std::max(current_, static_cast<std::size_t>(position));
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
    buckets_[bucket].push_back(entry);
  }

  /// The next entry, or kNone if there is none in a bucket that starts at `limit` or before.
  Index pop(double limit) {
    while (current_ < buckets_.size() && buckets_[current_].empty()) ++current_;
    if (current_ >= buckets_.size() ||
        static_cast<double>(current_) > limit * buckets_per_length_) {
      return kNone;
    }
    const Index entry = buckets_[current_].back();
    buckets_[current_].pop_back();
    return entry;
  }

 private:
  static constexpr double kMostBuckets = 1e8;

  double buckets_per_length_;
  std::vector<std::vector<Index>> buckets_;
  std::size_t current_ = 0;
};

}  // namespace mgf
