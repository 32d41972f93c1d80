// SPDX-License-Identifier: GPL-3.0-or-later
// A computed geodesic as a polyline on the surface.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/funnel.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"

namespace mgf {

/// A polyline on the surface and the triangle that each of its pieces lies in or on the border of.
struct SurfacePath {
  std::vector<Vec3> points;  ///< from a to b; one more than `faces`
  std::vector<Index> faces;
};

namespace detail {

/// Where the straight piece that crosses directed edge number k of the strip meets it, in 3D.
inline Vec3 crossing_point(const HalfedgeMesh& mesh, const Funnel& funnel, Index h, Index k,
                           Vec2 from, Vec2 to) {
  const Vec2 left = funnel.left_of(k);
  const Vec2 span = funnel.right_of(k) - left;
  const double across = cross(span, to - from);
  const double share =
      across != 0.0 ? std::clamp(cross(from - left, to - from) / across, 0.0, 1.0) : 0.0;
  return mesh.points[mesh.tail(h)] * (1.0 - share) + mesh.points[mesh.head(h)] * share;
}

}  // namespace detail

/// The path of one pair. `mesh` is that of the surface the geodesics were computed on. A pair
/// without a path gets an empty one. Pieces without length are left out. Linear in the triangles.
inline SurfacePath path_of_pair(const HalfedgeMesh& mesh, const std::vector<VertexPair>& pairs,
                                const PairGeodesics& geodesics, Index pair) {
  SurfacePath path;
  const auto [a, b] = pairs[pair];
  if (!(geodesics.length[pair] < std::numeric_limits<double>::infinity())) return path;
  const Row<Index> row = geodesics.corridor[pair];
  const std::vector<Index> corridor(row.begin(), row.end());
  path.points.push_back(mesh.points[a]);
  if (corridor.empty()) {
    path.points.push_back(mesh.points[b]);
    path.faces.push_back(triangle_of(find_halfedge(mesh, a, b)));
    return path;
  }
  const auto add = [&](const Vec3& point, Index face) {
    if ((point - path.points.back()).norm() <= 1e-14 * geodesics.length[pair]) return;
    path.points.push_back(point);
    path.faces.push_back(face);
  };
  Funnel funnel(mesh);
  funnel.straighten(a, b, corridor);
  const std::vector<Index>& nodes = funnel.path();
  std::size_t piece = 0;
  for (Index k = 0; k < corridor.size(); ++k) {
    // Edges about a bend meet the path at the bend itself; the piece after it starts there.
    while (piece + 2 < nodes.size() && funnel.node(nodes[piece + 1]).portal <= k) ++piece;
    const Vec2 from = funnel.node(nodes[piece]).place;
    const Vec2 to = funnel.node(nodes[piece + 1]).place;
    const Index before = triangle_of(k == 0 ? mesh.opposite(corridor[0]) : corridor[k - 1]);
    add(detail::crossing_point(mesh, funnel, corridor[k], k, from, to), before);
  }
  const Index last = triangle_of(corridor.back());
  add(mesh.points[b], last);
  return path;
}

}  // namespace mgf
