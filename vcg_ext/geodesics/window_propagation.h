// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances from one point to a few others by propagating windows over the surface
// (Chen & Han 1990; filters of Xin & Wang 2009), bounded by what is known of the targets.
//
// Notation. A window is an interval [left, right] of a directed edge h, in the frame of h, through
// which straight paths from `source` (below the edge, y <= 0) enter the triangle of h; `offset` is
// the distance at which that source itself lies from the start. A root is a point that paths
// start from: the start, or a saddle that they bend at. The shadow of a saddle is the part of its
// fan that a path may leave into with at least a half turn on both sides.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_place.h"

namespace mgf {

/// Which of the searches' shortcuts are taken. The answer is the same with any of them.
struct PropagationPruning {
  bool vertex_filters = true;  ///< drop windows that a vertex nearby serves better
  bool clip_shadows = true;    ///< clip what leaves a saddle to its shadow
  bool ellipse = true;         ///< drop windows too far off to matter to any target
};

/// A point whose distance is asked, and the length of some path to it (infinity if none is known).
struct PropagationTarget {
  SurfacePlace place;
  double bound = std::numeric_limits<double>::infinity();
};

/// The workspace of window propagation on one mesh; one per thread. Memory grows with the number
/// of windows of the largest search, at most `kMostWindows`.
class WindowPropagation {
 public:
  /// A search that needs more windows than this ends as incomplete.
  static constexpr std::size_t kMostWindows = std::size_t{1} << 24U;

  explicit WindowPropagation(const HalfedgeMesh& mesh, PropagationPruning pruning = {})
      : mesh_(mesh),
        pruning_(pruning),
        tolerance_(1e-10 * mesh.mean_edge),
        bucket_width_(0.5 * mesh.mean_edge),
        bound_(mesh.vertex_count(), kInfinity),
        slot_of_(mesh.vertex_count(), kNone),
        first_in_(mesh.triangle_count(), kNone),
        last_root_(mesh.vertex_count(), kNone) {}

  /// Searches from `start` until every target's distance is certain. Returns false if the search
  /// was given up for its size; lengths found are then only upper bounds.
  bool run(const SurfacePlace& start, const std::vector<PropagationTarget>& targets) {
    begin(targets);
    if (start.vertex != kNone) {
      add_root(start.vertex, 0.0, kNone, kNone, 0.0);
    } else {
      roots_.push_back({0.0, 0.0, kNone, kNone, kNone});
      spread_in_triangle(start);
    }
    const bool complete = drain();
    end();
    return complete;
  }

  /// From now on keeps to the triangles t with allowed[t] != 0; nullptr allows all. What is found
  /// then is the shortest path among those in the triangles allowed.
  void keep_to(const std::vector<char>* allowed) { allowed_ = allowed; }

  /// Length of the path found to target i of the last run; infinity if there is none.
  double distance(std::size_t i) const { return targets_[i].distance; }

