// SPDX-License-Identifier: GPL-3.0-or-later
// From what the erosion left to a curve skeleton that is drawn inside the shape, with its measures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/medial/placement.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/erosion.h"
#include "vcg_ext/skeleton/segment_inside.h"
#include "vcg_ext/skeleton/theta_births.h"

namespace mgf {

/// A curve skeleton as drawn.
struct SkeletonDrawing {
  CurveSkeleton skeleton;
  std::vector<Index> last_nodes;  ///< per tree component, the node left when every edge is gone
};

namespace detail {

/// Length of the circumcircle of a triangle; infinite if its corners are collinear.
inline double circumcircle_length(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twice_area = (b - a).cross(c - a).norm();
  return kPi * (b - a).norm() * (c - b).norm() * (a - c).norm() / twice_area;
}

/// Measures of one Voronoi edge that its graph edges inherit.
struct EdgeMeasures {
  double mgf = 0.0;
  double girth = 0.0;
  double circumference = 0.0;
  double eccentricity = 0.0;
  double theta_birth = 0.0;
};

/// Draws the live Voronoi edges one by one.
class SkeletonDrawer {
 public:
  SkeletonDrawer(const InteriorTetrahedra& interior, const MedialComplex& complex,
                 const MedialGeodesicField& field, const std::vector<Vec3>& surface_points,
                 const ThetaBirths& births, SegmentInside inside)
      : interior_(interior),
        complex_(complex),
        field_(field),
        surface_points_(surface_points),
        births_(births),
        inside_(std::move(inside)),
        node_of_vertex_(complex.vertex_count(), kNone) {}

  SkeletonDrawing draw(const ErodedComplex& eroded) {
    for (Index v = 0; v < complex_.vertex_count(); ++v) {
      if (eroded.vertex_alive[v] == 0) continue;
      node_of_vertex_[v] = add_node(anchor(v), complex_.radius[v], largest_mgf(v));
    }
    for (Index e = 0; e < complex_.edge_count(); ++e) {
      if (eroded.edge_alive[e] != 0) draw_edge(e);
    }
    for (const Index v : births_.last_vertex) {
      drawing_.last_nodes.push_back(node_of_vertex_[v]);
    }
    return std::move(drawing_);
  }

 private:
  Index add_node(const Vec3& position, double radius, double mgf) {
    CurveSkeleton& skeleton = drawing_.skeleton;
    skeleton.position.push_back(position);
    skeleton.radius.push_back(radius);
    skeleton.node_mgf.push_back(mgf);
    skeleton.node_eccentricity.push_back(0.0);
    return to_index(skeleton.node_count() - 1);
  }

  /// Where a Voronoi vertex is drawn: its place in the complex, unless flips of the surface put
  /// that outside the input; then the centroid of its tetrahedron.
  Vec3 anchor(Index v) const {
    const Vec3 centroid = tetrahedron_centroid(interior_, v);
    return inside_(centroid, complex_.position[v]) ? complex_.position[v] : centroid;
  }

  double largest_mgf(Index v) const {
    double largest = 0.0;
    for (const Index e : complex_.vertex_edges[v]) largest = std::max(largest, edge_mgf(e));
    return largest;
  }

  /// Largest f of the incident facets; for an edge without facets, the longest geodesic side.
  double edge_mgf(Index e) const {
    const Triangle& dual = complex_.edge_contacts[e];
    double of_facets = 0.0;
    double of_sides = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index facet = complex_.edge_facets[e][i];
      if (facet != kNone) of_facets = std::max(of_facets, field_.mgf[facet]);
      of_sides = std::max(of_sides,
                          geodesic_distance(field_, surface_points_, dual[i], dual[(i + 1) % 3]));
    }
    return of_facets > 0.0 ? of_facets : of_sides;
  }

