// SPDX-License-Identifier: GPL-3.0-or-later
// A strip of triangles laid flat before the root of a straight path, which lies at the origin.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/surface_place.h"

namespace mgf {

/// Where the ends of a directed edge lie. Seen from the root, the tail is on the left.
struct EdgePlaces {
  Vec2 tail, head;
};

/// The edge `first`, opposite a vertex, as that sees it. In the vertex's frame the edge that comes
/// before the corner in its fan runs along the x axis.
inline EdgePlaces places_from_vertex(const HalfedgeMesh& mesh, Index first) {
  const Halfedge& base = mesh.halfedges[previous_in_triangle(mesh.opposite(first))];
  return {base.apex, {base.length, 0.0}};
}

/// The edge `first` as a point of the triangle before it sees it.
inline EdgePlaces places_from_triangle(const HalfedgeMesh& mesh, Index first,
                                       const SurfacePlace& start) {
  const Index inner = mesh.opposite(first);
  const Vec2 at = in_frame_of(mesh, inner, start.at);
  return {Vec2{mesh.halfedges[inner].length, 0.0} - at, -at};
}

/// A place in the triangle of the directed edge h, whose ends lie at `edge`; if it is a vertex, the
/// triangle's apex is meant.
inline Vec2 place_behind(const HalfedgeMesh& mesh, Index h, const EdgePlaces& edge,
                         const SurfacePlace& place) {
  const Crossing& crossing = mesh.crossings[h];
  if (place.vertex != kNone) {
    return place_beside(edge.tail, edge.head, crossing.along, crossing.across);
  }
  const Vec2 at = in_frame_of(mesh, h, place.at);
  const double length = mesh.halfedges[h].length;
  return place_beside(edge.tail, edge.head, at.x / length, at.y / length);
}

/// Where the straight way from the root to `place` crosses the directed edges `crossed`, of which
/// the first lies at `first` and the last is that of the triangle of `place`: one point in space
/// each. O(edges).
inline std::vector<Vec3> points_of_straight_way(const HalfedgeMesh& mesh,
                                                const std::vector<Index>& crossed,
                                                const EdgePlaces& first,
                                                const SurfacePlace& place) {
  std::vector<EdgePlaces> edges{first};
  for (std::size_t i = 0; i + 1 < crossed.size(); ++i) {
    const Crossing& crossing = mesh.crossings[crossed[i]];
    const auto [tail, head] = edges.back();
    const Vec2 apex = place_beside(tail, head, crossing.along, crossing.across);
    edges.push_back(crossed[i + 1] == crossing.beyond[kRight] ? EdgePlaces{apex, head}
                                                              : EdgePlaces{tail, apex});
  }
  const Vec2 aim = place_behind(mesh, crossed.back(), edges.back(), place);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double tail_side = cross(aim, edges[i].tail);
    const double head_side = cross(aim, edges[i].head);
    const double share =
        tail_side > head_side ? std::clamp(tail_side / (tail_side - head_side), 0.0, 1.0) : 0.5;
    points.emplace_back(mesh.points[mesh.tail(crossed[i])] * (1.0 - share) +
                        mesh.points[mesh.head(crossed[i])] * share);
  }
  return points;
}

}  // namespace mgf
