// SPDX-License-Identifier: GPL-3.0-or-later
// Bistellar moves of a tetrahedral mesh that make way for a missing edge or face of a surface and
// never destroy one that is there.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// What a missing edge ab wants: fewer faces touched by the segment ab.
struct SegmentObstacle {
  Index a, b;

  /// 1 if the segment meets the triangle xyz away from its own ends.
  int face_cost(const TetrahedralMesh& mesh, Index x, Index y, Index z) const {
    if (x == a || x == b || y == a || y == b || z == a || z == b) return 0;
    if (mesh.orientation(x, y, z, a) * mesh.orientation(x, y, z, b) >= 0) return 0;
    const int xy = mesh.orientation(a, b, x, y);
    const int yz = mesh.orientation(a, b, y, z);
    if (xy * yz < 0) return 0;
    const int zx = mesh.orientation(a, b, z, x);
    return xy * zx >= 0 && yz * zx >= 0 ? 1 : 0;
  }
  /// The wanted edge itself outweighs any number of touched faces.
  int edge_cost(const TetrahedralMesh& /*mesh*/, Index x, Index y) const {
    return (x == a && y == b) || (x == b && y == a) ? -1000 : 0;
  }
};

/// What a missing face abc with all its edges there wants: fewer edges through the triangle.
struct TriangleObstacle {
  Index a, b, c;

  int face_cost(const TetrahedralMesh& /*mesh*/, Index /*x*/, Index /*y*/, Index /*z*/) const {
    return 0;
  }
  /// 1 if the edge xy goes through the triangle.
  int edge_cost(const TetrahedralMesh& mesh, Index x, Index y) const {
    if (x == a || x == b || x == c || y == a || y == b || y == c) return 0;
    if (mesh.orientation(a, b, c, x) * mesh.orientation(a, b, c, y) >= 0) return 0;
    const int ab = mesh.orientation(x, y, a, b);
    const int bc = mesh.orientation(x, y, b, c);
    if (ab * bc < 0) return 0;
    const int ca = mesh.orientation(x, y, c, a);
    return ab * ca >= 0 && bc * ca >= 0 ? 1 : 0;
  }
};

/// The moves. Each is made only if every new tetrahedron is positive (exact), no edge or face of
/// the surface goes, and the obstacle's cost changes by at most `max_change`.
template <class Obstacle>
class LocalMoves {
 public:
  /// Edges with more tetrahedra than this are left alone.
  static constexpr std::size_t kLargestRing = 20;

  LocalMoves(TetrahedralMesh& mesh, const ConstrainedSurface& surface, const Obstacle& obstacle)
      : mesh_(mesh), surface_(surface), obstacle_(obstacle) {}

  /// 2-3 flip of the face of t opposite corner i.
  bool flip_face(Index t, unsigned i, int max_change) {
    const Index u = mesh_.neighbour(t, i);
    if (u == kNone) return false;
    const auto [x, y, z] = face_of(mesh_.corners(t), i);
    const Index p = mesh_.corners(t)[i];
    const Index q = opposite(u, x, y, z);
    if (mesh_.orientation(p, q, x, y) <= 0 || mesh_.orientation(p, q, y, z) <= 0 ||
        mesh_.orientation(p, q, z, x) <= 0 || surface_.has_face(x, y, z)) {
      return false;
    }
    const int change = obstacle_.edge_cost(mesh_, p, q) + obstacle_.face_cost(mesh_, p, q, x) +
                       obstacle_.face_cost(mesh_, p, q, y) + obstacle_.face_cost(mesh_, p, q, z) -
                       obstacle_.face_cost(mesh_, x, y, z);
    if (change > max_change) return false;
    mesh_.replace({t, u}, {{p, q, x, y}, {p, q, y, z}, {p, q, z, x}});
    return true;
  }

  /// Removes the edge xy of t by the cheapest allowed triangulation of its link (Klincsek's dynamic
  /// programme over the polygon; Shewchuk 2002).
  bool remove_edge(Index t, Index x, Index y, int max_change) {
    EdgeRing ring;
    if (surface_.has_edge(x, y) || !mesh_.ring_of(t, x, y, kLargestRing, ring)) return false;
    return remove_edge(ring, x, y, max_change);
  }

