// SPDX-License-Identifier: GPL-3.0-or-later
// Curve skeletons drawn by hand: nodes, edges and round numbers for the measures.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/shape_interior.h"

namespace mgf::test {

/// A shape with all points inside, from which only the segments with `stays_inside` don't stray.
template <class StaysInside>
ShapeInterior shape_of_segments(const StaysInside& stays_inside) {
  return {[](const Vec3&) { return true; }, stays_inside};
}

/// All of space.
inline ShapeInterior everywhere() {
  return shape_of_segments([](const Vec3&, const Vec3&) { return true; });
}

/// A skeleton in a tube of radius `radius`: MGF pi r, girth 2 pi r, eccentricity 1 everywhere.
inline CurveSkeleton tube_skeleton(std::vector<Vec3> nodes, std::vector<std::array<Index, 2>> edges,
                                   double radius) {
  CurveSkeleton skeleton;
  const std::size_t n = nodes.size();
  const std::size_t m = edges.size();
  skeleton.position = std::move(nodes);
  skeleton.edge = std::move(edges);
  skeleton.radius.assign(n, radius);
  skeleton.node_mgf.assign(n, M_PI * radius);
  skeleton.node_eccentricity.assign(n, 1.0);
  skeleton.mgf.assign(m, M_PI * radius);
  skeleton.girth.assign(m, 2 * M_PI * radius);
  skeleton.circumference.assign(m, 2 * M_PI * radius);
  skeleton.eccentricity.assign(m, 1.0);
  skeleton.theta_birth.assign(m, kAlwaysThere);
  skeleton.contacts.assign(m, Triangle{0, 1, 2});
  skeleton.outside.assign(m, 0);
  skeleton.voronoi_edge.resize(m);
  std::iota(skeleton.voronoi_edge.begin(), skeleton.voronoi_edge.end(), Index{0});
  return skeleton;
}

/// A skeleton without edges: one node.
inline CurveSkeleton single_node_skeleton() {
  return tube_skeleton({Vec3(1, 2, 3)}, {}, 1.0);
}

/// Adds a polyline of `segments` edges from node `from` through `place(t)`, t in (0, 1], to a new
/// node, or to node `to` if that isn't kNone. Returns its last node.
template <class Place>
Index add_polyline(std::vector<Vec3>& nodes, std::vector<std::array<Index, 2>>& edges, Index from,
                   Index to, int segments, const Place& place) {
  Index previous = from;
  for (int i = 1; i <= segments; ++i) {
    Index next = to;
    if (i < segments || to == kNone) {
      next = to_index(nodes.size());
      nodes.push_back(place(static_cast<double>(i) / segments));
    }
    edges.push_back({previous, next});
    previous = next;
  }
  return previous;
}

/// A straight line of `segments` edges along x, of the given length.
inline CurveSkeleton line_skeleton(double length, int segments, double radius) {
  std::vector<Vec3> nodes{Vec3::Zero()};
  std::vector<std::array<Index, 2>> edges;
  add_polyline(nodes, edges, 0, kNone, segments, [&](double t) { return Vec3(t * length, 0, 0); });
  return tube_skeleton(nodes, edges, radius);
}

/// Arms of the given lengths from the origin, in the xy plane at equal angles.
inline CurveSkeleton star_skeleton(const std::vector<double>& lengths, int segments,
                                   double radius) {
  std::vector<Vec3> nodes{Vec3::Zero()};
  std::vector<std::array<Index, 2>> edges;
  for (std::size_t arm = 0; arm < lengths.size(); ++arm) {
    const double angle = 2 * M_PI * static_cast<double>(arm) / static_cast<double>(lengths.size());
    const Vec3 tip = lengths[arm] * Vec3(std::cos(angle), std::sin(angle), 0);
    add_polyline(nodes, edges, 0, kNone, segments, [&](double t) { return Vec3(t * tip); });
  }
  return tube_skeleton(nodes, edges, radius);
}

/// A circle of `segments` edges in the xy plane.
inline CurveSkeleton ring_skeleton(double ring_radius, int segments, double radius) {
  std::vector<Vec3> nodes{Vec3(ring_radius, 0, 0)};
  std::vector<std::array<Index, 2>> edges;
  add_polyline(nodes, edges, 0, 0, segments, [&](double t) {
    return Vec3(ring_radius * std::cos(2 * M_PI * t), ring_radius * std::sin(2 * M_PI * t), 0);
  });
  return tube_skeleton(nodes, edges, radius);
}

/// The same skeleton with nodes and edges in another order and edges turned round.
inline CurveSkeleton renumbered(const CurveSkeleton& skeleton, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> new_node(skeleton.node_count());
  std::vector<Index> edge_order(skeleton.edge_count());
  std::iota(new_node.begin(), new_node.end(), Index{0});
  std::iota(edge_order.begin(), edge_order.end(), Index{0});
  std::shuffle(new_node.begin(), new_node.end(), random);
  std::shuffle(edge_order.begin(), edge_order.end(), random);

  CurveSkeleton result = skeleton;
  for (Index v = 0; v < skeleton.node_count(); ++v) {
    result.position[new_node[v]] = skeleton.position[v];
    result.radius[new_node[v]] = skeleton.radius[v];
    result.node_mgf[new_node[v]] = skeleton.node_mgf[v];
    result.node_eccentricity[new_node[v]] = skeleton.node_eccentricity[v];
  }
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    const Index old = edge_order[e];
    const std::array<Index, 2>& ends = skeleton.edge[old];
    result.edge[e] = {new_node[ends[1]], new_node[ends[0]]};
    result.mgf[e] = skeleton.mgf[old];
    result.girth[e] = skeleton.girth[old];
    result.circumference[e] = skeleton.circumference[old];
    result.eccentricity[e] = skeleton.eccentricity[old];
    result.theta_birth[e] = skeleton.theta_birth[old];
    result.voronoi_edge[e] = skeleton.voronoi_edge[old];
    result.contacts[e] = skeleton.contacts[old];
  }
  return result;
}

}  // namespace mgf::test
