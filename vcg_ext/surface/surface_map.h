// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of the curve skeleton each face and vertex of the surface belongs to.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/junction_zones.h"
#include "vcg_ext/surface/face_flood.h"
#include "vcg_ext/surface/geodesic_circles.h"
#include "vcg_ext/surface/parts.h"

namespace mgf {

/// Correspondence of surface elements to the skeleton.
struct SkeletonCorrespondence {
  std::vector<Index> branch;       ///< id in the BranchGraph; kNone on a shell without circles
  std::vector<Index> edge;         ///< skeleton edge that the element belongs to, or kNone
  std::vector<double> arc_length;  ///< position along the branch from its first node, mesh units
  std::vector<double> distance;    ///< straight distance to that skeleton edge
  std::vector<double> girth;       ///< geodesic girth of that edge
};

/// The surface cut by branch.
struct SurfaceMap {
  SkeletonCorrespondence faces;     ///< one entry per face of the input surface, at its centroid
  SkeletonCorrespondence vertices;  ///< one entry per vertex of the input surface
};

namespace surface_mapping {

/// A skeleton edge as part of its branch.
struct PlacedEdge {
  Vec3 from = Vec3::Zero();  ///< the end nearer the branch's first node
  Vec3 to = Vec3::Zero();
  double start = 0.0;  ///< arc length at `from`
};

inline std::vector<PlacedEdge> place_edges(const CurveSkeleton& skeleton,
                                           const BranchGraph& graph) {
  std::vector<PlacedEdge> placed(skeleton.edge_count());
  for (const Branch& branch : graph.branches) {
    double arc_length = 0.0;
    for (std::size_t i = 0; i < branch.edges.size(); ++i) {
      PlacedEdge& edge = placed[branch.edges[i]];
      edge = {skeleton.position[branch.nodes[i]], skeleton.position[branch.nodes[i + 1]],
              arc_length};
      arc_length += (edge.to - edge.from).norm();
    }
  }
  return placed;
}

/// Where a point falls on a skeleton edge.
struct Foot {
  double arc_length = 0.0;
  double distance = 0.0;
};

inline Foot foot_on(const PlacedEdge& edge, const Vec3& p) {
  const Vec3 along = edge.to - edge.from;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - edge.from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return {edge.start + t * along.norm(), (p - edge.from - t * along).norm()};
}

/// The edge of a branch that is nearest to `p`.
inline Index nearest_edge(const Branch& branch, const std::vector<PlacedEdge>& placed,
                          const Vec3& p) {
  return *std::min_element(branch.edges.begin(), branch.edges.end(), [&](Index e, Index g) {
    return foot_on(placed[e], p).distance < foot_on(placed[g], p).distance;
  });
}

/// The skeleton edge of each face: of the circles through it on its own branch the one whose edge
/// is nearest; elsewhere that of the nearest such face of the same part. A part may have no such
/// face, if its branch got it from others at a junction: there the branch's nearest edge counts.
inline std::vector<Index> edges_of_faces(const FaceGraph& faces, const Rows<Index>& circles_on_face,
                                         const BranchGraph& graph,
                                         const std::vector<PlacedEdge>& placed,
                                         const std::vector<Index>& part) {
  std::vector<Index> seeds(faces.face_count(), kNone);
  for (Index f = 0; f < seeds.size(); ++f) {
    double least = 0.0;
    for (const Index e : circles_on_face[f]) {
      if (graph.edge_branch[e] != part[f]) continue;
      const double distance = foot_on(placed[e], faces.centroid[f]).distance;
      if (seeds[f] == kNone || distance < least) {
        seeds[f] = e;
        least = distance;
      }
    }
  }
  std::vector<Index> edges =
      flood_faces(faces, seeds, [&](Index f, Index g) { return part[f] == part[g]; }).label;
  for (Index f = 0; f < edges.size(); ++f) {
    if (edges[f] != kNone || part[f] == kNone) continue;
    edges[f] = nearest_edge(graph.branches[part[f]], placed, faces.centroid[f]);
  }
  return edges;
}

/// The correspondence of points whose skeleton edges are known.
inline SkeletonCorrespondence correspond(const std::vector<Vec3>& points, std::vector<Index> edges,
                                         const CurveSkeleton& skeleton, const BranchGraph& graph,
                                         const std::vector<PlacedEdge>& placed) {
  SkeletonCorrespondence result;
  const std::size_t n = points.size();
  result.branch.assign(n, kNone);
  result.arc_length.assign(n, 0.0);
  result.distance.assign(n, 0.0);
  result.girth.assign(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    if (edges[i] == kNone) continue;
    const Foot foot = foot_on(placed[edges[i]], points[i]);
    result.branch[i] = graph.edge_branch[edges[i]];
    result.arc_length[i] = foot.arc_length;
    result.distance[i] = foot.distance;
    result.girth[i] = skeleton.girth[edges[i]];
  }
  result.edge = std::move(edges);
  return result;
}

/// The part that holds most of the area round vertex `v`; the smaller id of equals.
inline Index part_round_vertex(const Row<Index>& around, const std::vector<Index>& part,
                               const std::vector<double>& area) {
  Index best = kNone;
  double best_area = -1.0;
  for (const Index f : around) {
    double held = 0.0;
    for (const Index g : around) {
      if (part[g] == part[f]) held += area[g];
    }
    if (held > best_area || (held == best_area && part[f] < best)) {
      best = part[f];
      best_area = held;
    }
  }
  return best;
}

/// The skeleton edge of each vertex: of those of the faces round it in its part, the nearest.
inline std::vector<Index> edges_of_vertices(const TriangleSurface& input, const FaceGraph& faces,
                                            const std::vector<PlacedEdge>& placed,
                                            const std::vector<Index>& part,
                                            const std::vector<Index>& face_edge) {
  std::vector<Index> corner;
  corner.reserve(3 * input.triangles.size());
  for (const Triangle& t : input.triangles) corner.insert(corner.end(), t.begin(), t.end());
  Rows<Index> around = group_by_key(corner, input.points.size());
  for (Index& item : around.items) item /= 3;

  std::vector<Index> edges(input.points.size(), kNone);
  for (Index v = 0; v < edges.size(); ++v) {
    const Index own = part_round_vertex(around[v], part, faces.area);
    double least = 0.0;
    for (const Index f : around[v]) {
      if (part[f] != own || face_edge[f] == kNone) continue;
      const double distance = foot_on(placed[face_edge[f]], input.points[v]).distance;
      if (edges[v] == kNone || distance < least) {
        edges[v] = face_edge[f];
        least = distance;
      }
    }
  }
  return edges;
}

}  // namespace surface_mapping

/// Maps every face and vertex of `input` to a branch (see `cut_into_parts`) and a place on it.
/// `refined` refines `input`, and the circles run on it. Cost: O(n log n) in the faces and circle
/// crossings.
inline SurfaceMap map_surface(const TriangleSurface& input, const RefinedSurface& refined,
                              const CurveSkeleton& skeleton, const BranchGraph& graph,
                              const GeodesicCircles& circles) {
  const FaceGraph faces = build_face_graph(input);
  const Rows<Index> circles_on_face =
      items_on_input_faces(circles.faces, refined.parent_face, faces.face_count());
  std::vector<double> circle_radius;
  for (const double mgf : skeleton.mgf) circle_radius.push_back(mgf / kPi);
  const std::vector<Index> part =
      cut_into_parts(faces, circles_on_face, owning_branches(skeleton, graph), circle_radius);
  const std::vector<surface_mapping::PlacedEdge> placed =
      surface_mapping::place_edges(skeleton, graph);
  const std::vector<Index> face_edge =
      surface_mapping::edges_of_faces(faces, circles_on_face, graph, placed, part);

  SurfaceMap map;
  map.vertices = surface_mapping::correspond(
      input.points, surface_mapping::edges_of_vertices(input, faces, placed, part, face_edge),
      skeleton, graph, placed);
  map.faces = surface_mapping::correspond(faces.centroid, face_edge, skeleton, graph, placed);
  return map;
}

}  // namespace mgf