  /// As `remove_edge`; if that fails, first thins out the link by removing edges from x or y to it,
  /// themselves by the same means up to `depth` times. All is rolled back on failure.
  /// Requires an open journal. `budget` bounds the number of attempts.
  bool remove_edge_recursively(Index x, Index y, int max_change, int depth, int& budget) {
    const Index t = mesh_.find_edge(x, y);
    EdgeRing ring;
    if (t == kNone || surface_.has_edge(x, y) || !mesh_.ring_of(t, x, y, kLargestRing, ring)) {
      return false;
    }
    if (remove_edge(ring, x, y, max_change)) return true;
    if (depth == 0 || --budget < 0) return false;
    const std::size_t start = mesh_.journal_mark();
    const std::vector<Index> link = ring.link;
    for (const Index p : link) {
      for (const Index end : {x, y}) {
        const std::size_t mark = mesh_.journal_mark();
        const std::size_t size = ring.link.size();
        if (size <= 3 || !remove_edge_recursively(end, p, 0, depth - 1, budget)) continue;
        const Index s = mesh_.find_edge(x, y);
        if (s == kNone) return true;
        if (!mesh_.ring_of(s, x, y, kLargestRing, ring) || ring.link.size() >= size) {
          mesh_.roll_back(mark);
          mesh_.ring_of(mesh_.find_edge(x, y), x, y, kLargestRing, ring);
          continue;
        }
        if (remove_edge(ring, x, y, max_change)) return true;
      }
    }
    mesh_.roll_back(start);
    return false;
  }

 private:
  static constexpr int kForbidden = 1 << 20;

  Index opposite(Index t, Index x, Index y, Index z) const {
    for (const Index v : mesh_.corners(t)) {
      if (v != x && v != y && v != z) return v;
    }
    return kNone;
  }

  bool remove_edge(const EdgeRing& ring, Index x, Index y, int max_change) {
    const std::vector<Index>& link = ring.link;
    const std::size_t n = link.size();
    if (n < 3) return false;
    const int cost = plan(link, x, y);
    if (cost >= kForbidden) return false;
    int removed = obstacle_.edge_cost(mesh_, x, y);
    for (const Index p : link) removed += obstacle_.face_cost(mesh_, x, y, p);
    if (cost - removed > max_change) return false;
    made_.clear();
    collect(link, x, y, 0, n - 1);
    mesh_.replace(ring.tetrahedra, made_);
    return true;
  }

  // Fills best_ and apex_; returns the cost of the cheapest triangulation of the whole link.
  int plan(const std::vector<Index>& link, Index x, Index y) {
    const std::size_t n = link.size();
    for (std::size_t i = 0; i + 1 < n; ++i) best_[i][i + 1] = 0;
    for (std::size_t span = 2; span < n; ++span) {
      for (std::size_t i = 0; i + span < n; ++i) {
        const std::size_t j = i + span;
        best_[i][j] = kForbidden;
        for (std::size_t k = i + 1; k < j; ++k) {
          int cost = best_[i][k] + best_[k][j];
          if (cost >= best_[i][j] || !allowed(link[i], link[k], link[j], x, y)) continue;
          cost += obstacle_.face_cost(mesh_, link[i], link[k], link[j]);
          if (cost >= best_[i][j]) continue;
          best_[i][j] = cost;
          apex_[i][j] = k;
        }
        if (best_[i][j] < kForbidden && span + 1 < n) {
          best_[i][j] += obstacle_.edge_cost(mesh_, link[i], link[j]) +
                         obstacle_.face_cost(mesh_, link[i], link[j], x) +
                         obstacle_.face_cost(mesh_, link[i], link[j], y);
        }
      }
    }
    return best_[0][n - 1];
  }

  bool allowed(Index p, Index q, Index r, Index x, Index y) const {
    return mesh_.orientation(p, q, r, y) > 0 && mesh_.orientation(p, q, r, x) < 0;
  }

  void collect(const std::vector<Index>& link, Index x, Index y, std::size_t i, std::size_t j) {
    if (j - i < 2) return;
    const std::size_t k = apex_[i][j];
    made_.push_back({link[i], link[k], link[j], y});
    made_.push_back({link[i], link[j], link[k], x});
    collect(link, x, y, i, k);
    collect(link, x, y, k, j);
  }

  TetrahedralMesh& mesh_;
  const ConstrainedSurface& surface_;
  Obstacle obstacle_;
  std::array<std::array<int, kLargestRing>, kLargestRing> best_{};
  std::array<std::array<std::size_t, kLargestRing>, kLargestRing> apex_{};
  std::vector<Tetrahedron> made_;
};

}  // namespace mgf
