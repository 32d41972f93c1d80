// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances from one point to a few others by propagating windows over the surface
// (Chen & Han 1990; filters of Xin & Wang 2009), bounded by what is known of the targets.
//
// A root is a point that paths start from: the start, or a saddle that they bend at. The shadow of
// a saddle is the part of its fan that a path may leave into with at least a half turn on both
// sides.
//
// A window is followed through triangle after triangle in the frame of its root, up to the end of
// the band of distances that the search has come to; what goes on beyond waits for its band. So
// saddles are left in the order of their distances, and what is in use at a time is small.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/landmarks.h"
#include "vcg_ext/geodesics/search_bands.h"
#include "vcg_ext/geodesics/search_bounds.h"
#include "vcg_ext/geodesics/search_targets.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/trail.h"
#include "vcg_ext/geodesics/unfolded_strip.h"
#include "vcg_ext/geodesics/window.h"

namespace mgf {

/// The workspace of window propagation on one mesh; one per thread. Memory: some numbers per vertex
/// and triangle, and what waits of the largest search.
class WindowPropagation {
 public:
  /// `landmarks`: on this mesh, or nullptr; they may be filled in between two searches.
  explicit WindowPropagation(const HalfedgeMesh& mesh, PropagationPruning pruning = {},
                             const Landmarks* landmarks = nullptr)
      : mesh_(mesh),
        pruning_(pruning),
        tolerance_(1e-10 * mesh.mean_edge),
        targets_(mesh, tolerance_, landmarks),
        bounds_(mesh, pruning, tolerance_, targets_),
        last_root_(mesh.vertex_count(), kNone),
        bands_(kBandWidth * mesh.mean_edge),
        most_windows_(
            std::min(kMostWindows, kSpareWindows + kWindowsPerTriangle * mesh.triangle_count())) {}

  WindowPropagation(const WindowPropagation&) = delete;  // its parts refer to each other
  WindowPropagation& operator=(const WindowPropagation&) = delete;

  /// Searches from `start` until every target's distance is certain, or certain to be beyond its
  /// limit; without targets, and without `PropagationPruning::ellipse`, until every vertex's is.
  /// Returns false if the search was given up for its size; lengths found are then only upper
  /// bounds.
  bool run(const SurfacePlace& start, const std::vector<PropagationTarget>& targets) {
    begin(targets);
    start_ = start;
    SearchRoot root;
    root.vertex = start.vertex;
    roots_.push_back(root);
    if (start.vertex != kNone) {
      bounds_.learn(start.vertex, 0.0);
      spread(0);
    } else {
      spread_in_triangle();
    }
    drain();
    return !is_given_up();
  }

  /// From now on keeps to the triangles t with allowed[t] != 0; nullptr allows all. What is found
  /// then is the shortest path among those in the triangles allowed.
  void keep_to(const std::vector<char>* allowed) { allowed_ = allowed; }

  /// From now on searches that need more windows than this are given up, too.
  void give_up_beyond(std::size_t count) { most_windows_ = std::min(most_windows_, count); }

  /// Length of some path from the last run's start to v; the distance, if that run was complete and
  /// had no targets. Infinity if it didn't come there.
  double vertex_bound(Index v) const { return bounds_.known(v); }

  /// Length of the path found to target i of the last run; infinity if there is none. No path is
  /// shorter than the lesser of that and the target's limit.
  double distance(std::size_t i) const { return targets_[i].distance; }

