// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances from one point to a few others by propagating windows over the surface
// (Chen & Han 1990; filters of Xin & Wang 2009), bounded by what is known of the targets.
//
// A root is a point that paths start from: the start, or a saddle that they bend at. The shadow of
// a saddle is the part of its fan that a path may leave into with at least a half turn on both
// sides.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/bucket_queue.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/landmarks.h"
#include "vcg_ext/geodesics/search_targets.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/window.h"

namespace mgf {

/// Which of the searches' shortcuts are taken. The answer is the same with any of them.
struct PropagationPruning {
  bool vertex_filters = true;  ///< drop windows that a vertex nearby serves better
  bool clip_shadows = true;    ///< clip what leaves a saddle to its shadow
  bool ellipse = true;         ///< drop windows too far off to matter to any target
};

/// The workspace of window propagation on one mesh; one per thread. Memory grows with the number
/// of windows of the largest search, 2^24 at most.
class WindowPropagation {
 public:
  /// `landmarks`: on this mesh, or nullptr; they may be filled in between two searches.
  explicit WindowPropagation(const HalfedgeMesh& mesh, PropagationPruning pruning = {},
                             const Landmarks* landmarks = nullptr)
      : mesh_(mesh),
        pruning_(pruning),
        tolerance_(1e-10 * mesh.mean_edge),
        targets_(mesh, tolerance_, landmarks),
        queue_(0.5 * mesh.mean_edge),
        states_(mesh.vertex_count()),
        most_windows_(
            std::min(kMostWindows, kSpareWindows + kWindowsPerTriangle * mesh.triangle_count())) {}

  /// Searches from `start` until every target's distance is certain, or certain to be beyond its
  /// limit; without targets, and without `PropagationPruning::ellipse`, until every vertex's is.
  /// Returns false if the search was given up for its size; lengths found are then only upper
  /// bounds.
  bool run(const SurfacePlace& start, const std::vector<PropagationTarget>& targets) {
    begin(targets);
    if (start.vertex != kNone) {
      add_root(start.vertex, 0.0, kNone, kNone, 0.0);
    } else {
      roots_.push_back({0.0, 0.0, kNone, kNone, kNone});
      spread_in_triangle(start);
    }
    return drain();
  }

  /// From now on keeps to the triangles t with allowed[t] != 0; nullptr allows all. What is found
  /// then is the shortest path among those in the triangles allowed.
  void keep_to(const std::vector<char>* allowed) { allowed_ = allowed; }

  /// From now on searches that need more windows than this are given up, too.
  void give_up_beyond(std::size_t count) { most_windows_ = std::min(most_windows_, count); }

  /// Length of some path from the last run's start to v; the distance, if that run was complete and
  /// had no targets. Infinity if it didn't come there.
  double vertex_bound(Index v) const { return states_[v].bound; }

  /// Length of the path found to target i of the last run; infinity if there is none. No path is
  /// shorter than the lesser of that and the target's limit.
  double distance(std::size_t i) const { return targets_[i].distance; }

