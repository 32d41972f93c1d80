// SPDX-License-Identifier: GPL-3.0-or-later
// A window: a bundle of straight paths through an interval of an edge, and what becomes of it in
// the triangle behind the edge (Chen & Han 1990).
#pragma once

#include <algorithm>
#include <cmath>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// The interval [left, right] of a directed edge, in the edge's frame, through which straight paths
/// from `source` (below the edge, y <= 0) enter its triangle. `offset` is the distance at which
/// that source itself lies from where the search started.
struct Window {
  double left = 0.0;
  double right = 0.0;
  double left_distance = 0.0;   ///< from the search's start to the interval's left end
  double right_distance = 0.0;  ///< the same to its right end
  Vec2 source;
  double offset = 0.0;
  Index halfedge = kNone;
  Index parent = kNone;  ///< the window it came through, or kNone at its root
  Index root = kNone;    ///< which source it comes from

  Vec2 to_left() const { return {left - source.x, -source.y}; }
  Vec2 to_right() const { return {right - source.x, -source.y}; }

  /// The distance of the interval's nearest point.
  double nearest() const {
    if (source.x <= left) return left_distance;
    if (source.x >= right) return right_distance;
    return offset - source.y;
  }

  /// Where on the edge the ray to `aim`, a point of the triangle, passes.
  double passage_to(Vec2 aim) const {
    const double height = aim.y - source.y;
    const double x = height > 0.0 ? source.x - (aim.x - source.x) * (source.y / height) : aim.x;
    return std::clamp(x, left, right);
  }

  /// Sets the distances of the ends from the rest.
  void measure_ends() {
    left_distance = offset + norm(to_left());
    right_distance = offset + norm(to_right());
  }
};

/// How a window's rays part at the apex of the triangle that they enter.
class WindowCrossing {
 public:
  WindowCrossing(const HalfedgeMesh& mesh, const Window& window)
      : mesh_(mesh),
        window_(window),
        to_left_(window.to_left()),
        to_right_(window.to_right()),
        apex_(mesh.halfedges[window.halfedge].apex),
        to_apex_(apex_ - window.source),
        apex_distance_(norm(to_apex_)),
        from_left_(cross(to_left_, to_apex_)),
        from_right_(cross(to_right_, to_apex_)) {}

  /// Whether the apex is among the rays, or beside them by less than `slack` radians.
  bool sees_apex(double slack) const { return is_among_rays(to_apex_, apex_distance_, slack); }
  /// The same for any point of the triangle, given in the frame of the window's edge.
  bool sees(Vec2 point, double slack, double& distance) const {
    const Vec2 arm = point - window_.source;
    distance = norm(arm);
    return is_among_rays(arm, distance, slack);
  }
  double apex_distance() const { return window_.offset + apex_distance_; }

  /// The angle at the apex from the side that ends in the edge's tail to the ray that arrives.
  double arrival_at_apex() const {
    const Vec2 down{-apex_.x, -apex_.y};
    const Vec2 back{-to_apex_.x, -to_apex_.y};
    return std::atan2(cross(down, back), dot(down, back));
  }

  /// Whether rays leave between the tail of the edge and the apex.
  bool has_left_child() const { return from_left_ < 0.0; }
  /// Whether rays leave between the apex and the head of the edge.
  bool has_right_child() const { return from_right_ > 0.0; }

  /// Makes `child` the window of the rays that leave on the left; `id` is the number of this one.
  void make_left_child(Index id, Window& child) const {
    const Halfedge& side = mesh_.halfedges[previous_in_triangle(window_.halfedge)];
    const double scale = 1.0 / side.length;
    const Vec2 axis{apex_.x * scale, apex_.y * scale};
    make_child(id, side, axis, window_.source, true, from_right_ >= 0.0, child);
  }

  /// The same on the right.
  void make_right_child(Index id, Window& child) const {
    const Halfedge& side = mesh_.halfedges[next_in_triangle(window_.halfedge)];
    const Vec2 down = Vec2{mesh_.halfedges[window_.halfedge].length, 0.0} - apex_;
    const double scale = 1.0 / side.length;
    const Vec2 axis{down.x * scale, down.y * scale};
    make_child(id, side, axis, window_.source - apex_, false, from_left_ <= 0.0, child);
  }

 private:
  bool is_among_rays(Vec2 arm, double distance, double slack) const {
    const double left_length = window_.left_distance - window_.offset;
    const double right_length = window_.right_distance - window_.offset;
    return cross(to_left_, arm) <= slack * left_length * distance &&
           cross(to_right_, arm) >= -slack * right_length * distance;
  }

  /// The rays through `side`, which runs along `axis` as seen from its start, where the source lies
  /// at `source`; up to the apex on one end if the apex is among them.
  void make_child(Index id, const Halfedge& side, Vec2 axis, Vec2 source, bool is_left,
                  bool has_apex, Window& w) const {
    const auto position = [&](Vec2 ray) {
      return std::clamp(cross(ray, source) / cross(ray, axis), 0.0, side.length);
    };
    w.left = !is_left && has_apex ? 0.0 : position(to_left_);
    w.right = is_left && has_apex ? side.length : position(to_right_);
    w.source = {dot(source, axis), std::min(0.0, cross(axis, source))};
    w.offset = window_.offset;
    w.left_distance = !is_left && has_apex ? apex_distance() : w.offset + norm(w.to_left());
    w.right_distance = is_left && has_apex ? apex_distance() : w.offset + norm(w.to_right());
    w.halfedge = side.opposite;
    w.parent = id;
    w.root = window_.root;
  }

  const HalfedgeMesh& mesh_;
  const Window& window_;
  Vec2 to_left_, to_right_;
  Vec2 apex_, to_apex_;
  double apex_distance_;
  double from_left_;   ///< > 0: the apex is left of the left ray
  double from_right_;  ///< < 0: the apex is right of the right ray
};

}  // namespace mgf
