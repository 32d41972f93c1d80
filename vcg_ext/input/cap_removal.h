// SPDX-License-Identifier: GPL-3.0-or-later
// Takes faces without area out of a surface by edge flips that don't move it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/triangle_predicates.h"

namespace mgf {

/// Flips the longest side of collinear faces ("caps": a corner b on the opposite side ca) while
/// that helps. The neighbour acd becomes abd and bcd, which cover the same triangle, so the surface
/// stays as it is and closed where it was.
class CapRemoval {
 public:
  /// Requires the corners of each face to differ in position.
  explicit CapRemoval(TriangleSurface& surface) : surface_(surface) {
    for (Index f = 0; f < surface_.triangles.size(); ++f) {
      if (is_cap(f)) caps_.push_back(f);
    }
    if (!caps_.empty()) index_sides();
  }

  /// One entry per flip: the cap, and the face that both now are parts of.
  const std::vector<std::array<Index, 2>>& flips() const { return flips_; }
  /// The faces that are collinear: at first all, after `run` those that resist. Ascending.
  const std::vector<Index>& caps() const { return caps_; }

  /// Flips until no flip is possible. Each replaces a side by a shorter one within a line, or
  /// leaves fewer caps, so it ends. A surface with an edge that two faces run along the same way
  /// is left alone.
  void run() {
    bool changed = simple_;
    while (changed) {
      changed = false;
      for (const Index f : caps_) changed = flip(f) || changed;
      caps_.erase(std::remove_if(caps_.begin(), caps_.end(), [&](Index f) { return !is_cap(f); }),
                  caps_.end());
    }
  }

 private:
  static std::uint64_t key(Index from, Index to) {
    return (static_cast<std::uint64_t>(from) << 32U) | to;
  }

  bool is_cap(Index f) const {
    const Triangle& t = surface_.triangles[f];
    return exact::collinear(surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]);
  }

  void index_sides() {
    face_along_.reserve(3 * surface_.triangles.size());
    for (Index f = 0; f < surface_.triangles.size(); ++f) {
      const Triangle& t = surface_.triangles[f];
      for (std::size_t i = 0; i < 3; ++i) {
        simple_ = face_along_.emplace(key(t[i], t[(i + 1) % 3]), f).second && simple_;
      }
    }
  }

  /// The corner of a cap between the other two: on a line the lexicographic order is the line's.
  std::size_t middle_corner(Index f) const {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      const Vec3& p = surface_.points[surface_.triangles[f][i]];
      const Vec3& q = surface_.points[surface_.triangles[f][j]];
      return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    });
    return order[1];
  }

  bool flip(Index f) {
    if (!is_cap(f)) return false;
    const std::size_t middle = middle_corner(f);
    const Index b = surface_.triangles[f][middle];
    const Index c = surface_.triangles[f][(middle + 1) % 3];
    const Index a = surface_.triangles[f][(middle + 2) % 3];
    const auto across = face_along_.find(key(a, c));
    if (across == face_along_.end()) return false;
    const Index g = across->second;
    const Index d = third_corner(g, a, c);
    const bool needs_its_own_flip_first = is_cap(g) && surface_.triangles[g][middle_corner(g)] != d;
    if (d == b || needs_its_own_flip_first || face_along_.count(key(b, d)) != 0 ||
        face_along_.count(key(d, b)) != 0) {
      return false;
    }
    face_along_.erase(key(a, c));
    face_along_.erase(key(c, a));
    place(f, {a, b, d});
    place(g, {b, c, d});
    flips_.push_back({f, g});
    return true;
  }

  Index third_corner(Index f, Index a, Index c) const {
    for (const Index v : surface_.triangles[f]) {
      if (v != a && v != c) return v;
    }
    return kNone;
  }

  void place(Index f, const Triangle& t) {
    surface_.triangles[f] = t;
    for (std::size_t i = 0; i < 3; ++i) face_along_[key(t[i], t[(i + 1) % 3])] = f;
  }

  TriangleSurface& surface_;
  std::vector<Index> caps_;
  std::vector<std::array<Index, 2>> flips_;
  std::unordered_map<std::uint64_t, Index> face_along_;  // the face that a directed side belongs to
  bool simple_ = true;
};

}  // namespace mgf
