// SPDX-License-Identifier: GPL-3.0-or-later
// The closed pieces of a surface: size, genus, volume, and which are cavities of which.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/edge_table.h"

namespace mgf {

/// A connected closed surface.
struct Shell {
  Index faces = 0;
  Index vertices = 0;
  int genus = 0;
  double signed_volume = 0.0;  ///< mesh units cubed; negative if it looks inwards
  Index inside_shell = kNone;  ///< the shell that this one is a cavity of; kNone: it's a solid
};

/// The shells, by their least face.
struct Shells {
  std::vector<Shell> shells;
  std::vector<Index> of_face;    ///< one per face
  std::vector<Index> of_vertex;  ///< one per vertex
  std::vector<char> flat;        ///< one per shell: 1 if it encloses no volume but rounding errors
};

/// The shells of a closed manifold surface by what hangs together: their faces, vertices and genus.
/// Linear time.
inline Shells find_pieces(const TriangleSurface& surface, const EdgeTable& edges) {
  Shells result;
  DisjointSets pieces(surface.triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const FaceSide& side : edges.sides[e]) pieces.join(edges.sides[e].front().face, side.face);
  }
  std::vector<Index> name(surface.triangles.size(), kNone);
  result.of_vertex.assign(surface.points.size(), kNone);
  for (Index f = 0; f < surface.triangles.size(); ++f) {
    const Index root = pieces.find(f);
    if (root == f) {
      name[f] = to_index(result.shells.size());
      result.shells.emplace_back();
    }
    result.of_face.push_back(name[root]);
    ++result.shells[name[root]].faces;
    for (const Index v : surface.triangles[f]) result.of_vertex[v] = name[root];
  }
  for (const Index shell : result.of_vertex) ++result.shells[shell].vertices;
  // A closed triangle mesh has 3 F / 2 edges, so V - E + F = V - F / 2 = 2 - 2 genus.
  for (Shell& shell : result.shells) {
    shell.genus = 1 - (static_cast<int>(shell.vertices) - static_cast<int>(shell.faces / 2)) / 2;
  }
  return result;
}

namespace detail {

inline void measure_volumes(const TriangleSurface& surface, Shells& result) {
  // Thinner than this share of its extent, a shell's volume is a rounding error.
  constexpr double kThinnest = 1e-12;
  const std::size_t count = result.shells.size();
  std::vector<Vec3> low(count, Vec3::Constant(std::numeric_limits<double>::infinity()));
  std::vector<Vec3> high(count, -low.front());
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    low[result.of_vertex[v]] = low[result.of_vertex[v]].cwiseMin(surface.points[v]);
    high[result.of_vertex[v]] = high[result.of_vertex[v]].cwiseMax(surface.points[v]);
  }
  std::vector<double> area(count, 0.0);
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const Index s = result.of_face[f];
    const Vec3 origin = 0.5 * low[s] + 0.5 * high[s];
    const Triangle& t = surface.triangles[f];
    const Vec3 a = surface.points[t[0]] - origin;
    const Vec3 b = surface.points[t[1]] - origin;
    const Vec3 c = surface.points[t[2]] - origin;
    area[s] += 0.5 * (b - a).cross(c - a).norm();
    result.shells[s].signed_volume += a.dot(b.cross(c)) / 6.0;
  }
  for (std::size_t s = 0; s < count; ++s) {
    const double extent = (high[s] - low[s]).norm();
    const bool flat = std::abs(result.shells[s].signed_volume) <= kThinnest * area[s] * extent;
    result.flat.push_back(flat ? 1 : 0);
  }
}

/// For each shell the others that a point of it lies inside of, leaving out those that it cuts.
inline std::vector<std::vector<Index>> containing_shells(
    const TriangleSurface& surface, const Shells& shells,
    const std::vector<std::array<Index, 2>>& crossing_faces) {
  const std::size_t count = shells.shells.size();
  std::vector<std::vector<Index>> containing(count);
  if (count == 1) return containing;
  std::vector<std::array<Index, 2>> cutting;
  for (const auto& [f, g] : crossing_faces) {
    cutting.push_back({shells.of_face[f], shells.of_face[g]});
    cutting.push_back({shells.of_face[g], shells.of_face[f]});
  }
  std::sort(cutting.begin(), cutting.end());
  std::vector<Index> probe(count, kNone);
  for (Index v = 0; v < surface.points.size(); ++v) {
    if (probe[shells.of_vertex[v]] == kNone) probe[shells.of_vertex[v]] = v;
  }
  const SurfaceTree tree(surface);
  for (Index s = 0; s < count; ++s) {
    std::vector<Index> crossed;
    tree.visit_crossings(surface.points[probe[s]],
                         [&](Index face, int) { crossed.push_back(shells.of_face[face]); });
    std::sort(crossed.begin(), crossed.end());
    for (auto first = crossed.begin(); first != crossed.end();) {
      const auto last = std::upper_bound(first, crossed.end(), *first);
      const bool odd = (last - first) % 2 != 0;
      const std::array<Index, 2> pair{s, *first};
      if (odd && *first != s && !std::binary_search(cutting.begin(), cutting.end(), pair)) {
        containing[s].push_back(*first);
      }
      first = last;
    }
  }
  return containing;
}

}  // namespace detail

/// The shells of a closed manifold surface. `crossing_faces` are its self-intersections: shells
/// that cut each other overlap, neither is inside the other. A shell is a cavity if it lies inside
/// an odd number of others (so that a solid within a cavity is a solid), whatever its orientation.
/// Requires no collinear face. O(n log n) for few shells.
inline Shells find_shells(const TriangleSurface& surface, const EdgeTable& edges,
                          const std::vector<std::array<Index, 2>>& crossing_faces) {
  Shells result = find_pieces(surface, edges);
  detail::measure_volumes(surface, result);
  if (result.shells.size() == 1) return result;
  const auto containing = detail::containing_shells(surface, result, crossing_faces);
  for (std::size_t s = 0; s < result.shells.size(); ++s) {
    if (containing[s].size() % 2 == 0) continue;
    // Of nested shells the innermost is inside the most others.
    result.shells[s].inside_shell = *std::max_element(
        containing[s].begin(), containing[s].end(),
        [&](Index i, Index j) { return containing[i].size() < containing[j].size(); });
  }
  return result;
}

}  // namespace mgf
