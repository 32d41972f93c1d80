// SPDX-License-Identifier: GPL-3.0-or-later
// A skeleton led round the places where its straight edges would leave the shape.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/shape_interior.h"
#include "vcg_ext/skeleton/skeleton_graph.h"

namespace mgf {
namespace detail {

/// Points strictly inside a triangle or tetrahedron: its centroid, then those halfway from there to
/// each corner and to the middle of each side opposite.
template <std::size_t kCorners>
std::array<Vec3, 1 + 2 * kCorners> inner_points(const std::vector<Vec3>& points,
                                                const std::array<Index, kCorners>& corners) {
  std::array<Vec3, 1 + 2 * kCorners> inner;
  constexpr double kCount = kCorners;
  Vec3 centroid = Vec3::Zero();
  for (const Index corner : corners) centroid += points[corner] / kCount;
  inner[0] = centroid;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const Vec3 arm = points[corners[i]] - centroid;
    inner[1 + i] = centroid + 0.5 * arm;
    inner[1 + kCorners + i] = centroid - 0.5 / (kCount - 1.0) * arm;
  }
  return inner;
}

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
  /// A point of tetrahedron t inside the shape (flips of the surface can put some of it outside),
  /// its centroid if there is a choice or none is found.
  Vec3 point_inside(Index t) const {
    const auto inner = inner_points(interior_.points, interior_.tetrahedra[t]);
    const auto found = std::find_if(inner.begin(), inner.end(), shape_.contains);
    return found != inner.end() ? *found : inner[0];
  }

  /// Puts nodes that lie outside into their tetrahedra, where these are inside.
  void call_in_outside_nodes() {
    std::vector<char> moved(skeleton_.node_count(), 0);
    for (Index node = 0; node < moved.size(); ++node) {
      if (inside_.node[node] != 0) continue;
      const Vec3 place = point_inside(voronoi_vertex_[node]);
      if (!shape_.contains(place)) continue;
      skeleton_.position[node] = place;
      skeleton_.radius[node] = nearest_of(place, interior_.tetrahedra[voronoi_vertex_[node]]);
      inside_.node[node] = moved[node] = 1;
    }
    for (Index e = 0; e < skeleton_.edge_count(); ++e) {
      const auto [u, v] = skeleton_.edge[e];
      if (moved[u] == 0 && moved[v] == 0) continue;
      const bool clear = shape_.stays_inside(skeleton_.position[u], skeleton_.position[v]);
      inside_.edge_is_clear[e] = clear && inside_.node[u] != 0 ? 1 : 0;
    }
  }

  /// A way for edge e and which of its pieces are not inside.
  struct Way {
    std::vector<Vec3> points;
    std::vector<char> outside;
    bool is_inside() const {
      return std::find(outside.begin(), outside.end(), char{1}) == outside.end();
    }
  };

  /// The first way found inside through the edge's dual triangle, which lies between the two
  /// tetrahedra; straight to a point of it, or also through points of the tetrahedra.
  Way way_round(Index e) const {
    const auto [u, v] = skeleton_.edge[e];
    const Vec3& from = skeleton_.position[u];
    const Vec3& to = skeleton_.position[v];
    const Vec3 near = point_inside(voronoi_vertex_[u]);
    const Vec3 far = point_inside(voronoi_vertex_[v]);
    Way way;
    for (const Vec3& gate : inner_points(interior_.points, skeleton_.contacts[e])) {
      for (std::vector<Vec3> points :
           {std::vector<Vec3>{from, gate, to}, {from, near, gate, far, to}}) {
        std::vector<char> outside = outside_pieces(points, u);
        way = {std::move(points), std::move(outside)};
        if (way.is_inside()) return way;
      }
    }
    return way;
  }

  /// Replaces an edge by a way round.
  void lead_round(Index e) {
    const auto [u, v] = skeleton_.edge[e];
    const Way way = way_round(e);
    Index from = u;
    for (std::size_t i = 0; i + 2 < way.points.size(); ++i) {
      const Index to = add_node(way.points[i + 1], e);
      add_edge_like(e, {from, to}, way.outside[i]);
      from = to;
    }
    skeleton_.edge[e] = {from, v};
    skeleton_.outside[e] = way.outside.back();
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

/// Tests every edge of the skeleton against the shape. A node outside moves to a point of its
/// tetrahedron; an edge that is not inside becomes a chain of edges with its measures, by way of
/// the triangle that it crosses. What is outside even so is noted in `outside`. Edges and nodes
/// keep their numbers; new ones are appended.
inline void route_inside(const InteriorTetrahedra& interior, const ShapeInterior& shape,
                         unsigned threads, VoronoiSkeleton& drawing) {
  detail::InsideRouter(interior, shape, drawing.voronoi_vertex, drawing.skeleton).route(threads);
}

}  // namespace mgf
