// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of the shape, as the skeleton's stages ask about it.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"

namespace mgf {

/// Two questions about a solid. Threads may ask them at the same time.
struct ShapeInterior {
  /// Whether a point is inside.
  std::function<bool(const Vec3&)> contains;
  /// Whether a straight segment is inside all along, given that its first end is. Cheaper.
  std::function<bool(const Vec3&, const Vec3&)> stays_inside;
};

/// Which parts of a graph of straight edges are inside.
struct InsideParts {
  std::vector<char> node;           ///< 1 inside
  std::vector<char> edge_is_clear;  ///< 1: inside if its ends are

  bool has_edge(Index e, const std::array<Index, 2>& ends) const {
    return edge_is_clear[e] != 0 && node[ends[0]] != 0;
  }
};

/// Tests every edge and node. Clear edges keep to one side of the surface, so one point of each set
/// of nodes that they join speaks for all. The same for any number of `threads`.
inline InsideParts find_inside_parts(const ShapeInterior& shape, const std::vector<Vec3>& nodes,
                                     const std::vector<std::array<Index, 2>>& edges,
                                     unsigned threads) {
  InsideParts inside;
  inside.edge_is_clear.resize(edges.size());
  constexpr std::size_t kChunk = 256;
  parallel_for(edges.size(), threads, kChunk, [&](std::size_t e, unsigned) {
    const auto [u, v] = edges[e];
    inside.edge_is_clear[e] = shape.stays_inside(nodes[u], nodes[v]) ? 1 : 0;
  });
  DisjointSets sides(nodes.size());
  for (Index e = 0; e < edges.size(); ++e) {
    if (inside.edge_is_clear[e] != 0) sides.join(edges[e][0], edges[e][1]);
  }
  inside.node.resize(nodes.size());
  for (Index v = 0; v < nodes.size(); ++v) {  // a set's root is its first node
    const Index root = sides.find(v);
    inside.node[v] = root == v ? static_cast<char>(shape.contains(nodes[v])) : inside.node[root];
  }
  return inside;
}

}  // namespace mgf
