// SPDX-License-Identifier: GPL-3.0-or-later
// The paths under construction, one per pair.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/pair_geodesics.h"

namespace mgf {

/// A path for each pair, and what is known of it.
struct PairPaths {
  std::vector<double>
      length;  ///< of the shortest path in the corridor; infinity while there is none
  std::vector<std::vector<Index>> corridor;   ///< from a to b, see corridor.h
  std::vector<std::array<Vec3, 2>> tangents;  ///< of that path, unit, leaving a and leaving b
  std::vector<Certification> certification;

  explicit PairPaths(std::size_t count)
      : length(count, std::numeric_limits<double>::infinity()),
        corridor(count),
        tangents(count),
        certification(count, Certification::kUnproven) {}
  bool has(Index pair) const { return length[pair] < std::numeric_limits<double>::infinity(); }
};

}  // namespace mgf