  /// The path to target i of the last run as straight pieces in order. Requires a finite distance.
  /// An end that is no vertex is kNone.
  std::vector<PathPiece> pieces(std::size_t i) const {
    std::vector<PathPiece> path;
    const SearchTargets::Target& target = targets_[i];
    path.push_back(piece_to(target.place, target.root, target.trail));
    for (Index root = target.root; roots_[root].parent != kNone; root = roots_[root].parent) {
      const SearchRoot& bend = roots_[root];
      path.push_back(piece_to(place_of_vertex(mesh_, bend.vertex), bend.parent, bend.trail));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// Whether the last run came through a triangle that is too thin to be certain of.
  bool met_thin_triangle() const { return met_thin_triangle_; }

  /// How many windows the last run followed across a triangle.
  std::size_t window_count() const { return window_count_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kAngleSlack = 1e-8;  ///< rounding of a ray's direction, made good at
                                               ///< second order: lengths err by its square
  /// A search that needs more windows ends as incomplete. Sound ones have about ten an edge; where
  /// rounding makes a heap of saddles of one point, there is no end to them.
  static constexpr std::size_t kMostWindows = std::size_t{1} << 24U;
  static constexpr std::size_t kSpareWindows = std::size_t{1} << 17U;
  static constexpr std::size_t kWindowsPerTriangle = 300;
  static constexpr double kBandWidth = 16.0;  ///< in mean edges
  /// A window that doesn't part is checked after so many triangles. Most pass, and a check takes as
  /// long as to go on by a triangle.
  static constexpr Index kCheckEvery = 4;

  void begin(const std::vector<PropagationTarget>& targets) {
    bounds_.clear();
    for (const SearchRoot& root : roots_) {
      if (root.vertex != kNone) last_root_[root.vertex] = kNone;
    }
    roots_.clear();
    trails_.clear();
    bands_.clear();
    targets_.assign(targets);
    for (const PropagationTarget& target : targets) {
      if (target.place.vertex != kNone) bounds_.learn(target.place.vertex, target.known);
    }
    met_thin_triangle_ = false;
    window_count_ = 0;
  }

  void drain() {
    do {
      for (Window& window : bands_.take_windows()) {
        if (is_stale(roots_[window.root])) continue;
        look_from(window.root);
        follow(window);
      }
      while (bands_.has_saddle()) leave_saddle(bands_.take_saddle());
    } while (!is_given_up() && bands_.advance());
  }

  bool is_given_up() const { return window_count_ > most_windows_; }

  /// Whether a shorter path to the root has turned up since.
  bool is_stale(const SearchRoot& root) const {
    return root.vertex != kNone && bounds_.is_detour(root.vertex, root.offset);
  }

  // ---- arrivals at vertices ----

  /// A path of length `distance` reaches v out of `root`, seen from v in the direction that
  /// `arrival()` says.
  template <class Direction>
  void arrive(Index v, double distance, Index root, const Trail& trail, const Direction& arrival) {
    bounds_.learn(v, distance);
    for (Index i = targets_.first_at_vertex(v); i != kNone; i = targets_[i].next) {
      targets_.arrive(i, distance, root, trail);
    }
    if (bounds_.is_detour(v, distance) || !mesh_.is_saddle(v) || distance > bounds_.rest(v)) return;
    bands_.put_off({distance, arrival(), v, root, trail});
  }

  /// Goes on from a saddle.
  void leave_saddle(const SearchRoot& saddle) {
    if (is_stale(saddle) || saddle.offset > bounds_.rest(saddle.vertex)) return;
    Index& last = last_root_[saddle.vertex];
    if (last != kNone && std::abs(roots_[last].arrival - saddle.arrival) < 1e-9 &&
        roots_[last].offset <= saddle.offset + tolerance_) {
      return;
    }
    last = to_index(roots_.size());
    roots_.push_back(saddle);
    spread(last);
  }

  // ---- windows out of a root ----

  void spread(Index root) {
    look_from(root);
    const SearchRoot at = roots_[root];
    const double turn = mesh_.total_angle[at.vertex];
    double from = 0.0;
    double to = turn;
    if (at.parent != kNone && pruning_.clip_shadows) {
      from = std::fmod(at.arrival + kPi - kAngleSlack, turn);
      to = from + turn - 2.0 * kPi + 2.0 * kAngleSlack;
    }
    const Row<Index> fan = mesh_.fans[at.vertex];
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Index h = fan[i];
      const double low = mesh_.direction[h];
      const double high = i + 1 < fan.size() ? mesh_.direction[fan[i + 1]] : turn;
      if (from <= high && to >= low) spread_into(root, h, high - low, from - low, to - low);
      if (to - turn >= low) spread_into(root, h, high - low, from - turn - low, to - turn - low);
    }
  }

  /// The part of the directions [from, to] from h that lies in the corner, `corner` wide, at the
  /// tail of h.
  void spread_into(Index root, Index h, double corner, double from, double to) {
    const double low = std::max(from, 0.0);
    const double high = std::min(to, corner);
    if (low > high) return;
    const Halfedge& edge = mesh_.halfedges[h];
    if (low <= 0.0) {  // along the edge itself
      arrive(mesh_.head(h), offset_ + edge.length, root, {},
             [&] { return mesh_.direction[mesh_.opposite(h)]; });
    }
    for (Index i = targets_.first_in_triangle(triangle_of(h)); i != kNone; i = targets_[i].next) {
      const Vec2 place = in_frame_of(mesh_, h, targets_[i].place.at);
      const double angle = std::atan2(place.y, place.x);
      if (angle >= low - kAngleSlack && angle <= high + kAngleSlack) {
        targets_.arrive(i, offset_ + norm(place), root, {});
      }
    }
    const Vec2 left_ray = high < corner ? Vec2{std::cos(high), std::sin(high)} : edge.apex;
    const Vec2 right_ray = low > 0.0 ? Vec2{std::cos(low), std::sin(low)} : Vec2{edge.length, 0.0};
    met_thin_triangle_ |= mesh_.crossings[h].is_thin;
    open_window(root, mesh_.crossings[h].beyond[kRight], left_ray, right_ray);
  }

  /// All that the start in its triangle sees there.
  void spread_in_triangle() {
    constexpr Index kStart = 0;
    look_from(kStart);
    for (Index i = targets_.first_in_triangle(start_.triangle); i != kNone; i = targets_[i].next) {
      targets_.arrive(i, norm(targets_[i].place.at - start_.at), kStart, {});
    }
    for (Index h = 3 * start_.triangle; h < 3 * start_.triangle + 3; ++h) {
      const Vec2 at = in_frame_of(mesh_, h, start_.at);
      arrive(mesh_.tail(h), norm(at), kStart, {},
             [&] { return mesh_.direction[h] + std::atan2(at.y, at.x); });
      met_thin_triangle_ |= mesh_.crossings[h].is_thin;
    }
    for (Index h = 3 * start_.triangle; h < 3 * start_.triangle + 3; ++h) {
      const Index first = mesh_.opposite(h);
      const EdgePlaces edge = places_of_first(kStart, first);
      open_window(kStart, first, edge.tail, edge.head);
    }
  }

  /// The paths of a root through its first edge, between two rays.
  void open_window(Index root, Index first, Vec2 left_ray, Vec2 right_ray) {
    Window w;
    w.left_ray = left_ray;
    w.right_ray = right_ray;
    w.trail.first = first;
    w.halfedge = first;
    w.root = root;
    const EdgePlaces edge = places_of_first(root, first);
    set_corner(mesh_.tail(first), edge.tail, cross(left_ray, edge.tail),
               cross(right_ray, edge.tail), w.ends[Window::kTail]);
    set_corner(mesh_.head(first), edge.head, cross(left_ray, edge.head),
               cross(right_ray, edge.head), w.ends[Window::kHead]);
    if (is_useful(w)) follow(w);
  }

  /// Where the first edge behind a root lies in its frame.
  EdgePlaces places_of_first(Index root, Index first) const {
    return roots_[root].vertex != kNone ? places_from_vertex(mesh_, first)
                                        : places_from_triangle(mesh_, first, start_);
  }

  // ---- windows across triangles ----

  /// Written in place: to copy what was just written stalls the processor.
  void set_corner(Index v, Vec2 place, double past_left, double past_right,
                  UnfoldedCorner& corner) {
    corner.place.x = place.x;
    corner.place.y = place.y;
    corner.past_left = past_left;
    corner.past_right = past_right;
    corner.vertex = v;
  }

  /// Follows a window, and what parts from it, to the end of the band.
  void follow(Window& w) {
    while (true) {
      while (cross_triangle(w)) {
      }
      if (parted_.empty()) return;
      w = parted_.back();
      parted_.pop_back();
    }
  }

  /// Looks from a root from now on.
  void look_from(Index root) {
    offset_ = roots_[root].offset;
    horizon_square_ = signed_square(bands_.end() - offset_);
  }

  /// Carries a window on across its triangle. Returns whether to go on with it; if it parts, its
  /// right half goes to `parted_`.
  bool cross_triangle(Window& w) {
    if (++window_count_ > most_windows_) return false;
    const Crossing& crossing = mesh_.crossings[w.halfedge];
    if (allowed_ != nullptr && (*allowed_)[triangle_of(w.halfedge)] == 0) return false;
    met_thin_triangle_ |= crossing.is_thin;
    if (targets_.has_any_in_triangles()) look_for_targets(w);

    const Vec2 apex = w.apex_place(crossing);
    const double past_left = cross(w.left_ray, apex);
    const double past_right = cross(w.right_ray, apex);
    // Which side to take is as good as random: no branch for it.
    if (std::max(past_left, -past_right) < 0.0) {
      arrive_at(apex, crossing, w);
      return part(w, crossing, apex, past_left, past_right);
    }
    if (is_among_rays(w, apex, past_left, past_right)) arrive_at(apex, crossing, w);
    const Side side = past_left >= 0.0 ? kRight : kLeft;
    // The rays pass between the apex and the end on that side; it replaces the other.
    set_corner(crossing.apex, apex, past_left, past_right, w.ends[1 - side]);
    w.halfedge = crossing.beyond[side];
    trails_.turn(side, w.trail);
    return w.trail.count % kCheckEvery != 0 || is_useful(w);
  }

  /// The apex lies between the rays: some pass it on the left, some on the right.
  bool part(Window& w, const Crossing& crossing, Vec2 apex, double past_left, double past_right) {
    parted_.push_back(w);
    Window& right = parted_.back();
    right.left_ray = apex;
    right.ends[Window::kHead].past_left = cross(apex, w.ends[Window::kHead].place);
    set_corner(crossing.apex, apex, 0.0, past_right, right.ends[Window::kTail]);
    right.halfedge = crossing.beyond[kRight];
    trails_.turn(kRight, right.trail);
    if (!is_useful(right)) parted_.pop_back();

    w.right_ray = apex;
    w.ends[Window::kTail].past_right = cross(apex, w.ends[Window::kTail].place);
    set_corner(crossing.apex, apex, past_left, 0.0, w.ends[Window::kHead]);
    w.halfedge = crossing.beyond[kLeft];
    trails_.turn(kLeft, w.trail);
    return is_useful(w);
  }

  /// A window sees the apex of its triangle.
  void arrive_at(Vec2 apex, const Crossing& crossing, const Window& w) {
    arrive(crossing.apex, offset_ + norm(apex), w.root, w.trail, [&] {
      const Vec2 down = w.ends[Window::kTail].place - apex;
      const Vec2 back = -apex;
      return mesh_.direction[mesh_.opposite(crossing.beyond[kLeft])] +
             std::atan2(cross(down, back), dot(down, back));
    });
  }

  /// Whether a place is among the rays, or beside them by less than the slack; `past_left` and
  /// `past_right` are its cross products with them.
  static bool is_among_rays(const Window& w, Vec2 place, double past_left, double past_right) {
    const auto size = [](Vec2 p) { return std::abs(p.x) + std::abs(p.y); };
    const double slack = kAngleSlack * size(place);
    return std::max(past_left - slack * size(w.left_ray),
                    -past_right - slack * size(w.right_ray)) <= 0.0;
  }

  /// What the window sees of the targets in its triangle.
  void look_for_targets(const Window& w) {
    for (Index i = targets_.first_in_triangle(triangle_of(w.halfedge)); i != kNone;
         i = targets_[i].next) {
      const EdgePlaces edge{w.ends[Window::kTail].place, w.ends[Window::kHead].place};
      const Vec2 place = place_behind(mesh_, w.halfedge, edge, targets_[i].place);
      if (is_among_rays(w, place, cross(w.left_ray, place), cross(w.right_ray, place))) {
        targets_.arrive(i, offset_ + norm(place), w.root, w.trail);
      }
    }
  }

  /// Whether a window can still matter; if only later, it is put to wait, and the answer is no.
  bool is_useful(const Window& w) {
    const WindowInterval interval(w);
    if (interval.right - interval.left <= 1e-13) return false;
    if (!bounds_.can_matter(w, interval, offset_)) return false;
    const double nearest_square = std::min(interval.left_square, interval.right_square);
    if (!(nearest_square > horizon_square_)) return true;
    const double width = (interval.right - interval.left) * interval.length;
    const double nearest = offset_ + std::sqrt(nearest_square) - 0.5 * width;
    if (nearest <= targets_.reach() && !bands_.put_off(w, nearest)) {
      window_count_ = most_windows_ + 1;  // given up
    }
    return false;
  }

  // ---- paths ----

  /// The straight piece from a root along a trail to a place.
  PathPiece piece_to(const SurfacePlace& place, Index root, const Trail& trail) const {
    PathPiece piece;
    piece.from = roots_[root].vertex;
    piece.to = place.vertex;
    if (trail.first == kNone) return piece;
    piece.crossed = trails_.crossed(mesh_, trail);
    piece.points =
        points_of_straight_way(mesh_, piece.crossed, places_of_first(root, trail.first), place);
    return piece;
  }

  const HalfedgeMesh& mesh_;
  PropagationPruning pruning_;
  double tolerance_;  ///< lengths that differ by less are the same
  SearchTargets targets_;
  SearchBounds bounds_;
  std::vector<Index> last_root_;  ///< one per vertex: the last root put there, or kNone
  SurfacePlace start_;
  std::vector<SearchRoot> roots_;
  SearchBands bands_;
  TrailStore trails_;
  double offset_ = 0.0;          ///< of the root whose windows are followed
  double horizon_square_ = 0.0;  ///< how far from it the band reaches, signed, squared
  std::vector<Window> parted_;   ///< windows of that root still to be followed
  std::size_t window_count_ = 0;
  std::size_t most_windows_;
  const std::vector<char>* allowed_ = nullptr;
  bool met_thin_triangle_ = false;
};

}  // namespace mgf
