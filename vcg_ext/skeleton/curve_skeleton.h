// SPDX-License-Identifier: GPL-3.0-or-later
// The curve skeleton as a graph with measures (paper, sections 4.1 and 5.4).
#pragma once

#include <array>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// `theta_birth` of an edge that is there at every theta: it lies on a loop or between loops.
inline constexpr double kAlwaysThere = -2.0;

/// A curve skeleton: nodes and straight edges. A Voronoi edge whose straight line would leave the
/// shape is a chain of several graph edges with the same measures.
struct CurveSkeleton {
  // One per node.
  std::vector<Vec3> position;
  std::vector<double> radius;             ///< distance to the nearest contact point
  std::vector<double> node_mgf;           ///< largest MGF of the incident facets
  std::vector<double> node_eccentricity;  ///< mean over the incident edges, weighted by length

  // One per edge.
  std::vector<std::array<Index, 2>> edge;
  std::vector<double> mgf;            ///< largest MGF of the Voronoi edge's facets
  std::vector<double> girth;          ///< g(E), length of the geodesic circle
  std::vector<double> circumference;  ///< c(E), length of the dual triangle's circumcircle
  std::vector<double> eccentricity;   ///< e(E) = g(E) / c(E)
  std::vector<double> theta_birth;    ///< the edge is in the skeleton for every theta above this
  std::vector<Index> voronoi_edge;    ///< in the medial complex
  std::vector<Triangle> contacts;     ///< corners of the dual triangle
  std::vector<char> outside;          ///< 1 where the edge does not lie inside the shape

  std::size_t node_count() const { return position.size(); }
  std::size_t edge_count() const { return edge.size(); }
};

}  // namespace mgf
