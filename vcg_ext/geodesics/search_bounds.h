// SPDX-License-Identifier: GPL-3.0-or-later
// What a search knows of the vertices, and what of the search that makes needless.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/search_targets.h"
#include "vcg_ext/geodesics/window.h"

namespace mgf {

/// Which of the searches' shortcuts are taken. The answer is the same with any of them.
struct PropagationPruning {
  bool vertex_filters = true;  ///< drop windows that a vertex nearby serves better
  bool clip_shadows = true;    ///< clip what leaves a saddle to its shadow
  bool ellipse = true;         ///< drop windows too far off to matter to any target
};

/// To compare a length given by its square with one that may be negative.
inline double signed_square(double x) {
  return x * std::abs(x);
}

/// How long paths to each vertex may be: not longer than one that is known, and not so long that
/// they can't matter to any target.
class SearchBounds {
 public:
  /// Lengths that differ by less than `tolerance` are the same. `targets` must outlive it.
  SearchBounds(const HalfedgeMesh& mesh, const PropagationPruning& pruning, double tolerance,
               SearchTargets& targets)
      : pruning_(pruning), tolerance_(tolerance), targets_(targets), states_(mesh.vertex_count()) {}

  /// Forgets what the search before found.
  void clear() {
    for (const Index v : touched_) states_[v] = {};
    touched_.clear();
  }

  /// Length of some path from the start to v; infinity if there is none yet.
  double known(Index v) const { return states_[v].known; }

  /// There is a path of that length to v.
  void learn(Index v, double length) {
    double& known = states_[v].known;
    if (length >= known) return;
    if (known == kInfinity) touched_.push_back(v);
    known = length;
  }

  /// Whether a path of that length to v is longer than the one known.
  bool is_detour(Index v, double length) const { return length > states_[v].known + tolerance_; }

  /// The longest that a path to v may be and still matter to any target.
  double rest(Index v) {
    const double rest = states_[v].rest;
    return rest == kInfinity && pruning_.ellipse ? ask_rest(v) : rest;
  }

  /// Whether a path through a window can still matter; `offset` is the distance of its root from
  /// the start. The ends of its edge tell for most: what is left of a bound at a point, and the
  /// length of a way to it, differ between two points by no more than the way from one to the
  /// other. From the far end of the window, an end of the edge is a detour for none of its paths or
  /// for all.
  bool can_matter(const Window& w, const WindowInterval& interval, double offset) {
    const Index tail = w.ends[Window::kTail].vertex;
    const Index head = w.ends[Window::kHead].vertex;
    const double length = interval.length;
    const double left = interval.left * length;
    const double right = interval.right * length;
    const double tail_rest = rest(tail) - offset;
    const double head_rest = rest(head) - offset;
    const double tail_limit = std::min(tail_rest, most_without_detour(tail) - offset);
    const double head_limit = std::min(head_rest, most_without_detour(head) - offset);
    if (std::max(interval.right_square - signed_square(tail_limit + right),
                 interval.left_square - signed_square(head_limit + (length - left))) > 0.0) {
      return false;
    }
    return std::min(interval.left_square - signed_square(tail_rest - left),
                    interval.right_square - signed_square(head_rest - (length - right))) <= 0.0 ||
           !pruning_.ellipse ||
           targets_.matters(w, interval, offset, states_[tail].rests, states_[head].rests);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  struct VertexState {
    double known = kInfinity;
    double rest = kInfinity;  ///< infinity if not yet asked
    Index rests = 0;          ///< see SearchTargets::rests
  };

  double ask_rest(Index v) {
    touched_.push_back(v);
    VertexState& state = states_[v];
    state.rests = targets_.rests(v, state.rest);
    return state.rest;
  }

  double most_without_detour(Index v) const {
    return pruning_.vertex_filters ? states_[v].known + tolerance_ : kInfinity;
  }

  PropagationPruning pruning_;
  double tolerance_;
  SearchTargets& targets_;
  std::vector<VertexState> states_;  ///< one per vertex
  std::vector<Index> touched_;       ///< vertices with something known or a rest
};

}  // namespace mgf
