// SPDX-License-Identifier: GPL-3.0-or-later
// The same surface with fewer triangles: vertices that the surface is flat at are taken out.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A triangulation of a finer surface by some of its vertices. Each of its edges is straight and
/// each of its triangles flat on the finer surface, so that distances are the same.
struct CoarseSurface {
  TriangleSurface surface;
  std::vector<Index> vertex_of;  ///< one per fine vertex: its number here, or kNone if taken out
  std::vector<Index>
      triangle_of;            ///< one per fine vertex: a triangle that a vertex taken out lies in
  std::vector<Index> parent;  ///< one per fine triangle: the triangle its centroid lies in
};

namespace detail {

/// Takes vertices out by collapsing them along an edge wherever that changes no point of the
/// surface: inside flat regions and along straight creases.
class FlatVertexRemoval {
 public:
  explicit FlatVertexRemoval(const TriangleSurface& fine)
      : fine_(fine),
        triangles_(fine.triangles),
        held_(fine.triangles.size()),
        around_(fine.points.size()),
        removed_(fine.points.size(), 0) {
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (const Index v : triangles_[t]) around_[v].push_back(t);
      held_[t].push_back(centroid_id(t));
    }
  }

  CoarseSurface run() {
    // A collapse may make room for another one, but waves die out fast.
    constexpr int kMostPasses = 16;
    bool changed = true;
    for (int pass = 0; changed && pass < kMostPasses; ++pass) {
      changed = false;
      for (Index v = 0; v < around_.size(); ++v) {
        if (removed_[v] == 0 && take_out(v)) changed = true;
      }
    }
    return collect();
  }

 private:
  /// Surfaces closer to flat than this, in parts of the local edge length, count as flat: the
  /// rounding of midpoints, far below what lengths are certified to.
  static constexpr double kFlat = 1e-12;
  /// No triangle thinner than this (height to longest side) is made.
  static constexpr double kThin = 0.02;

  // What triangles hold: vertices taken out, by number, and after those the fine triangles'
  // centroids.
  Index centroid_id(Index fine_triangle) const {
    return to_index(fine_.points.size()) + fine_triangle;
  }
  Vec3 position(Index held) const {
    if (held < fine_.points.size()) return fine_.points[held];
    const Triangle& t = fine_.triangles[held - fine_.points.size()];
    return (fine_.points[t[0]] + fine_.points[t[1]] + fine_.points[t[2]]) / 3.0;
  }

  static bool has(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

  Vec3 normal(const Triangle& t) const {
    return (fine_.points[t[1]] - fine_.points[t[0]]).cross(fine_.points[t[2]] - fine_.points[t[0]]);
  }

  /// Height over longest side.
  double shape(const Triangle& t) const {
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest =
          std::max(longest, (fine_.points[t[i]] - fine_.points[t[(i + 1) % 3]]).squaredNorm());
    }
    return longest > 0.0 ? normal(t).norm() / longest : 0.0;
  }

  bool take_out(Index v) {
    neighbours_of(v, ring_);
    Index best = kNone;
    double best_shape = kThin;
    for (const Index u : ring_) {
      const double quality = shape_after(v, u, best_shape);
      if (quality > best_shape && is_linked_simply(u)) {
        best_shape = quality;
        best = u;
      }
    }
    if (best == kNone) return false;
    collapse(v, best);
    return true;
  }

