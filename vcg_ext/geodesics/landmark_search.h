// SPDX-License-Identifier: GPL-3.0-or-later
// Where landmarks are put, and how far every vertex is from them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/landmarks.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf {

namespace detail {

/// Spreads vertices over the surface: each is the farthest, along edges, from those before it.
class FarthestVertices {
 public:
  explicit FarthestVertices(const HalfedgeMesh& mesh)
      : mesh_(mesh), nearest_(mesh.vertex_count(), kInfinity) {}

  /// The next vertex. Requires one with a face.
  Index take() {
    Index farthest = kNone;
    for (Index v = 0; v < nearest_.size(); ++v) {
      if (mesh_.outgoing[v] == kNone) continue;
      if (farthest == kNone || nearest_[v] > nearest_[farthest]) farthest = v;
    }
    lower(farthest, 0.0);
    while (!queue_.empty()) {
      const auto [distance, v] = queue_.top();
      queue_.pop();
      if (distance > nearest_[v]) continue;
      Index h = mesh_.outgoing[v];
      do {
        lower(mesh_.head(h), distance + mesh_.halfedges[h].length);
        h = mesh_.rotated(h);
      } while (h != mesh_.outgoing[v]);
    }
    return farthest;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, Index>;

  void lower(Index v, double distance) {
    if (!(distance < nearest_[v])) return;
    nearest_[v] = distance;
    queue_.emplace(distance, v);
  }

  const HalfedgeMesh& mesh_;
  std::vector<double> nearest_;  ///< one per vertex: how far, along edges, the nearest one taken is
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// The distances of all vertices from `landmark`, or nothing if that takes more than `most_windows`
/// windows. `windows`: how many it took.
inline std::vector<double> distances_from(const HalfedgeMesh& mesh, Index landmark,
                                          std::size_t most_windows, std::size_t& windows) {
  PropagationPruning everywhere;
  everywhere.ellipse = false;
  WindowPropagation search(mesh, everywhere);
  search.give_up_beyond(most_windows);
  const bool is_complete = search.run(place_of_vertex(mesh, landmark), {});
  windows = search.window_count();
  std::vector<double> row;
  if (!is_complete) return row;
  row.reserve(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double distance = search.vertex_bound(v);
    row.push_back(distance < std::numeric_limits<double>::infinity() ? distance : 0.0);
  }
  return row;
}

}  // namespace detail

/// As many landmarks on `mesh` as can be measured with `most_windows` windows in all, going by
/// what the first one takes; none if that is fewer than kFewestLandmarks, or if a triangle is thin,
/// as distances from afar are uncertain there. The result does not depend on the number of threads.
///
/// Cost: about that many windows (five times as many at most, where the first one lies on a small
/// shell), and a number per vertex and landmark.
inline Landmarks place_landmarks(const HalfedgeMesh& mesh, std::size_t most_windows,
                                 unsigned threads, const Progress& progress = {}) {
  constexpr std::size_t kFewestLandmarks = 6;  // fewer save less than they take
  constexpr std::size_t kMostLandmarks = 32;
  constexpr std::size_t kWindowsPerVertex = 30;  // ten an edge, where the way is long
  Landmarks landmarks;
  const std::size_t most_each = most_windows / kFewestLandmarks;
  if (most_each < kWindowsPerVertex * mesh.vertex_count()) return landmarks;
  const auto is_thin = [](char thin) { return thin != 0; };
  if (std::any_of(mesh.is_thin.begin(), mesh.is_thin.end(), is_thin)) return landmarks;

  detail::FarthestVertices vertices(mesh);
  vertices.take();  // the first of all lies anywhere; those after it, at the ends of the shape
  std::vector<std::vector<double>> rows(1);
  std::size_t windows = 0;
  rows[0] = detail::distances_from(mesh, vertices.take(), most_each, windows);
  if (rows[0].empty()) return landmarks;

  rows.resize(std::min(kMostLandmarks, most_windows / std::max<std::size_t>(windows, 1)));
  std::vector<Index> places(rows.size());
  for (std::size_t i = 1; i < rows.size(); ++i) places[i] = vertices.take();
  parallel_for(rows.size() - 1, thread_count(threads), 1, [&](std::size_t i, unsigned worker) {
    if (worker == 0) {
      progress.report(static_cast<double>(i) / static_cast<double>(rows.size()),
                      "Measuring from landmarks");
    }
    std::size_t taken = 0;
    rows[i + 1] = detail::distances_from(mesh, places[i + 1], most_each, taken);
  });
  for (std::vector<double>& row : rows) {
    if (!row.empty()) landmarks.distance.push_back(std::move(row));
  }
  return landmarks;
}

}  // namespace mgf
