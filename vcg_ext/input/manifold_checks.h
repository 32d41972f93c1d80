// SPDX-License-Identifier: GPL-3.0-or-later
// Is a set of triangles the boundary of solids: two faces an edge, one fan a vertex, one outside.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/input/finding.h"

namespace mgf {

namespace detail {

/// The members of a list, each once, ascending.
inline std::vector<Index> sorted_unique(std::vector<Index> list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

inline void check_edge_valence(const EdgeTable& edges, std::vector<Finding>& findings) {
  std::vector<Index> faces;
  std::vector<Index> vertices;
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides[e].size() <= 2) continue;
    ++count;
    vertices.insert(vertices.end(), edges.ends[e].begin(), edges.ends[e].end());
    for (const FaceSide& side : edges.sides[e]) faces.push_back(side.face);
  }
  if (count == 0) return;
  findings.push_back(make_finding("non_manifold_edges", Severity::kFatal, count,
                                  sorted_unique(std::move(faces)),
                                  sorted_unique(std::move(vertices))));
}

/// Counts the connected chains of edges with one face; its culprits are those edges.
inline void check_boundary(const EdgeTable& edges, std::size_t vertex_count,
                           std::vector<Finding>& findings) {
  DisjointSets loops(vertex_count);
  std::vector<Index> faces;
  std::vector<Index> vertices;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides[e].size() != 1) continue;
    loops.join(edges.ends[e][0], edges.ends[e][1]);
    faces.push_back(edges.sides[e].front().face);
    vertices.insert(vertices.end(), edges.ends[e].begin(), edges.ends[e].end());
  }
  if (faces.empty()) return;
  vertices = sorted_unique(std::move(vertices));
  const auto count =
      std::count_if(vertices.begin(), vertices.end(), [&](Index v) { return loops.find(v) == v; });
  findings.push_back(make_finding("boundary_loops", Severity::kFatal,
                                  static_cast<std::size_t>(count), sorted_unique(std::move(faces)),
                                  std::move(vertices)));
}

/// The least faces whose turning would make all neighbours look the same way; of a one-sided
/// surface, those that look the other way than a neighbour on the way there.
inline std::vector<Index> faces_to_turn(const std::vector<Triangle>& triangles,
                                        const EdgeTable& edges) {
  struct Link {
    Index face;
    bool same_way;
  };
  std::vector<Index> owner;
  std::vector<Link> links;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides[e].size() != 2) continue;
    const FaceSide s = edges.sides[e][0];
    const FaceSide t = edges.sides[e][1];
    const bool same_way =
        side_start(triangles[s.face], s.side) != side_start(triangles[t.face], t.side);
    owner.push_back(s.face);
    links.push_back({t.face, same_way});
    owner.push_back(t.face);
    links.push_back({s.face, same_way});
  }
  const Rows<Index> links_of = group_by_key(owner, triangles.size());
  constexpr char kUnseen = 2;
  std::vector<char> turned(triangles.size(), kUnseen);
  std::vector<Index> result;
  for (Index seed = 0; seed < triangles.size(); ++seed) {
    if (turned[seed] != kUnseen) continue;
    turned[seed] = 0;
    std::vector<Index> piece{seed};
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const Index l : links_of[piece[i]]) {
        if (turned[links[l].face] != kUnseen) continue;
        const bool turn = (turned[piece[i]] != 0) == links[l].same_way;
        turned[links[l].face] = turn ? 1 : 0;
        piece.push_back(links[l].face);
      }
    }
    std::array<std::vector<Index>, 2> sides;
    for (const Index f : piece) sides[turned[f] != 0 ? 1 : 0].push_back(f);
    const std::vector<Index>& fewer = sides[sides[1].size() <= sides[0].size() ? 1 : 0];
    result.insert(result.end(), fewer.begin(), fewer.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline void check_orientation(const std::vector<Triangle>& triangles, const EdgeTable& edges,
                              std::vector<Finding>& findings) {
  const auto clash = [&](std::size_t e) {
    const Row<FaceSide> sides = edges.sides[e];
    return sides.size() == 2 && side_start(triangles[sides[0].face], sides[0].side) ==
                                    side_start(triangles[sides[1].face], sides[1].side);
  };
  bool clashes = false;
  for (std::size_t e = 0; e < edges.size() && !clashes; ++e) clashes = clash(e);
  if (!clashes) return;
  std::vector<Index> faces = faces_to_turn(triangles, edges);
  const std::size_t count = faces.size();
  findings.push_back(
      make_finding("inconsistent_orientation", Severity::kFatal, count, std::move(faces)));
}

/// A vertex is a fan if its corners hang together over edges.
inline void check_vertices(const std::vector<Triangle>& triangles, const EdgeTable& edges,
                           std::size_t vertex_count, std::vector<Finding>& findings) {
  DisjointSets corners(3 * triangles.size());
  const auto corner_at = [&](const FaceSide& side, Index vertex) {
    const bool at_start = side_start(triangles[side.face], side.side) == vertex;
    return 3 * side.face + (at_start ? side.side : (side.side + 1) % 3);
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const FaceSide& first = edges.sides[e].front();
    for (const FaceSide& side : edges.sides[e]) {
      for (const Index v : edges.ends[e]) corners.join(corner_at(first, v), corner_at(side, v));
    }
  }
  std::vector<Index> fans(vertex_count, 0);
  for (Index corner = 0; corner < 3 * triangles.size(); ++corner) {
    if (corners.find(corner) == corner) ++fans[triangles[corner / 3][corner % 3]];
  }
  std::vector<Index> pinched;
  for (Index v = 0; v < vertex_count; ++v) {
    if (fans[v] > 1) pinched.push_back(v);
  }
  if (pinched.empty()) return;
  const std::size_t count = pinched.size();
  findings.push_back(
      make_finding("non_manifold_vertices", Severity::kFatal, count, {}, std::move(pinched)));
}

}  // namespace detail

/// What keeps `surface` from being a closed, oriented, manifold surface; nothing if it is one.
/// Requires the corners of each face to differ. O(n log n).
inline std::vector<Finding> check_manifold(const TriangleSurface& surface, const EdgeTable& edges) {
  std::vector<Finding> findings;
  detail::check_edge_valence(edges, findings);
  detail::check_boundary(edges, surface.points.size(), findings);
  detail::check_orientation(surface.triangles, edges, findings);
  detail::check_vertices(surface.triangles, edges, surface.points.size(), findings);
  return findings;
}

}  // namespace mgf
