// SPDX-License-Identifier: GPL-3.0-or-later
// A skeleton led round the places where its straight edges would leave the shape.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/placement.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/shape_interior.h"
#include "vcg_ext/skeleton/skeleton_graph.h"

namespace mgf {
namespace detail {

/// Leads the edges of a skeleton of Voronoi vertices through the shape.
class InsideRouter {
 public:
  InsideRouter(const InteriorTetrahedra& interior, const ShapeInterior& shape,
               const std::vector<Index>& voronoi_vertex, CurveSkeleton& skeleton)
      : interior_(interior), shape_(shape), voronoi_vertex_(voronoi_vertex), skeleton_(skeleton) {}

  void route(unsigned threads) {
    inside_ = find_inside_parts(shape_, skeleton_.position, skeleton_.edge, threads);
    call_in_outside_nodes();
    const Index edges = to_index(skeleton_.edge_count());  // detours append more
    for (Index e = 0; e < edges; ++e) {
      if (!inside_.has_edge(e, skeleton_.edge[e])) lead_round(e);
    }
  }

 private:
  /// Puts nodes that lie outside (flips of the surface can do that) at the centroids of their
  /// tetrahedra, where these are inside.
  void call_in_outside_nodes() {
    std::vector<char> moved(skeleton_.node_count(), 0);
    for (Index node = 0; node < moved.size(); ++node) {
      if (inside_.node[node] != 0) continue;
      const Vec3 centroid = tetrahedron_centroid(interior_, voronoi_vertex_[node]);
      if (!shape_.contains(centroid)) continue;
      skeleton_.position[node] = centroid;
      skeleton_.radius[node] = nearest_of(centroid, interior_.tetrahedra[voronoi_vertex_[node]]);
      inside_.node[node] = moved[node] = 1;
    }
    for (Index e = 0; e < skeleton_.edge_count(); ++e) {
      const auto [u, v] = skeleton_.edge[e];
      if (moved[u] == 0 && moved[v] == 0) continue;
      const bool clear = shape_.stays_inside(skeleton_.position[u], skeleton_.position[v]);
      inside_.edge_is_clear[e] = clear && inside_.node[u] != 0 ? 1 : 0;
    }
  }

  /// Replaces an edge by a way through the barycentre of its dual triangle, which lies between the
  /// two tetrahedra; if that isn't inside either, also through their centroids.
  void lead_round(Index e) {
    const auto [u, v] = skeleton_.edge[e];
    const Triangle& dual = skeleton_.contacts[e];
    const Vec3 barycentre =
        (interior_.points[dual[0]] + interior_.points[dual[1]] + interior_.points[dual[2]]) / 3.0;
    std::vector<Vec3> way = {skeleton_.position[u], barycentre, skeleton_.position[v]};
    std::vector<char> outside = outside_pieces(way, u);
    if (std::find(outside.begin(), outside.end(), char{1}) != outside.end()) {
      way = {way.front(), tetrahedron_centroid(interior_, voronoi_vertex_[u]), barycentre,
             tetrahedron_centroid(interior_, voronoi_vertex_[v]), way.back()};
      outside = outside_pieces(way, u);
    }
    Index from = u;
    for (std::size_t i = 0; i + 2 < way.size(); ++i) {
      const Index to = add_node(way[i + 1], e);
      add_edge_like(e, {from, to}, outside[i]);
      from = to;
    }
    skeleton_.edge[e] = {from, v};
    skeleton_.outside[e] = outside.back();
  }

  /// Which pieces of a way from node u are not inside.
  std::vector<char> outside_pieces(const std::vector<Vec3>& way, Index u) const {
    std::vector<char> outside;
    bool is_inside = inside_.node[u] != 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      const bool clear = shape_.stays_inside(way[i], way[i + 1]);
      outside.push_back(clear && is_inside ? 0 : 1);
      if (!clear) is_inside = shape_.contains(way[i + 1]);
    }
    return outside;
  }

  template <class Corners>
  double nearest_of(const Vec3& point, const Corners& corners) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index corner : corners) {
      nearest = std::min(nearest, (interior_.points[corner] - point).norm());
    }
    return nearest;
  }

  Index add_node(const Vec3& point, Index edge) {
    skeleton_.position.push_back(point);
    skeleton_.radius.push_back(nearest_of(point, skeleton_.contacts[edge]));
    skeleton_.node_mgf.push_back(skeleton_.mgf[edge]);
    skeleton_.node_eccentricity.push_back(0.0);
    return to_index(skeleton_.node_count() - 1);
  }

  /// Adds an edge with the measures of edge `e`.
  void add_edge_like(Index e, const std::array<Index, 2>& ends, char outside) {
    skeleton_.edge.push_back(ends);
    const auto repeat = [e](auto& values) {
      const auto value = values[e];
      values.push_back(value);
    };
    repeat(skeleton_.mgf);
    repeat(skeleton_.girth);
    repeat(skeleton_.circumference);
    repeat(skeleton_.eccentricity);
    repeat(skeleton_.theta_birth);
    repeat(skeleton_.voronoi_edge);
    repeat(skeleton_.contacts);
    skeleton_.outside.push_back(outside);
  }

  const InteriorTetrahedra& interior_;
  const ShapeInterior& shape_;
  const std::vector<Index>& voronoi_vertex_;
  CurveSkeleton& skeleton_;
  InsideParts inside_;
};

}  // namespace detail

/// Tests every edge of the skeleton against the shape. A node outside moves to the centroid of its
/// tetrahedron; an edge that is not inside becomes a chain of edges with its measures, by way of
/// the triangle that it crosses. What is outside even so is noted in `outside`. Edges and nodes
/// keep their numbers; new ones are appended.
inline void route_inside(const InteriorTetrahedra& interior, const ShapeInterior& shape,
                         unsigned threads, VoronoiSkeleton& drawing) {
  detail::InsideRouter(interior, shape, drawing.voronoi_vertex, drawing.skeleton).route(threads);
}

}  // namespace mgf
