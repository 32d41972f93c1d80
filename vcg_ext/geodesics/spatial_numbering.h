// SPDX-License-Identifier: GPL-3.0-or-later
// The question of compute_pair_geodesics renumbered so that what is near in space is near in
// memory, and the way back. So it, and its answer, does not depend on how the caller numbered the
// vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/spatial_order.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"

namespace mgf {

/// A surface with vertices and triangles in spatial order.
class SpatialNumbering {
 public:
  explicit SpatialNumbering(const TriangleSurface& surface) {
    number_vertices(surface);
    number_triangles(surface);
  }

  const TriangleSurface& surface() const { return surface_; }

  /// The number here of a vertex of the caller's.
  Index vertex_number(Index vertex) const { return vertex_number_[vertex]; }
  /// The caller's number of a directed edge of here.
  Index original_halfedge(Index h) const { return 3 * original_triangle_[triangle_of(h)] + h % 3; }

 private:
  void number_vertices(const TriangleSurface& surface) {
    std::vector<Index> order(surface.points.size());
    std::iota(order.begin(), order.end(), 0U);
    order = spatial_order(surface.points, std::move(order));
    vertex_number_.resize(order.size());
    for (Index i = 0; i < order.size(); ++i) {
      vertex_number_[order[i]] = i;
      surface_.points.push_back(surface.points[order[i]]);
    }
  }

  /// In the order of their least vertices. Corners keep their places.
  void number_triangles(const TriangleSurface& surface) {
    std::vector<Index> least;
    for (const Triangle& t : surface.triangles) {
      least.push_back(std::min({vertex_number_[t[0]], vertex_number_[t[1]], vertex_number_[t[2]]}));
    }
    original_triangle_ = group_by_key(least, vertex_number_.size()).items;
    for (const Index t : original_triangle_) {
      const Triangle& corners = surface.triangles[t];
      surface_.triangles.push_back(
          {vertex_number_[corners[0]], vertex_number_[corners[1]], vertex_number_[corners[2]]});
    }
  }

  TriangleSurface surface_;
  std::vector<Index> vertex_number_;      ///< one per vertex of the caller's
  std::vector<Index> original_triangle_;  ///< one per triangle of here
};

/// Pairs of a surface's vertices, sorted by the ends' new numbers, and the links between them.
class PairNumbering {
 public:
  PairNumbering(const SpatialNumbering& vertices, const std::vector<VertexPair>& pairs,
                const std::vector<std::array<Index, 3>>& links)
      : links_(links) {
    number_pairs(vertices, pairs);
    for (std::array<Index, 3>& link : links_) {
      for (Index& pair : link) pair = pair == kNone ? kNone : pair_number_[pair];
    }
  }

  const std::vector<VertexPair>& pairs() const { return pairs_; }
  const std::vector<std::array<Index, 3>>& links() const { return links_; }

  /// The number here of a pair of the caller's.
  Index pair_number(Index pair) const { return pair_number_[pair]; }
  /// Whether a pair of the caller's runs the other way here.
  bool is_turned(Index pair) const { return is_turned_[pair] != 0; }

 private:
  void number_pairs(const SpatialNumbering& vertices, const std::vector<VertexPair>& pairs) {
    std::vector<std::uint64_t> keys;
    keys.reserve(pairs.size());
    is_turned_.reserve(pairs.size());
    for (const VertexPair& pair : pairs) {
      const auto [a, b] =
          std::minmax({vertices.vertex_number(pair.a), vertices.vertex_number(pair.b)});
      keys.push_back(std::uint64_t{a} << 32U | b);
      is_turned_.push_back(vertices.vertex_number(pair.a) == a ? 0 : 1);
    }
    pair_number_.resize(pairs.size());
    pairs_.reserve(pairs.size());
    for (const Index original : sorted_by_key(keys)) {
      pair_number_[original] = to_index(pairs_.size());
      pairs_.push_back({static_cast<Index>(keys[original] >> 32U),
                        static_cast<Index>(keys[original] & 0xFFFFFFFFU)});
    }
  }

  std::vector<VertexPair> pairs_;
  std::vector<std::array<Index, 3>> links_;
  std::vector<Index> pair_number_;  ///< one per pair of the caller's
  std::vector<char> is_turned_;     ///< the same
};

}  // namespace mgf
