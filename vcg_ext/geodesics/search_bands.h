// SPDX-License-Identifier: GPL-3.0-or-later
// What a search has still to do, sorted by bands of distances from its start.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/trail.h"
#include "vcg_ext/geodesics/window.h"

namespace mgf {

/// Where straight paths start from: the start of a search, or a saddle that paths bend at.
struct SearchRoot {
  double offset = 0.0;   ///< its distance from the start
  double arrival = 0.0;  ///< direction to where the path came from, about the vertex
  Index vertex = kNone;  ///< kNone for a start in a triangle
  Index parent = kNone;  ///< the root that the path came from; kNone for the start
  Trail trail;           ///< and the way from there
};

/// Windows that wait for the band that they go on in, and saddles for their turn. In a band,
/// windows come first, in the order that they were put off in, then saddles, nearest first.
class SearchBands {
 public:
  explicit SearchBands(double width) : width_(width) {}

  /// Back to the first band, with nothing to do.
  void clear() {
    for (std::vector<Window>& band : windows_) band.clear();
    saddles_.clear();
    queue_ = {};
    band_ = 0;
    last_ = 0;
  }

  /// The distance at which the present band ends.
  double end() const { return width_ * static_cast<double>(band_ + 1); }

  /// Goes on to the next band; false if there is nothing in any.
  bool advance() {
    ++band_;
    return band_ <= last_ || !queue_.empty();
  }

  /// Keeps a window for the band that `nearest` lies in, at least the next one; it may be less than
  /// nothing, as a lower bound of a distance. False if it would be beyond 1e8 bands.
  bool put_off(const Window& window, double nearest) {
    const double position = std::max(nearest, 0.0) / width_;
    if (!(position <= kMostBands)) return false;
    const std::size_t band = std::max(band_ + 1, static_cast<std::size_t>(position));
    if (band >= windows_.size()) windows_.resize(band + 1);
    windows_[band].push_back(window);
    last_ = std::max(last_, band);
    return true;
  }

  /// The windows of the present band, to be followed; valid until the next call.
  std::vector<Window>& take_windows() {
    taken_.clear();
    if (band_ < windows_.size()) taken_.swap(windows_[band_]);
    return taken_;
  }

  void put_off(const SearchRoot& saddle) {
    queue_.emplace(saddle.offset, to_index(saddles_.size()));
    saddles_.push_back(saddle);
  }

  /// Whether a saddle's turn is in the present band.
  bool has_saddle() const { return !queue_.empty() && queue_.top().first <= end(); }
  /// The nearest saddle.
  SearchRoot take_saddle() {
    const Index number = queue_.top().second;
    queue_.pop();
    return saddles_[number];
  }

 private:
  static constexpr double kMostBands = 1e8;

  using Entry = std::pair<double, Index>;  ///< distance and number of a saddle

  double width_;
  std::size_t band_ = 0;                      ///< the present one
  std::size_t last_ = 0;                      ///< the last one with windows
  std::vector<std::vector<Window>> windows_;  ///< by band
  std::vector<Window> taken_;
  std::vector<SearchRoot> saddles_;  ///< all that have been put off
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

}  // namespace mgf
