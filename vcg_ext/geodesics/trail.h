// SPDX-License-Identifier: GPL-3.0-or-later
// How windows came where they are: the triangles that they crossed, one bit each.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// The strip of triangles behind a window. Its last turns are its own, those before them are kept
/// in a `TrailStore`, sixty-four a piece.
struct Trail {
  std::uint64_t turns = 0;  ///< bit i: whether the i-th turn was to the right
  Index count = 0;          ///< how many of the bits are in use
  Index earlier = kNone;    ///< the number of the turns before them in the store, or kNone
  Index first = kNone;      ///< the directed edge that the first triangle was entered by, or kNone
};

/// The turns of all windows of one search.
class TrailStore {
 public:
  void clear() { stored_.clear(); }

  /// Adds a turn to the end of `trail`.
  void turn(Side side, Trail& trail) {
    trail.turns |= std::uint64_t{side} << trail.count;
    if (++trail.count < kBits) return;
    stored_.push_back({trail.turns, trail.earlier});
    trail.earlier = to_index(stored_.size() - 1);
    trail.turns = 0;
    trail.count = 0;
  }

  /// The directed edges by which the triangles of the strip were entered, in order.
  std::vector<Index> crossed(const HalfedgeMesh& mesh, const Trail& trail) const {
    std::vector<bool> turns;  // from the last to the first
    append_backwards(trail.turns, trail.count, turns);
    for (Index i = trail.earlier; i != kNone; i = stored_[i].earlier) {
      append_backwards(stored_[i].turns, kBits, turns);
    }
    std::vector<Index> edges{trail.first};
    edges.reserve(turns.size() + 1);
    for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn) {
      edges.push_back(mesh.crossings[edges.back()].beyond[*turn ? kRight : kLeft]);
    }
    return edges;
  }

 private:
  static constexpr Index kBits = 64;

  struct Stored {
    std::uint64_t turns;
    Index earlier;
  };

  static void append_backwards(std::uint64_t turns, Index count, std::vector<bool>& out) {
    for (Index i = count; i-- > 0;) out.push_back(((turns >> i) & 1U) != 0);
  }

  std::vector<Stored> stored_;
};

}  // namespace mgf