  /// The path to target i of the last run as straight pieces in order. Requires a finite distance.
  /// An end that is no vertex is kNone.
  std::vector<PathPiece> pieces(std::size_t i) const {
    std::vector<PathPiece> path;
    const SurfacePlace& target = targets_[i].place;
    Index vertex = target.vertex;
    Index window = targets_[i].window;
    Index root = targets_[i].root;
    while (true) {
      PathPiece piece;
      piece.from = roots_[root].vertex;
      piece.to = vertex;
      if (window != kNone) {
        const Index last = windows_[window].halfedge;
        trace_back(
            window,
            vertex != kNone ? mesh_.halfedges[last].apex : in_frame_of(mesh_, last, target.at),
            piece);
      }
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
  /// A search that needs more windows ends as incomplete. Sound ones have about ten an edge; where
  /// rounding makes a heap of saddles of one point, there is no end to them.
  static constexpr std::size_t kMostWindows = std::size_t{1} << 24U;
  static constexpr std::size_t kSpareWindows = std::size_t{1} << 17U;
  static constexpr std::size_t kWindowsPerTriangle = 300;

  struct Root {
    double offset;
    double arrival;  ///< direction to where the path came from, about the vertex
    Index vertex, parent_window, parent_root;
  };
  /// A directed edge as its windows need it.
  struct Edge {
    Index tail, head;
    double length;
  };
  /// What the search knows of a vertex.
  struct VertexState {
    double bound = kInfinity;  ///< length of some path from the start
    double rest = kInfinity;   ///< see SearchTargets::rest; infinity if not yet asked
    Index last_root = kNone;   ///< the last root put there
  };

  /// Adds the edges that the straight way through a window to `aim`, in its edge's frame, has
  /// crossed.
  void trace_back(Index window, Vec2 aim, PathPiece& piece) const {
    for (Index id = window; id != kNone; id = windows_[id].parent) {
      const Window& w = windows_[id];
      const double share = w.passage_to(aim) / mesh_.halfedges[w.halfedge].length;
      piece.crossed.push_back(w.halfedge);
      piece.points.push_back(mesh_.points[mesh_.tail(w.halfedge)] * (1.0 - share) +
                             mesh_.points[mesh_.head(w.halfedge)] * share);
      if (w.parent == kNone) break;
      // That point, as the window before it sees it, on one of the far sides of its triangle.
      const Index before = windows_[w.parent].halfedge;
      const Halfedge& edge = mesh_.halfedges[before];
      const bool is_right = mesh_.opposite(w.halfedge) == next_in_triangle(before);
      const Vec2 tail = is_right ? edge.apex : Vec2{0.0, 0.0};
      const Vec2 head = is_right ? Vec2{edge.length, 0.0} : edge.apex;
      aim = {tail.x + (head.x - tail.x) * share, tail.y + (head.y - tail.y) * share};
    }
    std::reverse(piece.crossed.begin(), piece.crossed.end());
    std::reverse(piece.points.begin(), piece.points.end());
  }

  double padded(double bound) const { return bound + tolerance_; }

  void begin(const std::vector<PropagationTarget>& targets) {
    for (const Index v : touched_) states_[v] = {};
    touched_.clear();
    queue_.clear();
    windows_.clear();
    roots_.clear();
    targets_.assign(targets);
    for (const PropagationTarget& target : targets) {
      if (target.place.vertex != kNone) lower_bound_at(target.place.vertex, target.known);
    }
    met_thin_triangle_ = false;
  }

  /// The longest that a path to v may be and still matter.
  double rest_at(Index v) {
    double& rest = states_[v].rest;
    if (rest == kInfinity) {
      rest = targets_.rest(v);
      touched_.push_back(v);
    }
    return rest;
  }

  void lower_bound_at(Index v, double distance) {
    double& bound = states_[v].bound;
    if (distance >= bound) return;
    if (bound == kInfinity) touched_.push_back(v);
    bound = distance;
  }

  bool drain() {
    for (Index entry = queue_.pop(targets_.reach()); entry != kNone;
         entry = queue_.pop(targets_.reach())) {
      if ((entry & kRootFlag) != 0) {
        spread(entry & ~kRootFlag);
      } else {
        propagate(entry);
      }
      if (windows_.size() > most_windows_) return false;
    }
    return true;
  }

  // ---- arrivals at vertices ----

  /// A path of length `distance` reaches v, seen from v in the direction that `arrival()` says.
  template <class Direction>
  void arrive(Index v, double distance, Index window, Index root, const Direction& arrival) {
    lower_bound_at(v, distance);
    for (Index i = targets_.first_at_vertex(v); i != kNone; i = targets_[i].next) {
      targets_.arrive(i, distance, window, root);
    }
    if (distance > padded(states_[v].bound) || !mesh_.is_saddle(v)) return;
    const double direction = arrival();
    const Index last = states_[v].last_root;
    if (last != kNone && roots_[last].offset <= padded(distance) &&
        std::abs(roots_[last].arrival - direction) < 1e-9) {
      return;
    }
    add_root(v, distance, window, root, direction);
  }

  /// Whether a shorter path to the root has turned up since.
  bool is_stale(const Root& root) const {
    return root.vertex != kNone && root.offset > padded(states_[root.vertex].bound);
  }

  void add_root(Index v, double offset, Index window, Index root, double arrival) {
    if (root != kNone && pruning_.ellipse && offset > rest_at(v)) return;
    const Index added = to_index(roots_.size());
    roots_.push_back({offset, arrival, v, window, root});
    lower_bound_at(v, offset);
    states_[v].last_root = added;
    if (offset <= targets_.reach()) queue_.push(offset, added | kRootFlag);
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
      const Index next = mesh_.rotated(h);
      const double corner = (next == first ? turn : mesh_.direction[next]) - mesh_.direction[h];
      spread_into(root, h, corner, from, width);
      spread_into(root, h, corner, from - turn, width);
      h = next;
    } while (h != first);
  }

  /// The part of the directions [from, from + width] that lies in the corner, `corner` wide, at the
  /// tail of h.
  void spread_into(Index root, Index h, double corner, double from, double width) {
    const double low = std::max(from - mesh_.direction[h], 0.0);
    const double high = std::min(from + width - mesh_.direction[h], corner);
    if (low > high) return;
    const double offset = roots_[root].offset;
    if (low <= 0.0) {  // along the edge itself
      arrive(mesh_.head(h), offset + mesh_.halfedges[h].length, kNone, root,
             [&] { return mesh_.direction[mesh_.opposite(h)]; });
    }
    for (Index i = targets_.first_in_triangle(triangle_of(h)); i != kNone; i = targets_[i].next) {
      const Vec2 place = in_frame_of(mesh_, h, targets_[i].place.at);
      const double angle = std::atan2(place.y, place.x);
      if (angle >= low - kAngleSlack && angle <= high + kAngleSlack) {
        targets_.arrive(i, offset + norm(place), kNone, root);
      }
    }
    const Index far = next_in_triangle(h);
    const Halfedge& side = mesh_.halfedges[far];
    Window w;
    w.left = high >= corner ? 0.0 : side.length - opposite_position(h, high);
    w.right = low <= 0.0 ? side.length : side.length - opposite_position(h, low);
    w.source = {side.length - side.apex.x, -side.apex.y};
    w.offset = offset;
    w.halfedge = side.opposite;
    w.root = root;
    w.measure_ends();
    note_triangle(far);
    add_window(w, {mesh_.head(far), side.tail, side.length});
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
    for (Index i = targets_.first_in_triangle(start.triangle); i != kNone; i = targets_[i].next) {
      targets_.arrive(i, norm(targets_[i].place.at - start.at), kNone, kStart);
    }
    for (Index h = 3 * start.triangle; h < 3 * start.triangle + 3; ++h) {
      const Vec2 at = in_frame_of(mesh_, h, start.at);
      arrive(mesh_.tail(h), norm(at), kNone, kStart,
             [&] { return mesh_.direction[h] + std::atan2(at.y, at.x); });
    }
    for (Index h = 3 * start.triangle; h < 3 * start.triangle + 3; ++h) {
      const Vec2 at = in_frame_of(mesh_, h, start.at);
      Window w;
      w.right = mesh_.halfedges[h].length;
      w.source = {w.right - at.x, std::min(0.0, -at.y)};
      w.halfedge = mesh_.opposite(h);
      w.root = kStart;
      w.measure_ends();
      note_triangle(h);
      add_window(w, {mesh_.head(h), mesh_.tail(h), w.right});
    }
  }

  // ---- windows across a triangle ----

  void note_triangle(Index h) {
    met_thin_triangle_ = met_thin_triangle_ || mesh_.is_thin[triangle_of(h)] != 0;
  }

  void propagate(Index id) {
    make_room(2);  // for the children, so that w stays where it is
    const Window& w = windows_[id];
    const Index h = w.halfedge;
    const Index left_side = previous_in_triangle(h);
    const Index right_side = next_in_triangle(h);
    const Index tail = mesh_.tail(h);
    const Index head = mesh_.tail(right_side);
    const Index apex = mesh_.tail(left_side);
    const Edge edge{tail, head, mesh_.halfedges[h].length};
    if (is_stale(roots_[w.root]) || is_dominated(w, edge)) return;
    note_triangle(h);
    lower_bound_at(apex, std::min(states_[tail].bound + mesh_.halfedges[left_side].length,
                                  states_[head].bound + mesh_.halfedges[right_side].length));

    const WindowCrossing crossing(mesh_, w);
    if (crossing.sees_apex(kAngleSlack)) {
      arrive(apex, crossing.apex_distance(), id, w.root,
             [&] { return mesh_.direction[left_side] + crossing.arrival_at_apex(); });
    }
    for (Index i = targets_.first_in_triangle(triangle_of(h)); i != kNone; i = targets_[i].next) {
      double distance = 0.0;
      if (crossing.sees(in_frame_of(mesh_, h, targets_[i].place.at), kAngleSlack, distance)) {
        targets_.arrive(i, w.offset + distance, id, w.root);
      }
    }
    // Each child's third vertex is the end of the old edge that is not its own. Children are made
    // in place: to copy what was just written stalls the processor.
    if (crossing.has_left_child()) {
      const Halfedge& side = mesh_.halfedges[left_side];
      crossing.make_left_child(id, windows_.emplace_back());
      settle_last({tail, apex, side.length}, head, {side.length - side.apex.x, -side.apex.y}, true);
    }
    if (crossing.has_right_child()) {
      const Halfedge& side = mesh_.halfedges[right_side];
      crossing.make_right_child(id, windows_.emplace_back());
      settle_last({apex, head, side.length}, tail, {side.length - side.apex.x, -side.apex.y},
                  false);
    }
  }

  void make_room(std::size_t count) {
    if (windows_.capacity() - windows_.size() < count)
      windows_.reserve(2 * windows_.size() + count);
  }

  /// A window out of a root.
  void add_window(const Window& w, const Edge& edge) {
    windows_.push_back(w);
    settle_last(edge, kNone, {}, true);
  }

  /// Queues the last window, or removes it if it is empty or can't matter. `third` is the vertex of
  /// the triangle before it that is not on its edge (kNone at a root), at `third_place`; the rays
  /// leave it on their right if `third_is_right`.
  void settle_last(const Edge& edge, Index third, Vec2 third_place, bool third_is_right) {
    const Window& w = windows_.back();
    const double key = w.nearest();
    if (key <= targets_.reach() && is_useful(w, edge, third, third_place, third_is_right)) {
      queue_.push(key, to_index(windows_.size() - 1));
    } else {
      windows_.pop_back();
    }
  }

  bool is_useful(const Window& w, const Edge& edge, Index third, Vec2 third_place,
                 bool third_is_right) {
    if (w.right - w.left <= 1e-13 * edge.length) return false;
    if (allowed_ != nullptr && (*allowed_)[triangle_of(w.halfedge)] == 0) return false;
    if (is_dominated(w, edge)) return false;
    if (pruning_.vertex_filters && third != kNone) {
      // The segment from the third vertex to the window's far end crosses all of its rays.
      const Vec2 way = Vec2{third_is_right ? w.left : w.right, 0.0} - third_place;
      const double rest =
          (third_is_right ? w.left_distance : w.right_distance) - padded(states_[third].bound);
      if (rest > 0.0 && dot(way, way) < rest * rest) return false;
    }
    return !pruning_.ellipse || matters(w, edge);
  }

  /// Whether a path through w can still matter. At its ends, vertices tell for most windows: what
  /// is left from a point differs by no more than the way there.
  bool matters(const Window& w, const Edge& edge) {
    const double tail_rest = rest_at(edge.tail);
    const double head_rest = rest_at(edge.head);
    const double left_rest = edge.length - w.left;
    if (w.left_distance + w.left <= tail_rest ||
        w.right_distance + edge.length - w.right <= head_rest) {
      return true;
    }
    if (w.right_distance - w.right > tail_rest || w.left_distance - left_rest > head_rest) {
      return false;
    }
    return targets_.matters(w);
  }

  /// Whether a path from an end of the window's edge along it is shorter at all of the window.
  bool is_dominated(const Window& w, const Edge& edge) const {
    if (!pruning_.vertex_filters) return false;
    return padded(states_[edge.tail].bound + w.right) < w.right_distance ||
           padded(states_[edge.head].bound + edge.length - w.left) < w.left_distance;
  }

  const HalfedgeMesh& mesh_;
  PropagationPruning pruning_;
  double tolerance_;  ///< lengths that differ by less are the same
  SearchTargets targets_;
  BucketQueue queue_;                ///< of windows and, with kRootFlag, roots
  std::vector<VertexState> states_;  ///< one per vertex
  std::vector<Index> touched_;       ///< vertices with a bound
  std::vector<Window> windows_;
  std::vector<Root> roots_;
  std::size_t most_windows_;
  const std::vector<char>* allowed_ = nullptr;
  bool met_thin_triangle_ = false;
};

}  // namespace mgf
