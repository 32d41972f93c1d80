// SPDX-License-Identifier: GPL-3.0-or-later
// Shortest paths along edges: the first guess that geodesics start from.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// A* over the edges of one mesh, keeping its memory between searches; one per thread.
class EdgeSearch {
 public:
  explicit EdgeSearch(const HalfedgeMesh& mesh)
      : mesh_(mesh),
        distance_(mesh.vertex_count(), kInfinity),
        parent_(mesh.vertex_count(), kNone) {}

  /// The vertices of the shortest edge path from a to b, both included, or nothing if there is
  /// none.
  std::vector<Index> run(Index a, Index b) {
    std::vector<Index> path;
    reach(a, 0.0, kNone, b);
    while (!queue_.empty()) {
      const auto [estimate, v] = queue_.top();
      queue_.pop();
      if (v == b) {
        for (Index at = b; at != kNone; at = parent_[at]) path.push_back(at);
        std::reverse(path.begin(), path.end());
        break;
      }
      if (estimate > distance_[v] + remaining(v, b)) continue;
      Index h = mesh_.outgoing[v];
      do {
        reach(mesh_.head(h), distance_[v] + mesh_.halfedges[h].length, v, b);
        h = mesh_.rotated(h);
      } while (h != mesh_.outgoing[v]);
    }
    clear();
    return path;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, Index>;

  double remaining(Index v, Index b) const { return (mesh_.points[b] - mesh_.points[v]).norm(); }

  void reach(Index v, double distance, Index from, Index b) {
    if (mesh_.outgoing[v] == kNone || !(distance < distance_[v])) return;
    if (distance_[v] == kInfinity) touched_.push_back(v);
    distance_[v] = distance;
    parent_[v] = from;
    queue_.emplace(distance + remaining(v, b), v);
  }

  void clear() {
    for (const Index v : touched_) distance_[v] = kInfinity;
    touched_.clear();
    queue_ = {};
  }

  const HalfedgeMesh& mesh_;
  std::vector<double> distance_;
  std::vector<Index> parent_;
  std::vector<Index> touched_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace mgf
