// SPDX-License-Identifier: GPL-3.0-or-later
// What the erosion left of the medial complex as a graph with measures.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/erosion.h"
#include "vcg_ext/skeleton/theta_births.h"

namespace mgf {

/// A curve skeleton whose nodes are Voronoi vertices.
struct VoronoiSkeleton {
  CurveSkeleton skeleton;
  std::vector<Index> voronoi_vertex;  ///< one per node
  std::vector<Index> last_nodes;      ///< per tree component, the node left when every edge is gone
};

namespace detail {

/// Length of the circumcircle of a triangle; infinite if its corners are collinear.
inline double circumcircle_length(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twice_area = (b - a).cross(c - a).norm();
  return kPi * (b - a).norm() * (c - b).norm() * (a - c).norm() / twice_area;
}

/// Geodesic measures of Voronoi edges and vertices.
class CellMeasures {
 public:
  /// `points` are numbered as the contacts.
  CellMeasures(const MedialComplex& complex, const MedialGeodesicField& field,
               const std::vector<Vec3>& points)
      : complex_(complex), field_(field), points_(points) {}

  /// Geodesic lengths of the sides bc, ca, ab of an edge's dual triangle.
  std::array<double, 3> geodesic_sides(Index edge) const {
    const Triangle& dual = complex_.edge_contacts[edge];
    std::array<double, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Index facet = complex_.edge_facets[edge][i];
      sides[i] = facet != kNone
                     ? field_.mgf[facet]
                     : geodesic_distance(field_, points_, dual[(i + 1) % 3], dual[(i + 2) % 3]);
    }
    return sides;
  }

  /// Largest f of an edge's facets; for an edge without facets, the longest geodesic side.
  double edge_mgf(Index edge) const {
    double largest = 0.0;
    for (const Index facet : complex_.edge_facets[edge]) {
      if (facet != kNone) largest = std::max(largest, field_.mgf[facet]);
    }
    if (largest > 0.0) return largest;
    const std::array<double, 3> sides = geodesic_sides(edge);
    return *std::max_element(sides.begin(), sides.end());
  }

  /// Largest f at a vertex.
  double vertex_mgf(Index vertex) const {
    double largest = 0.0;
    for (const Index e : complex_.vertex_edges[vertex]) largest = std::max(largest, edge_mgf(e));
    return largest;
  }

  double circumference(Index edge) const {
    const auto [a, b, c] = complex_.edge_contacts[edge];
    return circumcircle_length(points_[a], points_[b], points_[c]);
  }

 private:
  const MedialComplex& complex_;
  const MedialGeodesicField& field_;
  const std::vector<Vec3>& points_;
};

/// The numbers of the cells that are alive, ascending.
inline std::vector<Index> live_cells(const std::vector<char>& alive) {
  std::vector<Index> cells;
  for (Index cell = 0; cell < alive.size(); ++cell) {
    if (alive[cell] != 0) cells.push_back(cell);
  }
  return cells;
}

inline constexpr std::size_t kCellsAtOnce = 1024;  // a thread's share of a loop over cells

inline void fill_nodes(const MedialComplex& complex, const CellMeasures& measures,
                       const std::vector<Index>& vertices, unsigned threads,
                       CurveSkeleton& skeleton) {
  const std::size_t n = vertices.size();
  skeleton.position.resize(n);
  skeleton.radius.resize(n);
  skeleton.node_mgf.resize(n);
  skeleton.node_eccentricity.assign(n, 0.0);
  parallel_for(n, threads, kCellsAtOnce, [&](std::size_t i, unsigned) {
    skeleton.position[i] = complex.position[vertices[i]];
    skeleton.radius[i] = complex.radius[vertices[i]];
    skeleton.node_mgf[i] = measures.vertex_mgf(vertices[i]);
  });
}

inline void fill_edges(const MedialComplex& complex, const CellMeasures& measures,
                       const ThetaBirths& births, const std::vector<Index>& node_of_vertex,
                       unsigned threads, CurveSkeleton& skeleton) {
  const std::size_t n = skeleton.voronoi_edge.size();
  skeleton.edge.resize(n);
  skeleton.mgf.resize(n);
  skeleton.girth.resize(n);
  skeleton.circumference.resize(n);
  skeleton.eccentricity.resize(n);
  skeleton.theta_birth.resize(n);
  skeleton.contacts.resize(n);
  skeleton.outside.assign(n, 0);
  parallel_for(n, threads, kCellsAtOnce, [&](std::size_t i, unsigned) {
    const Index e = skeleton.voronoi_edge[i];
    const auto [u, v] = complex.edge_vertices[e];
    const std::array<double, 3> sides = measures.geodesic_sides(e);
    skeleton.edge[i] = {node_of_vertex[u], node_of_vertex[v]};
    skeleton.mgf[i] = measures.edge_mgf(e);
    skeleton.girth[i] = sides[0] + sides[1] + sides[2];
    skeleton.circumference[i] = measures.circumference(e);
    skeleton.eccentricity[i] = skeleton.girth[i] / skeleton.circumference[i];
    skeleton.theta_birth[i] = births.edge[e];
    skeleton.contacts[i] = complex.edge_contacts[e];
  });
}

}  // namespace detail

/// The live cells of the eroded complex as a graph of straight edges, whether inside or not.
/// `surface_points` are the points of the surface that geodesics ran on, numbered as the contacts.
/// Node averages are not set. Linear time.
inline VoronoiSkeleton draw_skeleton(const MedialComplex& complex, const MedialGeodesicField& field,
                                     const std::vector<Vec3>& surface_points,
                                     const ErodedComplex& eroded, const ThetaBirths& births,
                                     unsigned threads) {
  const detail::CellMeasures measures(complex, field, surface_points);
  VoronoiSkeleton result;
  result.voronoi_vertex = detail::live_cells(eroded.vertex_alive);
  std::vector<Index> node_of_vertex(complex.vertex_count(), kNone);
  for (Index node = 0; node < result.voronoi_vertex.size(); ++node) {
    node_of_vertex[result.voronoi_vertex[node]] = node;
  }
  detail::fill_nodes(complex, measures, result.voronoi_vertex, threads, result.skeleton);
  result.skeleton.voronoi_edge = detail::live_cells(eroded.edge_alive);
  detail::fill_edges(complex, measures, births, node_of_vertex, threads, result.skeleton);
  for (const Index v : births.last_vertex) result.last_nodes.push_back(node_of_vertex[v]);
  return result;
}

}  // namespace mgf
