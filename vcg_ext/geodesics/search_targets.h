// SPDX-License-Identifier: GPL-3.0-or-later
// The targets of a search, and which windows can still matter to any of them.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/window.h"

namespace mgf {

/// A point whose distance is asked.
struct PropagationTarget {
  SurfacePlace place;
  double known = std::numeric_limits<double>::infinity();  ///< length of some path to it
  double limit = known;  ///< only paths that are no longer than this are searched for
};

/// The targets of one search after the other on one mesh.
///
/// A window or a point matters to a target if what is covered so far, and from there the straight
/// line in space, is not longer than the target's bound: all points that matter lie in a union
/// of ellipsoids.
class SearchTargets {
 public:
  struct Target {
    SurfacePlace place;
    double bound = 0.0;  ///< paths longer than this don't matter
    double distance = std::numeric_limits<double>::infinity();  ///< of the best arrival
    Index window = kNone, root = kNone;                         ///< that it came from
    Index next = kNone;  ///< the next target at the same vertex or in the same triangle
  };

  /// Lengths that differ by less than `tolerance` are the same.
  SearchTargets(const HalfedgeMesh& mesh, double tolerance)
      : mesh_(mesh),
        tolerance_(tolerance),
        at_vertex_(mesh.vertex_count(), kNone),
        in_triangle_(mesh.triangle_count(), kNone) {}

  /// Takes over a new search's targets.
  void assign(const std::vector<PropagationTarget>& targets) {
    for (const Target& target : targets_) slot_of(target.place) = kNone;
    targets_.clear();
    for (const PropagationTarget& asked : targets) {
      Target target;
      target.place = asked.place;
      target.bound = asked.limit;
      Index& slot = slot_of(asked.place);
      target.next = slot;
      slot = to_index(targets_.size());
      targets_.push_back(target);
    }
    refresh_reach();
  }

  const Target& operator[](std::size_t i) const { return targets_[i]; }
  /// The first target at vertex v, or kNone; the others follow by `next`.
  Index first_at_vertex(Index v) const { return at_vertex_[v]; }
  /// The same in triangle t.
  Index first_in_triangle(Index t) const { return in_triangle_[t]; }
  /// No path longer than this matters.
  double reach() const { return reach_ + tolerance_; }

  /// A path of length `distance` ends in target i, out of `window` (or straight out of `root`).
  void arrive(Index i, double distance, Index window, Index root) {
    Target& target = targets_[i];
    if (!(distance < target.distance)) return;
    target.distance = distance;
    target.window = window;
    target.root = root;
    if (distance < target.bound) {
      target.bound = distance;
      refresh_reach();
    }
  }

  /// The longest that a path to p may be and still matter, if it goes on straight.
  double rest(const Vec3& p) const {
    double longest = -std::numeric_limits<double>::infinity();
    for (const Target& target : targets_) {
      longest = std::max(longest, target.bound - (target.place.position - p).norm());
    }
    return longest + tolerance_;
  }

  /// Whether a path through a window, wherever it passes it, can still matter.
  bool matters(const Window& w) const {
    const Vec3& tail = mesh_.points[mesh_.tail(w.halfedge)];
    const Vec3 axis =
        (mesh_.points[mesh_.head(w.halfedge)] - tail) * (1.0 / mesh_.halfedges[w.halfedge].length);
    return std::any_of(targets_.begin(), targets_.end(), [&](const Target& target) {
      // Turn the target about the edge's line until it lies flat beyond the edge.
      const Vec3 arm = target.place.position - tail;
      const Vec2 place{axis.dot(arm), axis.cross(arm).norm()};
      return is_within(w, place, target.bound + tolerance_);
    });
  }

 private:
  Index& slot_of(const SurfacePlace& place) {
    return place.vertex != kNone ? at_vertex_[place.vertex] : in_triangle_[place.triangle];
  }

  void refresh_reach() {
    reach_ = 0.0;
    for (const Target& target : targets_) reach_ = std::max(reach_, target.bound);
  }

  /// Whether the shortest way from w's source through w to `place`, which is straight or bends at
  /// an end of w, is at most `bound` long.
  static bool is_within(const Window& w, Vec2 place, double bound) {
    const Vec2 beam = place - w.source;
    Vec2 rest = beam;
    double left_over = bound - w.offset;
    if (cross(w.to_left(), beam) > 0.0) {
      rest = place - Vec2{w.left, 0.0};
      left_over = bound - w.left_distance;
    } else if (cross(w.to_right(), beam) < 0.0) {
      rest = place - Vec2{w.right, 0.0};
      left_over = bound - w.right_distance;
    }
    return left_over >= 0.0 && dot(rest, rest) <= left_over * left_over;
  }

  const HalfedgeMesh& mesh_;
  double tolerance_;
  std::vector<Target> targets_;
  std::vector<Index> at_vertex_;    ///< one per vertex: the first target at it, or kNone
  std::vector<Index> in_triangle_;  ///< one per triangle: the first target in it, or kNone
  double reach_ = 0.0;
};

}  // namespace mgf
