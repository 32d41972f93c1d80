// SPDX-License-Identifier: GPL-3.0-or-later
// Splits the long edges of a surface, worst first, keeping the parts of each face well shaped.
#pragma once

#include <algorithm>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/surface_refiner.h"

namespace mgf {

/// Splits edges longer than `allowed(refiner, side)`, worst first. Ties go to the edge of least
/// ends.
template <class Allowed>
class WorstFirstSplitter {
 public:
  WorstFirstSplitter(SurfaceRefiner& refiner, const Allowed& allowed)
      : refiner_(refiner), allowed_(allowed), first_points_(point_count()) {
    for (Index side = 0; side < refiner_.side_count(); ++side) {
      if (side < refiner_.twin(side)) consider(side);
    }
  }

  /// No edge that can be split is more than this many times as long as allowed.
  double worst_excess() const { return queue_.empty() ? 1.0 : queue_.top().excess; }

  /// Goes on until no edge that can be split is more than `excess` >= 1 times as long as allowed.
  /// Returns whether it came there with less than `most_points`; at that number it ends.
  bool run(double excess, std::size_t most_points, const Progress& progress) {
    while (point_count() < most_points && worst_excess() > excess) {
      const std::size_t added = point_count() - first_points_;
      if (added % kReportEvery == 0) {
        progress.report(
            static_cast<double>(added) / static_cast<double>(most_points - first_points_),
            "sampling");
      }
      const Candidate worst = queue_.top();
      queue_.pop();
      const Candidate now = candidate(worst.side);
      if (now.low != worst.low || now.high != worst.high) continue;  // the side is another edge's
      if (now.excess == worst.excess) {
        split(worst.side);
      } else if (now.excess > 1.0) {
        queue_.push(now);
      }
    }
    return point_count() < most_points;
  }

 private:
  static constexpr std::size_t kReportEvery = 1000;

  struct Candidate {
    double excess;  // length divided by the length allowed
    Index low;
    Index high;
    Index side;
    bool operator<(const Candidate& other) const {  // so that the top is worst
      if (excess != other.excess) return excess < other.excess;
      return std::pair(low, high) > std::pair(other.low, other.high);
    }
  };

  std::size_t point_count() const { return refiner_.surface().surface.points.size(); }

  Candidate candidate(Index side) const {
    const Index a = refiner_.start(side);
    const Index b = refiner_.end(side);
    return {refiner_.length(side) / allowed_(refiner_, side), std::min(a, b), std::max(a, b), side};
  }

  void consider(Index side) {
    const Candidate fresh = candidate(side);
    if (fresh.excess > 1.0) queue_.push(fresh);
  }

  void split(Index side) {
    const Vec3& a = refiner_.point(refiner_.start(side));
    const Vec3& b = refiner_.point(refiner_.end(side));
    const Vec3 middle = 0.5 * a + 0.5 * b;
    // Not as two comparisons in a row: clang-tidy takes them for the same one twice.
    const auto is_middle = [&middle](const Vec3& end) { return end == middle; };
    if (is_middle(a) || is_middle(b)) return;  // as short as its coordinates' digits allow
    const Index m = refiner_.split_edge(side, middle);
    // The four new faces have m once each; walk round it for the sides opposite.
    changed_.clear();
    Index spoke = 3 * (side / 3) + 1;  // from m to the apex
    const Index first = spoke;
    do {
      changed_.push_back(spoke / 3);
      suspects_.push_back(opposite_side(spoke / 3, m));
      spoke = refiner_.twin(SurfaceRefiner::next(SurfaceRefiner::next(spoke)));
    } while (spoke != first);
    flip_suspects();
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    for (const Index face : changed_) {
      for (Index i = 0; i < 3; ++i) {
        const Index twin = refiner_.twin(3 * face + i);
        // An edge between two of them is looked at once.
        const bool is_seen =
            twin < 3 * face && std::binary_search(changed_.begin(), changed_.end(), twin / 3);
        if (!is_seen) consider(3 * face + i);
      }
    }
  }

  Index opposite_side(Index face, Index corner) const {
    for (Index i = 0; i < 3; ++i) {
      if (refiner_.opposite(3 * face + i) == corner) return 3 * face + i;
    }
    return kNone;
  }

  /// Lawson's flips, starting from the suspects.
  void flip_suspects() {
    while (!suspects_.empty()) {
      const Index side = suspects_.back();
      suspects_.pop_back();
      const Index other = refiner_.twin(side);
      if (!refiner_.flip_if_better(side)) continue;
      for (const Index face : {side / 3, other / 3}) {
        changed_.push_back(face);
        suspects_.push_back(3 * face + 1);
        suspects_.push_back(3 * face + 2);
      }
    }
  }

  SurfaceRefiner& refiner_;
  const Allowed& allowed_;
  std::size_t first_points_;
  std::priority_queue<Candidate> queue_;
  std::vector<Index> changed_;   // faces of the present split
  std::vector<Index> suspects_;  // sides that may have to be flipped
};

}  // namespace mgf