  EdgeMeasures measure(Index e) const {
    const Triangle& dual = complex_.edge_contacts[e];
    EdgeMeasures measures;
    measures.mgf = edge_mgf(e);
    measures.theta_birth = births_.edge[e];
    for (std::size_t i = 0; i < 3; ++i) {
      measures.girth += geodesic_distance(field_, surface_points_, dual[i], dual[(i + 1) % 3]);
    }
    measures.circumference = circumcircle_length(surface_points_[dual[0]], surface_points_[dual[1]],
                                                 surface_points_[dual[2]]);
    measures.eccentricity = measures.girth / measures.circumference;
    return measures;
  }

  /// The straight line if it stays inside; else by way of the shared triangle's barycentre; else
  /// also through the two tetrahedra's centroids.
  void draw_edge(Index e) {
    const auto [u, v] = complex_.edge_vertices[e];
    const Vec3& start = drawing_.skeleton.position[node_of_vertex_[u]];
    const Vec3& end = drawing_.skeleton.position[node_of_vertex_[v]];
    const Triangle& dual = complex_.edge_contacts[e];
    const Vec3 barycentre =
        (interior_.points[dual[0]] + interior_.points[dual[1]] + interior_.points[dual[2]]) / 3.0;
    std::vector<Vec3> detour;
    if (!inside_(start, end)) {
      detour = {barycentre};
      if (!inside_(start, barycentre) || !inside_(barycentre, end)) {
        detour = {tetrahedron_centroid(interior_, u), barycentre,
                  tetrahedron_centroid(interior_, v)};
      }
    }
    const EdgeMeasures measures = measure(e);
    Index from = node_of_vertex_[u];
    for (const Vec3& point : detour) {
      double radius = (point - surface_points_[dual[0]]).norm();
      for (const Index contact : dual) {
        radius = std::min(radius, (point - surface_points_[contact]).norm());
      }
      const Index next = add_node(point, radius, measures.mgf);
      add_edge(from, next, e, measures);
      from = next;
    }
    add_edge(from, node_of_vertex_[v], e, measures);
  }

  void add_edge(Index from, Index to, Index voronoi_edge, const EdgeMeasures& measures) {
    CurveSkeleton& skeleton = drawing_.skeleton;
    skeleton.edge.push_back({from, to});
    skeleton.mgf.push_back(measures.mgf);
    skeleton.girth.push_back(measures.girth);
    skeleton.circumference.push_back(measures.circumference);
    skeleton.eccentricity.push_back(measures.eccentricity);
    skeleton.theta_birth.push_back(measures.theta_birth);
    skeleton.voronoi_edge.push_back(voronoi_edge);
    skeleton.contacts.push_back(complex_.edge_contacts[voronoi_edge]);
    skeleton.outside.push_back(0);
  }

  const InteriorTetrahedra& interior_;
  const MedialComplex& complex_;
  const MedialGeodesicField& field_;
  const std::vector<Vec3>& surface_points_;
  const ThetaBirths& births_;
  SegmentInside inside_;
  std::vector<Index> node_of_vertex_;
  SkeletonDrawing drawing_;
};

}  // namespace detail

/// Tests every edge of the skeleton and notes in `outside` which ones leave the shape.
inline void test_edges_inside(const SegmentInside& segment_inside, CurveSkeleton& skeleton) {
  for (std::size_t e = 0; e < skeleton.edge_count(); ++e) {
    const auto& ends = skeleton.edge[e];
    const bool inside = segment_inside(skeleton.position[ends[0]], skeleton.position[ends[1]]);
    skeleton.outside[e] = inside ? 0 : 1;
  }
}

/// The live cells of the eroded complex as a graph inside the shape. `surface_points` are the
/// points of the surface that geodesics ran on, numbered as the contacts.
inline SkeletonDrawing draw_skeleton(const InteriorTetrahedra& interior,
                                     const MedialComplex& complex, const MedialGeodesicField& field,
                                     const std::vector<Vec3>& surface_points,
                                     const ErodedComplex& eroded, const ThetaBirths& births,
                                     const SegmentInside& segment_inside) {
  return detail::SkeletonDrawer(interior, complex, field, surface_points, births, segment_inside)
      .draw(eroded);
}

}  // namespace mgf
