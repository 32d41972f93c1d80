// SPDX-License-Identifier: GPL-3.0-or-later
// A Delaunay tetrahedralisation begun before it is certain of which points it is wanted.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <utility>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/delaunay.h"

namespace mgf {

/// Tetrahedralises on a thread of its own while others find out whether these are the points.
class DelaunayAhead {
 public:
  /// Begins with the points that `make_points` gives, which is called on the other thread; what it
  /// refers to must outlive this object.
  explicit DelaunayAhead(std::function<std::vector<Vec3>()> make_points)
      : points_(std::async(std::launch::async, std::move(make_points)).share()),
        tetrahedra_(std::async(std::launch::async, [this] { return tetrahedralise(); })) {}
  DelaunayAhead(const DelaunayAhead&) = delete;  // its thread refers to it
  DelaunayAhead& operator=(const DelaunayAhead&) = delete;
  /// Stops, and waits for the thread to end.
  ~DelaunayAhead() { stop(); }

  /// Gives up: `finish` will have to begin anew.
  void stop() { is_stopped_ = true; }

  /// As `delaunay_tetrahedra`, which it calls if the points that were begun with are others. May be
  /// called once.
  TetrahedronArrays finish(const std::vector<Vec3>& points, unsigned threads,
                           const Progress& progress) {
    if (is_stopped_ || points != points_.get()) {
      stop();
      tetrahedra_ = {};  // waits for the thread, and frees what it has made
      return delaunay_tetrahedra(points, threads, progress);
    }
    while (tetrahedra_.wait_for(kBeat) != std::future_status::ready) progress.report(0.0, kStage);
    return in_order_of_corners(tetrahedra_.get(), points.size(), threads);
  }

 private:
  static constexpr std::chrono::milliseconds kBeat{20};  // how often the user may stop
  static constexpr const char* kStage = "topology";

  TetrahedronArrays tetrahedralise() const {
    const Progress until_stopped([this](double, const char*) { return !is_stopped_; });
    return unordered_delaunay_tetrahedra(points_.get(), until_stopped);
  }

  std::atomic<bool> is_stopped_{false};
  std::shared_future<std::vector<Vec3>> points_;
  std::future<TetrahedronArrays> tetrahedra_;
};

}  // namespace mgf
