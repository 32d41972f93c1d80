// SPDX-License-Identifier: GPL-3.0-or-later
// The geodesics of the medial geodesic function as polylines on the surface.
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/medial/medial_geodesic_function.h"

namespace mgf::plugin {

/// A path on a surface: where it crosses edges and passes vertices, from its start to its end, and
/// the triangles that it runs through or along.
struct SurfacePath {
  std::vector<Vec3> points;
  std::vector<Index> faces;
};

/// Draws the shortest path between two corners of a dual triangle: the geodesic where there is one,
/// else the surface's own edge between them.
class SurfacePaths {
 public:
  SurfacePaths(const TriangleSurface& surface, const MedialGeodesicField& field)
      : mesh_(make_halfedge_mesh(surface)), field_(field) {}

  /// Requires a < b. Linear in the triangles passed.
  SurfacePath operator()(Index a, Index b) const {
    const Index pair = field_.table.find(a, b);
    if (pair == kNone) return along_edge(a, b);
    const Row<Index> row = field_.geodesics.corridor[pair];
    if (row.empty()) return along_edge(a, b);
    const std::vector<Index> corridor(row.begin(), row.end());
    return drawn(a, b, corridor);
  }

 private:
  SurfacePath along_edge(Index a, Index b) const {
    SurfacePath path;
    path.points = {mesh_.points[a], mesh_.points[b]};
    add_faces_of_edge(a, b, path);
    return path;
  }

  void add_faces_of_edge(Index a, Index b, SurfacePath& path) const {
    const Index h = find_halfedge(mesh_, a, b);
    if (h == kNone) return;
    path.faces.push_back(triangle_of(h));
    path.faces.push_back(triangle_of(mesh_.opposite(h)));
  }

  SurfacePath drawn(Index a, Index b, const std::vector<Index>& corridor) const {
    Funnel funnel(mesh_);
    funnel.straighten(a, b, corridor);
    SurfacePath path;
    path.points.push_back(mesh_.points[a]);
    for (std::size_t i = 0; i + 1 < funnel.path().size(); ++i) {
      draw_straight(funnel, funnel.node(funnel.path()[i]), funnel.node(funnel.path()[i + 1]),
                    corridor, path);
    }
    return path;
  }

  /// Draws the straight piece between two neighbouring bends.
  void draw_straight(const Funnel& funnel, const Funnel::Node& from, const Funnel::Node& to,
                     const std::vector<Index>& corridor, SurfacePath& path) const {
    Index crossings = 0;
    for (Index k = from.portal; k < to.portal; ++k) {
      // Edges that end at the bend turn about it; the path crosses those beyond.
      if (mesh_.tail(corridor[k]) == from.vertex || mesh_.head(corridor[k]) == from.vertex)
        continue;
      if (crossings++ == 0) path.faces.push_back(triangle_of(mesh_.opposite(corridor[k])));
      path.faces.push_back(triangle_of(corridor[k]));
      path.points.push_back(crossing(funnel, from.place, to.place, corridor[k], k));
    }
    if (crossings == 0) add_faces_of_edge(from.vertex, to.vertex, path);
    path.points.push_back(mesh_.points[to.vertex]);
  }

  /// Where the straight line between two places of the strip crosses its edge number k.
  Vec3 crossing(const Funnel& funnel, Vec2 from, Vec2 to, Index h, Index k) const {
    const Vec2 along = to - from;
    const Vec2 span = funnel.right_of(k) - funnel.left_of(k);
    const double slope = cross(span, along);
    const double t =
        slope != 0.0 ? std::clamp(cross(from - funnel.left_of(k), along) / slope, 0.0, 1.0) : 0.5;
    return (1.0 - t) * mesh_.points[mesh_.tail(h)] + t * mesh_.points[mesh_.head(h)];
  }

  HalfedgeMesh mesh_;
  const MedialGeodesicField& field_;
};

}  // namespace mgf::plugin
