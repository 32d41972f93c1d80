// SPDX-License-Identifier: GPL-3.0-or-later
// A window: a bundle of straight paths through an interval of an edge (Chen & Han 1990).
//
// Windows are kept in the frame of the root that their paths start from. There a strip of triangles
// laid flat is no more than its corners, the rays that bound the bundle never change, and nothing
// has to be intersected to go on: the apex of the next triangle lies beside the rays, and one
// corner is replaced by it, or between them, and the bundle parts.
#pragma once

#include <array>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/trail.h"

namespace mgf {

/// A vertex where the root sees it.
struct UnfoldedCorner {
  Vec2 place;
  double past_left = 0.0;   ///< cross product with the left ray: > 0 to the left of it
  double past_right = 0.0;  ///< the same with the right ray
  Index vertex = kNone;
};

/// Straight paths from the root at the origin, between two rays, through a directed edge into its
/// triangle. Looking along them, the edge's tail is on the left.
struct Window {
  enum End { kTail = 0, kHead = 1 };

  std::array<UnfoldedCorner, 2> ends;
  Vec2 left_ray;
  Vec2 right_ray;
  Trail trail;
  Index halfedge = kNone;
  Index root = kNone;

  Vec2 apex_place(const Crossing& crossing) const {
    return place_beside(ends[kTail].place, ends[kHead].place, crossing.along, crossing.across);
  }
};

/// The part of a window's edge between its rays: where that starts and ends, in shares of the edge
/// from its tail, and as seen from the root.
struct WindowInterval {
  explicit WindowInterval(const Window& window) {
    const UnfoldedCorner& tail = window.ends[Window::kTail];
    const UnfoldedCorner& head = window.ends[Window::kHead];
    length = norm(head.place - tail.place);
    left = tail.past_left / (tail.past_left - head.past_left);
    right = tail.past_right / (tail.past_right - head.past_right);
    left_place = point_between(tail.place, head.place, left);
    right_place = point_between(tail.place, head.place, right);
    left_square = dot(left_place, left_place);
    right_square = dot(right_place, right_place);
  }

  double length;  ///< of the edge
  double left, right;
  Vec2 left_place, right_place;
  double left_square, right_square;  ///< squared distances from the root
};

}  // namespace mgf
