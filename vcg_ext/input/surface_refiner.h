// SPDX-License-Identifier: GPL-3.0-or-later
// Local changes of a closed surface that leave its point set as it is: splits of edges and faces,
// flips within a face of the input.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/input/edge_table.h"
#include "vcg_ext/input/refined_surface.h"

namespace mgf {

/// A closed manifold surface under refinement. Side 3 f + i of face f runs from its corner i to the
/// next one and has a twin, the same edge seen from the other face. Vertices and faces are only
/// ever added at the end; a face that is split keeps its number for one of its parts.
class SurfaceRefiner {
 public:
  /// Requires a closed, consistently oriented manifold. O(n log n).
  explicit SurfaceRefiner(RefinedSurface surface) : refined_(std::move(surface)) {
    twin_.assign(3 * triangles().size(), kNone);
    const EdgeTable edges = make_edge_table(triangles());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      assert(edges.sides[e].size() == 2);
      const FaceSide& s = edges.sides[e][0];
      const FaceSide& t = edges.sides[e][1];
      link(3 * s.face + s.side, 3 * t.face + t.side);
    }
  }

  const RefinedSurface& surface() const { return refined_; }
  RefinedSurface release() && { return std::move(refined_); }

  const std::vector<Triangle>& triangles() const { return refined_.surface.triangles; }
  const Vec3& point(Index vertex) const { return refined_.surface.points[vertex]; }
  Index side_count() const { return to_index(twin_.size()); }
  Index twin(Index side) const { return twin_[side]; }
  Index start(Index side) const { return triangles()[side / 3][side % 3]; }
  Index end(Index side) const { return start(next(side)); }
  Index opposite(Index side) const { return start(next(next(side))); }
  Index parent(Index face) const { return refined_.parent_face[face]; }
  double length(Index side) const { return (point(end(side)) - point(start(side))).norm(); }
  static Index next(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }

  /// Splits an edge at `position`, which should lie on it: faces abc and bad become amc, mbc, bmd
  /// and mad, the last of each two new. Gives the new vertex m.
  Index split_edge(Index side, const Vec3& position) {
    const Index other = twin_[side];
    const Index m = add_point(position);
    const auto [near_a, near_b] = halve(side, m);
    const auto [far_b, far_a] = halve(other, m);
    link(near_a, far_a);
    link(near_b, far_b);
    return m;
  }

  /// Splits a face at `position`, which should lie within it: abc becomes abm, and the new bcm and
  /// cam. Gives the new vertex m.
  Index split_face(Index face, const Vec3& position) {
    const Index m = add_point(position);
    const auto [a, b, c] = triangles()[face];
    const Index twin_bc = twin_[3 * face + 1];
    const Index twin_ca = twin_[3 * face + 2];
    const Index bcm = add_face({b, c, m}, parent(face));
    const Index cam = add_face({c, a, m}, parent(face));
    refined_.surface.triangles[face] = {a, b, m};
    link(3 * bcm, twin_bc);
    link(3 * cam, twin_ca);
    link(3 * face + 1, 3 * bcm + 2);
    link(3 * bcm + 1, 3 * cam + 2);
    link(3 * cam + 1, 3 * face + 2);
    return m;
  }

  /// Flips an edge whose two faces are parts of one face of the input if the other diagonal is
  /// better in the sense of Delaunay; false if not. Flips come to an end even where rounding has
  /// put the parts of a face out of one plane: each lowers the sum of all cotangents.
  bool flip_if_better(Index side) {
    const Index other = twin_[side];
    const Index f = side / 3;
    const Index g = other / 3;
    if (parent(f) != parent(g)) return false;
    const Index a = start(side);
    const Index b = end(side);
    const Index c = opposite(side);
    const Index d = opposite(other);
    // Cotangents of the angles at c and d sum up to less than 0 if the angles exceed a half turn;
    // the margin leaves cocircular corners alone.
    constexpr double kMargin = 1e-9;
    if (cotangent(c, a, b) + cotangent(d, a, b) >= -kMargin) return false;
    const double before = cotangents({a, b, c}) + cotangents({b, a, d});
    if (!(cotangents({d, c, a}) + cotangents({c, d, b}) < before)) return false;
    const Index twin_bc = twin_[next(side)];
    const Index twin_ca = twin_[next(next(side))];
    const Index twin_ad = twin_[next(other)];
    const Index twin_db = twin_[next(next(other))];
    refined_.surface.triangles[f] = {d, c, a};
    refined_.surface.triangles[g] = {c, d, b};
    link(3 * f, 3 * g);
    link(3 * f + 1, twin_ca);
    link(3 * f + 2, twin_ad);
    link(3 * g + 1, twin_db);
    link(3 * g + 2, twin_bc);
    return true;
  }

 private:
  void link(Index side, Index other) {
    twin_[side] = other;
    twin_[other] = side;
  }

  Index add_point(const Vec3& position) {
    refined_.surface.points.push_back(position);
    return to_index(refined_.surface.points.size() - 1);
  }

  Index add_face(const Triangle& corners, Index parent_face) {
    refined_.surface.triangles.push_back(corners);
    refined_.parent_face.push_back(parent_face);
    twin_.resize(twin_.size() + 3, kNone);
    return to_index(triangles().size() - 1);
  }

  /// Cuts the face of `side` ab from its corner c to m. Gives the sides am and mb.
  std::pair<Index, Index> halve(Index side, Index m) {
    const Index f = side / 3;
    const Index a = start(side);
    const Index b = end(side);
    const Index c = opposite(side);
    const Index twin_bc = twin_[next(side)];
    const Index twin_ca = twin_[next(next(side))];
    const Index half = add_face({m, b, c}, parent(f));
    refined_.surface.triangles[f] = {a, m, c};
    link(3 * half + 1, twin_bc);
    link(3 * f + 2, twin_ca);
    link(3 * f + 1, 3 * half + 2);
    return {3 * f, 3 * half};
  }

  double cotangent(Index at, Index from, Index to) const {
    const Vec3 u = point(from) - point(at);
    const Vec3 v = point(to) - point(at);
    return u.dot(v) / u.cross(v).norm();
  }

  // Of all angles of a face; the same to the bit in whatever order its corners are given.
  double cotangents(Triangle face) const {
    std::sort(face.begin(), face.end());
    const Vec3 u = point(face[1]) - point(face[0]);
    const Vec3 v = point(face[2]) - point(face[0]);
    return (u.squaredNorm() + v.squaredNorm() + (u - v).squaredNorm()) / (2.0 * u.cross(v).norm());
  }

  RefinedSurface refined_;
  std::vector<Index> twin_;  // one per side
};

}  // namespace mgf
