// SPDX-License-Identifier: GPL-3.0-or-later
// The targets of a search, and which windows can still matter to any of them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/landmarks.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/trail.h"
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
    double distance = std::numeric_limits<double>::infinity();  ///< of the best arrival
    Index root = kNone;                                         ///< that it came from,
    Trail trail;                                                ///< and how
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
    places_.resize(static_cast<Eigen::Index>(targets.size()), 3);
    bounds_.resize(places_.rows());
    rests_.clear();
    has_any_in_triangles_ = false;
    for (const PropagationTarget& asked : targets) {
      const auto i = static_cast<Eigen::Index>(targets_.size());
      Target target;
      target.place = asked.place;
      places_.row(i) = asked.place.position.transpose().array();
      bounds_[i] = asked.limit;
      Index& slot = slot_of(asked.place);
      target.next = slot;
      slot = to_index(targets_.size());
      targets_.push_back(target);
      has_any_in_triangles_ = has_any_in_triangles_ || asked.place.vertex == kNone;
    }
    refresh_reach();
    measure_from_landmarks();
  }

  const Target& operator[](std::size_t i) const { return targets_[i]; }
  /// The first target at vertex v, or kNone; the others follow by `next`.
  Index first_at_vertex(Index v) const { return at_vertex_[v]; }
  /// Whether any target lies in a triangle.
  bool has_any_in_triangles() const { return has_any_in_triangles_; }
  /// The first target in triangle t, likewise.
  Index first_in_triangle(Index t) const { return in_triangle_[t]; }
  /// No path longer than this matters.
  double reach() const { return reach_ + tolerance_; }

  /// A path of length `distance` ends in target i, out of `root` along `trail` (straight, if that
  /// has no first edge).
  void arrive(Index i, double distance, Index root, const Trail& trail) {
    Target& target = targets_[i];
    if (!(distance < target.distance)) return;
    target.distance = distance;
    target.root = root;
    target.trail = trail;
    if (distance < bounds_[i]) {
      bounds_[i] = distance;
      refresh_reach();
    }
  }

  /// Works out for each target how long a path to vertex v may be and still matter to it. Between
  /// two points that differs by no more than the way from one to the other. Returns where these
  /// numbers are kept until the next search; `most` is the largest.
  Index rests(Index v, double& most) {
    const Index first = to_index(rests_.size());
    most = -kInfinity;
    if (targets_.empty()) return first;
    rests_.resize(rests_.size() + targets_.size());
    Eigen::Map<Eigen::ArrayXd> rests(&rests_[first], bounds_.size());
    const Vec3& p = mesh_.points[v];
    rests = bounds_ - ((places_.col(0) - p.x()).square() + (places_.col(1) - p.y()).square() +
                       (places_.col(2) - p.z()).square())
                          .sqrt();
    if (!from_landmarks_.empty()) {
      for (std::size_t i = 0; i < targets_.size(); ++i) {
        rests_[first + i] = std::min(rests_[first + i], rest_by_landmarks(i, v));
      }
    }
    rests += tolerance_;
    most = rests.maxCoeff();
    return first;
  }

  /// Whether a path through a window, wherever it passes it, can still matter. `interval` is the
  /// window's, `offset` the distance of its root from the start, `tail_rests` and `head_rests` what
  /// `rests` said of the ends of its edge.
  bool matters(const Window& window, const WindowInterval& interval, double offset,
               Index tail_rests, Index head_rests) const {
    // From the far end of the window, what is left beyond an end of the edge is least.
    const double by_tail =
        offset + std::sqrt(interval.right_square) - interval.right * interval.length;
    const double by_head =
        offset + std::sqrt(interval.left_square) - (1.0 - interval.left) * interval.length;
    const EdgeInSpace edge(mesh_, window, interval.length);
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      if (std::min(rests_[tail_rests + i] - by_tail, rests_[head_rests + i] - by_head) < 0.0)
        continue;
      if (is_within(window, interval, edge, i, offset)) return true;
    }
    return false;
  }

 private:
  Index& slot_of(const SurfacePlace& place) {
    return place.vertex != kNone ? at_vertex_[place.vertex] : in_triangle_[place.triangle];
  }

  void refresh_reach() {
    reach_ = kInfinity;
    if (!targets_.empty()) reach_ = std::max(0.0, bounds_.maxCoeff());
  }

  /// A path of length l to a point at distance d of a landmark has at least |d - d'| to go to a
  /// target at d': it matters only if l <= bound + d' - d and l <= bound - d' + d.
  void measure_from_landmarks() {
    from_landmarks_.clear();
    if (landmarks_ == nullptr) return;
    const double rounding = kLandmarkRounding * mesh_.mean_edge;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      for (const std::vector<double>& row : landmarks_->distance) {
        const DistanceRange range = distance_of_place(mesh_, row, targets_[i].place);
        from_landmarks_.push_back(
            {bound_of(i) + range.most + rounding, bound_of(i) - range.least + rounding});
      }
    }
  }

  /// What landmarks say of how long a path to v may be and still matter to target i.
  double rest_by_landmarks(std::size_t i, Index v) const {
    const std::size_t count = landmarks_->distance.size();
    double rest = kInfinity;
    for (std::size_t k = 0; k < count; ++k) {
      const FromLandmark& from = from_landmarks_[i * count + k];
      const double distance = landmarks_->distance[k][v];
      rest = std::min({rest, from.outward - distance, from.inward + distance});
    }
    return rest;
  }

  /// A window's edge in space, to turn targets about it.
  struct EdgeInSpace {
    EdgeInSpace(const HalfedgeMesh& mesh, const Window& window, double length)
        : tail(mesh.points[window.ends[Window::kTail].vertex]),
          span(mesh.points[window.ends[Window::kHead].vertex] - tail),
          inverse_square(1.0 / (length * length)) {}

    Vec3 tail, span;
    double inverse_square;  ///< of its length
  };

  double bound_of(std::size_t i) const { return bounds_[static_cast<Eigen::Index>(i)]; }

  /// Whether the shortest way from the root through the window to target i, which is straight or
  /// bends at an end of the window, is at most as long as the target's bound.
  bool is_within(const Window& window, const WindowInterval& interval, const EdgeInSpace& edge,
                 std::size_t i, double offset) const {
    const double allowed = bound_of(i) + tolerance_ - offset;
    // Turn the target about the edge's line until it lies flat beyond the edge.
    const Vec3 arm = targets_[i].place.position - edge.tail;
    const Vec2 place =
        place_beside(window.ends[Window::kTail].place, window.ends[Window::kHead].place,
                     edge.span.dot(arm) * edge.inverse_square,
                     edge.span.cross(arm).norm() * edge.inverse_square);
    if (!(allowed >= 0.0) || dot(place, place) > allowed * allowed) return false;
    if (cross(window.left_ray, place) > 0.0) {
      return !(std::sqrt(interval.left_square) + norm(place - interval.left_place) > allowed);
    }
    if (cross(window.right_ray, place) < 0.0) {
      return !(std::sqrt(interval.right_square) + norm(place - interval.right_place) > allowed);
    }
    return true;
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kLandmarkRounding = 1e-6;  ///< of the mean edge; distances are far better

  /// What a landmark says of a target; see measure_from_landmarks.
  struct FromLandmark {
    double outward;
    double inward;
  };

  const HalfedgeMesh& mesh_;
  double tolerance_;
  const Landmarks* landmarks_;
  std::vector<FromLandmark> from_landmarks_;  ///< a row per target, of one per landmark
  std::vector<Target> targets_;
  Eigen::ArrayX3d places_;          ///< one row per target: its position, once more, for `rests`
  Eigen::ArrayXd bounds_;           ///< one per target: longer paths don't matter
  std::vector<Index> at_vertex_;    ///< one per vertex: the first target at it, or kNone
  std::vector<Index> in_triangle_;  ///< one per triangle: the first target in it, or kNone
  double reach_ = 0.0;
  std::vector<double> rests_;  ///< of the vertices asked for, one per target each
  bool has_any_in_triangles_ = false;
};

}  // namespace mgf