  /// The path to target i of the last run as straight pieces in order. Requires a finite distance.
  /// An end that is no vertex is kNone.
  std::vector<PathPiece> pieces(std::size_t i) const {
    std::vector<PathPiece> path;
    Index vertex = targets_[i].place.vertex;
    Index window = targets_[i].window;
    Index root = targets_[i].root;
    while (true) {
      PathPiece piece;
      for (Index w = window; w != kNone; w = windows_[w].parent) {
        piece.crossed.push_back(windows_[w].halfedge);
      }
      std::reverse(piece.crossed.begin(), piece.crossed.end());
      piece.from = roots_[root].vertex;
      piece.to = vertex;
      vertex = piece.from;
      path.push_back(std::move(piece));
      if (roots_[root].parent_root == kNone) break;
      window = roots_[root].parent_window;
      root = roots_[root].parent_root;
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// Whether the last run came through a triangle that is too thin to be certain of.
  bool met_thin_triangle() const { return met_thin_triangle_; }

  /// How many windows the last run made.
  std::size_t window_count() const { return windows_.size(); }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kAngleSlack = 1e-8;  ///< rounding of a ray's direction, made good at
                                               ///< second order: lengths err by its square
  static constexpr Index kRootFlag = Index{1} << 31U;

  struct Window {
    double left, right;
    Vec2 source;
    double offset;
    Index halfedge, parent, root;
  };
  struct Root {
    double offset;
    double arrival;  ///< direction to where the path came from, about the vertex
    Index vertex, parent_window, parent_root;
  };
  struct Target {
    SurfacePlace place;
    double bound;     ///< no window that only serves longer paths matters to this target
    double distance;  ///< of the best arrival
    Index window, root;
    Index next;  ///< the next target in the same triangle, or kNone
  };

  double padded(double bound) const { return bound + tolerance_; }

  void begin(const std::vector<PropagationTarget>& targets) {
    windows_.clear();
    roots_.clear();
    targets_.clear();
    for (const PropagationTarget& target : targets) {
      const SurfacePlace& place = target.place;
      Index& slot = place.vertex != kNone ? slot_of_[place.vertex] : first_in_[place.triangle];
      targets_.push_back({place, target.bound, kInfinity, kNone, kNone, slot});
      slot = to_index(targets_.size() - 1);
      if (place.vertex != kNone) lower_bound_at(place.vertex, target.bound);
    }
    refresh_reach();
    current_bucket_ = 0;
    last_keeper_ = 0;
    met_thin_triangle_ = false;
  }

  void end() {
    for (const Target& target : targets_) {
      if (target.place.vertex != kNone) {
        slot_of_[target.place.vertex] = kNone;
      } else {
        first_in_[target.place.triangle] = kNone;
      }
    }
    for (const Index v : touched_) {
      bound_[v] = kInfinity;
      last_root_[v] = kNone;
    }
    touched_.clear();
    for (std::vector<Index>& bucket : buckets_) bucket.clear();
  }

  void refresh_reach() {
    reach_ = 0.0;
    for (const Target& target : targets_) reach_ = std::max(reach_, target.bound);
  }

  void lower_bound_at(Index v, double distance) {
    if (distance >= bound_[v]) return;
    if (bound_[v] == kInfinity) touched_.push_back(v);
    bound_[v] = distance;
  }

  // ---- the queue: buckets by distance, last in first out within one ----

  void push(double key, Index entry) {
    const double position = key / bucket_width_;
    if (!(key <= padded(reach_)) || position > 1e8) return;
    const std::size_t bucket = std::max(current_bucket_, static_cast<std::size_t>(position));
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
    buckets_[bucket].push_back(entry);
  }

  bool drain() {
    for (; current_bucket_ < buckets_.size(); ++current_bucket_) {
      if (static_cast<double>(current_bucket_) * bucket_width_ > padded(reach_)) return true;
      while (!buckets_[current_bucket_].empty()) {
        const Index entry = buckets_[current_bucket_].back();
        buckets_[current_bucket_].pop_back();
        if ((entry & kRootFlag) != 0) {
          spread(entry & ~kRootFlag);
        } else {
          propagate(entry);
        }
        if (windows_.size() > kMostWindows) return false;
      }
    }
    return true;
  }

  // ---- arrivals at vertices ----

  /// A path of length `distance` reaches v, seen from v in direction `arrival`.
  void arrive(Index v, double distance, double arrival, Index window, Index root) {
    lower_bound_at(v, distance);
    if (slot_of_[v] != kNone) reach_target(targets_[slot_of_[v]], distance, window, root);
    if (!mesh_.is_saddle(v) || distance > padded(bound_[v])) return;
    const Index last = last_root_[v];
    if (last != kNone && roots_[last].offset <= padded(distance) &&
        std::abs(roots_[last].arrival - arrival) < 1e-9) {
      return;
    }
    add_root(v, distance, window, root, arrival);
  }

  void reach_target(Target& target, double distance, Index window, Index root) {
    if (!(distance < target.distance)) return;
    target.distance = distance;
    target.window = window;
    target.root = root;
    if (distance < target.bound) {
      target.bound = distance;
      refresh_reach();
    }
  }

  /// Whether a shorter path to the root has turned up since.
  bool is_stale(const Root& root) const {
    return root.vertex != kNone && root.offset > padded(bound_[root.vertex]);
  }

  void add_root(Index v, double offset, Index window, Index root, double arrival) {
    if (root != kNone && pruning_.ellipse && !matters(mesh_.points[v], offset)) return;
    last_root_[v] = to_index(roots_.size());
    roots_.push_back({offset, arrival, v, window, root});
    lower_bound_at(v, offset);
    push(offset, last_root_[v] | kRootFlag);
  }

  /// Whether a path that is `offset` long at p can still be as short as a target's bound.
  bool matters(const Vec3& p, double offset) const {
    for (const Target& target : targets_) {
      if (offset + (target.place.position - p).norm() <= padded(target.bound)) return true;
    }
    return false;
  }

  // ---- windows out of a root ----

  void spread(Index root) {
    const Root at = roots_[root];  // a copy: arrivals add roots
    if (is_stale(at)) return;
    const bool is_start = at.parent_root == kNone;
    const double turn = mesh_.total_angle[at.vertex];
    double from = 0.0;
    double width = turn;
    if (!is_start && pruning_.clip_shadows) {
      from = std::fmod(at.arrival + kPi - kAngleSlack, turn);
      width = turn - 2.0 * kPi + 2.0 * kAngleSlack;
    }
    const Index first = mesh_.outgoing[at.vertex];
    Index h = first;
    do {
      spread_into(root, h, from, width);
      spread_into(root, h, from - turn, width);
      h = mesh_.rotated(h);
    } while (h != first);
  }

  /// The part of the directions [from, from + width] that lies in the corner at the tail of h.
  void spread_into(Index root, Index h, double from, double width) {
    const double corner = mesh_.corner_angle(h);
    const double low = std::max(from - mesh_.direction[h], 0.0);
    const double high = std::min(from + width - mesh_.direction[h], corner);
    if (low > high) return;
    const double offset = roots_[root].offset;
    if (low <= 0.0) {  // along the edge itself
      arrive(mesh_.head(h), offset + mesh_.halfedges[h].length, mesh_.direction[mesh_.opposite(h)],
             kNone, root);
    }
    for (Index i = first_in_[triangle_of(h)]; i != kNone; i = targets_[i].next) {
      const Vec2 place = in_frame_of(mesh_, h, targets_[i].place.at);
      const double angle = std::atan2(place.y, place.x);
      if (angle >= low - kAngleSlack && angle <= high + kAngleSlack) {
        reach_target(targets_[i], offset + norm(place), kNone, root);
      }
    }
    const Index far = next_in_triangle(h);
    const Halfedge& side = mesh_.halfedges[far];
    const Vec2 source{side.length - side.apex.x, -side.apex.y};
    const double left = high >= corner ? 0.0 : side.length - opposite_position(h, high);
    const double right = low <= 0.0 ? side.length : side.length - opposite_position(h, low);
    add_window({left, right, source, offset, side.opposite, kNone, root}, mesh_.tail(h), source,
               true);
  }

  /// Where the ray at `angle` from h out of its tail meets the side opposite, from h's head.
  double opposite_position(Index h, double angle) const {
    const Halfedge& side = mesh_.halfedges[h];
    const Vec2 ray{std::cos(angle), std::sin(angle)};
    const Vec2 base{side.length, 0.0};
    const Vec2 far = side.apex - base;
    const double along = -cross(ray, base) / cross(ray, far);
    return std::clamp(along, 0.0, 1.0) * norm(far);
  }

  /// All that the start in its triangle sees there.
  void spread_in_triangle(const SurfacePlace& start) {
    constexpr Index kStart = 0;
    for (Index i = first_in_[start.triangle]; i != kNone; i = targets_[i].next) {
      reach_target(targets_[i], norm(targets_[i].place.at - start.at), kNone, kStart);
    }
    for (Index h = 3 * start.triangle; h < 3 * start.triangle + 3; ++h) {
      const Vec2 at = in_frame_of(mesh_, h, start.at);
      arrive(mesh_.tail(h), norm(at), mesh_.direction[h] + std::atan2(at.y, at.x), kNone, kStart);
    }
    for (Index h = 3 * start.triangle; h < 3 * start.triangle + 3; ++h) {
      const double length = mesh_.halfedges[h].length;
      const Vec2 at = in_frame_of(mesh_, h, start.at);
      const Vec2 source{length - at.x, std::min(0.0, -at.y)};
      add_window({0.0, length, source, 0.0, mesh_.opposite(h), kNone, kStart}, kNone, source, true);
    }
  }

  // ---- windows across a triangle ----

  void propagate(Index id) {
    const Window w = windows_[id];
    const Index h = w.halfedge;
    const Halfedge& edge = mesh_.halfedges[h];
    if (is_stale(roots_[w.root]) || is_dominated(w)) return;

    const Index left_side = previous_in_triangle(h);
    const Index right_side = next_in_triangle(h);
    const Index apex = mesh_.tail(left_side);
    lower_bound_at(apex,
                   std::min(bound_[edge.tail] + mesh_.halfedges[left_side].length,
                            bound_[mesh_.tail(right_side)] + mesh_.halfedges[right_side].length));

    const Vec2 to_left = Vec2{w.left, 0.0} - w.source;
    const Vec2 to_right = Vec2{w.right, 0.0} - w.source;
    const Vec2 to_apex = edge.apex - w.source;
    const double apex_distance = norm(to_apex);
    const double from_left = cross(to_left, to_apex);    // > 0: the apex is left of the left ray
    const double from_right = cross(to_right, to_apex);  // < 0: the apex is right of the right ray
    if (from_left <= kAngleSlack * norm(to_left) * apex_distance &&
        from_right >= -kAngleSlack * norm(to_right) * apex_distance) {
      const Vec2 down{-edge.apex.x, -edge.apex.y};
      const Vec2 back{-to_apex.x, -to_apex.y};
      const double turned = std::atan2(cross(down, back), dot(down, back));
      arrive(apex, w.offset + apex_distance, mesh_.direction[left_side] + turned, id, w.root);
    }
    for (Index i = first_in_[triangle_of(h)]; i != kNone; i = targets_[i].next) {
      const Vec2 to_target = in_frame_of(mesh_, h, targets_[i].place.at) - w.source;
      const double distance = norm(to_target);
      if (cross(to_left, to_target) <= kAngleSlack * norm(to_left) * distance &&
          cross(to_right, to_target) >= -kAngleSlack * norm(to_right) * distance) {
        reach_target(targets_[i], w.offset + distance, id, w.root);
      }
    }
    if (from_left < 0.0) add_left_child(id, w, to_left, to_right, from_right >= 0.0);
    if (from_right > 0.0) add_right_child(id, w, to_left, to_right, from_left <= 0.0);
  }

  /// The part of w's rays that leaves between the tail of its edge and the apex.
  void add_left_child(Index id, const Window& w, Vec2 to_left, Vec2 to_right, bool up_to_apex) {
    const Vec2 tip = mesh_.halfedges[w.halfedge].apex;
    const Index inner = previous_in_triangle(w.halfedge);
    const Halfedge& side = mesh_.halfedges[inner];
    const Vec2 axis{tip.x / side.length, tip.y / side.length};
    const auto position = [&](Vec2 ray) {
      return std::clamp(cross(ray, w.source) / cross(ray, axis), 0.0, side.length);
    };
    const double left = position(to_left);
    const double right = up_to_apex ? side.length : position(to_right);
    const Vec2 source{dot(w.source, axis), std::min(0.0, cross(axis, w.source))};
    const Vec2 third{side.length - side.apex.x, -side.apex.y};
    add_window({left, right, source, w.offset, side.opposite, id, w.root}, mesh_.head(w.halfedge),
               third, true);
  }

  /// The part of w's rays that leaves between the apex and the head of its edge.
  void add_right_child(Index id, const Window& w, Vec2 to_left, Vec2 to_right, bool from_apex) {
    const Vec2 tip = mesh_.halfedges[w.halfedge].apex;
    const Index inner = next_in_triangle(w.halfedge);
    const Halfedge& side = mesh_.halfedges[inner];
    const Vec2 down = Vec2{mesh_.halfedges[w.halfedge].length, 0.0} - tip;
    const Vec2 axis{down.x / side.length, down.y / side.length};
    const Vec2 below = w.source - tip;
    const auto position = [&](Vec2 ray) {
      return std::clamp(cross(ray, below) / cross(ray, axis), 0.0, side.length);
    };
    const double left = from_apex ? 0.0 : position(to_left);
    const double right = position(to_right);
    const Vec2 source{dot(below, axis), std::min(0.0, cross(axis, below))};
    const Vec2 third{side.length - side.apex.x, -side.apex.y};
    add_window({left, right, source, w.offset, side.opposite, id, w.root}, mesh_.tail(w.halfedge),
               third, false);
  }

  /// Keeps a new window unless it is empty or can't matter. `third` is the vertex of the triangle
  /// behind it that is not on its edge, at `third_place`; the rays leave it on their right if
  /// `third_is_right`.
  void add_window(const Window& w, Index third, Vec2 third_place, bool third_is_right) {
    const double length = mesh_.halfedges[w.halfedge].length;
    if (w.right - w.left <= 1e-13 * length) return;
    if (allowed_ != nullptr && (*allowed_)[triangle_of(w.halfedge)] == 0) return;
    const Vec2 nearest{std::clamp(w.source.x, w.left, w.right), 0.0};
    const double key = w.offset + norm(nearest - w.source);
    if (key > padded(reach_) || is_dominated(w)) return;
    if (pruning_.vertex_filters && third != kNone) {
      // The segment from the third vertex to the window's far end crosses all of its rays.
      const Vec2 end{third_is_right ? w.left : w.right, 0.0};
      if (padded(bound_[third] + norm(end - third_place)) < w.offset + norm(end - w.source)) return;
    }
    if (pruning_.ellipse && !matters(w)) return;
    const bool is_thin = mesh_.is_thin[triangle_of(w.halfedge)] != 0 ||
                         mesh_.is_thin[triangle_of(mesh_.opposite(w.halfedge))] != 0;
    met_thin_triangle_ = met_thin_triangle_ || is_thin;
    windows_.push_back(w);
    push(key, to_index(windows_.size() - 1));
  }

  /// Whether a path from an end of the window's edge along it is shorter at all of the window.
  bool is_dominated(const Window& w) const {
    if (!pruning_.vertex_filters) return false;
    const double length = mesh_.halfedges[w.halfedge].length;
    const double at_left = w.offset + norm(Vec2{w.left, 0.0} - w.source);
    const double at_right = w.offset + norm(Vec2{w.right, 0.0} - w.source);
    return padded(bound_[mesh_.tail(w.halfedge)] + w.right) < at_right ||
           padded(bound_[mesh_.head(w.halfedge)] + length - w.left) < at_left;
  }

  /// Whether a path through the window can still be as short as a target's bound: the target is
  /// at least its Euclidean distance away from any point of the window.
  bool matters(const Window& w) {
    const Vec3& tail = mesh_.points[mesh_.tail(w.halfedge)];
    const Vec3 axis =
        (mesh_.points[mesh_.head(w.halfedge)] - tail) * (1.0 / mesh_.halfedges[w.halfedge].length);
    if (last_keeper_ < targets_.size() && serves(w, tail, axis, targets_[last_keeper_]))
      return true;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      if (i != last_keeper_ && serves(w, tail, axis, targets_[i])) {
        last_keeper_ = i;
        return true;
      }
    }
    return false;
  }

  bool serves(const Window& w, const Vec3& tail, const Vec3& axis, const Target& target) const {
    // Turn the target about the edge's line until it lies flat beyond the edge: the shortest way
    // through the window is the straight one, or bends at an end.
    const Vec3 arm = target.place.position - tail;
    const Vec2 place{axis.dot(arm), axis.cross(arm).norm()};
    const double drop = place.y - w.source.y;
    const double straight =
        drop > 0.0 ? w.source.x - (place.x - w.source.x) * w.source.y / drop : w.source.x;
    const Vec2 through{std::clamp(straight, w.left, w.right), 0.0};
    return w.offset + norm(through - w.source) + norm(place - through) <= padded(target.bound);
  }

  const HalfedgeMesh& mesh_;
  PropagationPruning pruning_;
  double tolerance_;
  double bucket_width_;
  std::vector<double> bound_;     ///< one per vertex: length of some path from the start
  std::vector<Index> slot_of_;    ///< one per vertex: which target it is, or kNone
  std::vector<Index> first_in_;   ///< one per triangle: the first target in it, or kNone
  std::vector<Index> last_root_;  ///< one per vertex: the last root put there
  std::vector<Index> touched_;    ///< vertices with a bound
  std::vector<Window> windows_;
  std::vector<Root> roots_;
  std::vector<Target> targets_;
  std::vector<std::vector<Index>> buckets_;
  std::size_t current_bucket_ = 0;
  const std::vector<char>* allowed_ = nullptr;
  std::size_t last_keeper_ = 0;  ///< target that last kept a window
  bool met_thin_triangle_ = false;
  double reach_ = 0.0;  ///< no path longer than this matters
};

}  // namespace mgf