  void neighbours_of(Index v, std::vector<Index>& ring) const {
    ring.clear();
    for (const Index t : around_[v]) {
      for (const Index w : triangles_[t]) {
        if (w != v) ring.push_back(w);
      }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  }

  /// The worst shape among the triangles about v after collapsing it into u, or 0 if that would
  /// move the surface or fall below `least`.
  double shape_after(Index v, Index u, double least) const {
    double worst = 1.0;
    for (const Index t : around_[v]) {
      Triangle triangle = triangles_[t];
      if (has(triangle, u)) continue;
      const Vec3 before = normal(triangle);
      const Vec3 arm = fine_.points[u] - fine_.points[v];
      if (!(std::abs(before.dot(arm)) <= kFlat * before.norm() * arm.norm())) return 0.0;
      std::replace(triangle.begin(), triangle.end(), v, u);
      if (!(normal(triangle).dot(before) > 0.0)) return 0.0;
      worst = std::min(worst, shape(triangle));
      if (!(worst > least)) return 0.0;
    }
    return worst;
  }

  /// Whether u and the vertex that `ring_` is about have just the two common neighbours that their
  /// edge's triangles give them.
  bool is_linked_simply(Index u) {
    neighbours_of(u, other_ring_);
    std::size_t common = 0;
    for (const Index w : ring_) {
      common += std::binary_search(other_ring_.begin(), other_ring_.end(), w) ? 1U : 0U;
    }
    return common == 2;
  }

  void collapse(Index v, Index u) {
    std::vector<Index> loose{v};
    std::vector<Index> kept;
    for (const Index t : around_[v]) {
      loose.insert(loose.end(), held_[t].begin(), held_[t].end());
      held_[t].clear();
      if (!has(triangles_[t], u)) {
        std::replace(triangles_[t].begin(), triangles_[t].end(), v, u);
        kept.push_back(t);
        continue;
      }
      for (const Index w : triangles_[t]) {
        if (w != v) around_[w].erase(std::find(around_[w].begin(), around_[w].end(), t));
      }
      triangles_[t] = {kNone, kNone, kNone};
    }
    around_[u].insert(around_[u].end(), kept.begin(), kept.end());
    around_[v].clear();
    removed_[v] = 1;
    for (const Index p : loose) held_[home_of(p, kept)].push_back(p);
  }

  /// The triangle among `kept` that point p lies in: deepest of those whose plane it is on.
  Index home_of(Index p, const std::vector<Index>& kept) const {
    const Vec3 place = position(p);
    Index best = kept.front();
    double best_depth = -std::numeric_limits<double>::infinity();
    for (const Index t : kept) {
      const Triangle& c = triangles_[t];
      const Vec3 n = normal(c);
      const double area = n.squaredNorm();
      double depth = -1e3 * std::abs(n.dot(place - fine_.points[c[0]])) / area * n.norm();
      double inside = 1.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& q = fine_.points[c[(i + 1) % 3]];
        const Vec3& r = fine_.points[c[(i + 2) % 3]];
        inside = std::min(inside, (r - q).cross(place - q).dot(n) / area);
      }
      depth += inside;
      if (depth > best_depth) {
        best_depth = depth;
        best = t;
      }
    }
    return best;
  }

  CoarseSurface collect() const {
    CoarseSurface coarse;
    coarse.vertex_of.assign(fine_.points.size(), kNone);
    coarse.triangle_of.assign(fine_.points.size(), kNone);
    coarse.parent.assign(fine_.triangles.size(), kNone);
    for (Index v = 0; v < fine_.points.size(); ++v) {
      if (removed_[v] != 0) continue;
      coarse.vertex_of[v] = to_index(coarse.surface.points.size());
      coarse.surface.points.push_back(fine_.points[v]);
    }
    for (Index t = 0; t < triangles_.size(); ++t) {
      if (triangles_[t][0] == kNone) continue;
      const Index number = to_index(coarse.surface.triangles.size());
      for (const Index p : held_[t]) {
        if (p < fine_.points.size()) {
          coarse.triangle_of[p] = number;
        } else {
          coarse.parent[p - fine_.points.size()] = number;
        }
      }
      Triangle triangle = triangles_[t];
      for (Index& v : triangle) v = coarse.vertex_of[v];
      coarse.surface.triangles.push_back(triangle);
    }
    return coarse;
  }

  const TriangleSurface& fine_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index>> held_;    ///< one per triangle: see `position`
  std::vector<std::vector<Index>> around_;  ///< one per vertex: its triangles
  std::vector<char> removed_;
  std::vector<Index> ring_, other_ring_;
};

}  // namespace detail

/// `fine` without the vertices that it is flat at, as far as well-shaped triangles allow.
/// Requires a closed manifold. Linear time for surfaces of bounded degree.
inline CoarseSurface without_flat_vertices(const TriangleSurface& fine) {
  return detail::FlatVertexRemoval(fine).run();
}

}  // namespace mgf
