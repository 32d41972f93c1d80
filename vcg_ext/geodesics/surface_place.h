// SPDX-License-Identifier: GPL-3.0-or-later
// Where on the surface a search starts or a target lies: at a vertex, or in a triangle.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/flat_vertices.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// A point of the surface.
struct SurfacePlace {
  Index vertex = kNone;  ///< the vertex, or kNone for a point of the closed triangle
  Index triangle = kNone;
  Vec2 at;  ///< in the triangle's frame, that of its first directed edge
  Vec3 position = Vec3::Zero();
};

inline SurfacePlace place_of_vertex(const HalfedgeMesh& mesh, Index v) {
  return {v, kNone, {}, mesh.points[v]};
}

/// The point at `position`, which lies in triangle t, or the corner that it is.
inline SurfacePlace place_in_triangle(const HalfedgeMesh& mesh, Index t, const Vec3& position) {
  const Index first = 3 * t;
  for (Index h = first; h < first + 3; ++h) {
    const double distance = (mesh.points[mesh.tail(h)] - position).norm();
    if (distance <= HalfedgeMesh::kHair * mesh.mean_edge) {
      return place_of_vertex(mesh, mesh.tail(h));
    }
  }
  const Vec3& tail = mesh.points[mesh.tail(first)];
  const Vec3 along = (mesh.points[mesh.head(first)] - tail) / mesh.halfedges[first].length;
  const Vec3 arm = mesh.points[mesh.apex(first)] - tail;
  const Vec3 across = (arm - along * along.dot(arm)).normalized();
  return {kNone, t, {along.dot(position - tail), across.dot(position - tail)}, position};
}

/// A point given in the frame of a triangle's first directed edge, in the frame of its edge h.
inline Vec2 in_frame_of(const HalfedgeMesh& mesh, Index h, Vec2 at) {
  if (h % 3 == 0) return at;
  const Halfedge& first = mesh.halfedges[h - h % 3];
  const double length = mesh.halfedges[h].length;
  const Vec2 head{first.length, 0.0};
  const Vec2 origin = h % 3 == 1 ? head : first.apex;
  const Vec2 span = h % 3 == 1 ? first.apex - head : Vec2{-first.apex.x, -first.apex.y};
  const Vec2 arm = at - origin;
  return {dot(arm, span) / length, cross(span, arm) / length};
}

/// Where each vertex of the fine surface lies on the coarse one.
inline std::vector<SurfacePlace> places_on_coarse(const TriangleSurface& fine,
                                                  const CoarseSurface& coarse,
                                                  const HalfedgeMesh& coarse_mesh) {
  std::vector<SurfacePlace> places(fine.points.size());
  for (Index v = 0; v < places.size(); ++v) {
    places[v] = coarse.vertex_of[v] != kNone
                    ? place_of_vertex(coarse_mesh, coarse.vertex_of[v])
                    : place_in_triangle(coarse_mesh, coarse.triangle_of[v], fine.points[v]);
  }
  return places;
}

}  // namespace mgf
