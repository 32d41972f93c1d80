// SPDX-License-Identifier: GPL-3.0-or-later
// The targets of a search, and which windows can still matter to any of them.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/landmarks.h"
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
/// of ellipsoids. Landmarks, if there are any, bound the rest of the way from a vertex, too.
///
/// Without targets, there is no bound to the search.
class SearchTargets {
 public:
  struct Target {
    SurfacePlace place;
    double bound = 0.0;  ///< paths longer than this don't matter
    double distance = std::numeric_limits<double>::infinity();  ///< of the best arrival
    Index window = kNone, root = kNone;                         ///< that it came from
    Index next = kNone;  ///< the next target at the same vertex or in the same triangle
  };

  /// Lengths that differ by less than `tolerance` are the same. `landmarks`: on this mesh, or
  /// nullptr; may be filled in between two searches.
  SearchTargets(const HalfedgeMesh& mesh, double tolerance, const Landmarks* landmarks)
      : mesh_(mesh),
        tolerance_(tolerance),
        landmarks_(landmarks),
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
    measure_from_landmarks();
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

  /// No path to vertex v that is longer than this matters. Between two points it differs by no more
  /// than the way from one to the other.
  double rest(Index v) const {
    double longest = -kInfinity;
    for (const Target& target : targets_) {
      longest = std::max(longest, target.bound - (target.place.position - mesh_.points[v]).norm());
    }
    for (std::size_t i = 0; i < from_landmarks_.size(); ++i) {
      const double distance = landmarks_->distance[i][v];
      longest = std::min(longest, std::min(from_landmarks_[i].outward - distance,
                                           from_landmarks_[i].inward + distance));
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
    reach_ = targets_.empty() ? kInfinity : 0.0;
    for (const Target& target : targets_) reach_ = std::max(reach_, target.bound);
  }

  /// A path of length l to a point at distance d of a landmark has at least |d - d'| to go to a
  /// target at d': it matters only if l <= bound + d' - d and l <= bound - d' + d for some target.
  void measure_from_landmarks() {
    from_landmarks_.clear();
    if (landmarks_ == nullptr) return;
    const double rounding = kLandmarkRounding * mesh_.mean_edge;
    for (const std::vector<double>& row : landmarks_->distance) {
      FromLandmark from;
      for (const Target& target : targets_) {
        const DistanceRange range = distance_of_place(mesh_, row, target.place);
        from.outward = std::max(from.outward, target.bound + range.most + rounding);
        from.inward = std::max(from.inward, target.bound - range.least + rounding);
      }
      from_landmarks_.push_back(from);
    }
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

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kLandmarkRounding = 1e-6;  ///< of the mean edge; distances are far better

  /// What a landmark says of the targets; see measure_from_landmarks.
  struct FromLandmark {
    double outward = -kInfinity;
    double inward = -kInfinity;
  };

  const HalfedgeMesh& mesh_;
  double tolerance_;
  const Landmarks* landmarks_;
  std::vector<FromLandmark> from_landmarks_;  ///< one per landmark
  std::vector<Target> targets_;
  std::vector<Index> at_vertex_;    ///< one per vertex: the first target at it, or kNone
  std::vector<Index> in_triangle_;  ///< one per triangle: the first target in it, or kNone
  double reach_ = 0.0;
};

}  // namespace mgf
