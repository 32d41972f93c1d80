// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles that a tetrahedral mesh has to contain, with the few changes recovery makes to
// them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A set of oriented triangles with, per vertex, the faces at it. It need not be manifold: the
/// seams of a self-intersecting surface have four faces at an edge, and faces may coincide.
/// Queries cost the number of faces at a vertex.
class ConstrainedSurface {
 public:
  /// Of no vertices and no faces.
  ConstrainedSurface() = default;

  /// `point_count` is the number of vertices that may occur in `faces`.
  ConstrainedSurface(std::size_t point_count, std::vector<Triangle> faces)
      : faces_(std::move(faces)), faces_at_(point_count) {
    std::vector<Index> count(point_count, 0);
    for (const Triangle& face : faces_) {
      for (const Index v : face) ++count[v];
    }
    for (std::size_t v = 0; v < point_count; ++v) faces_at_[v].reserve(count[v]);
    for (Index f = 0; f < faces_.size(); ++f) {
      for (const Index v : faces_[f]) faces_at_[v].push_back(f);
    }
  }

  const std::vector<Triangle>& faces() const { return faces_; }
  const Triangle& face(Index f) const { return faces_[f]; }
  const std::vector<Index>& faces_at(Index v) const { return faces_at_[v]; }

  static bool has_corner(const Triangle& face, Index v) {
    return face[0] == v || face[1] == v || face[2] == v;
  }

  /// The corner of `face` besides a and b, which must be corners of it.
  static Index third_corner(const Triangle& face, Index a, Index b) {
    for (const Index v : face) {
      if (v != a && v != b) return v;
    }
    return kNone;
  }

  bool has_edge(Index a, Index b) const {
    if (faces_at_[a].size() > faces_at_[b].size()) std::swap(a, b);
    return std::any_of(faces_at_[a].begin(), faces_at_[a].end(),
                       [&](Index f) { return has_corner(faces_[f], b); });
  }

  /// The first face with these corners in any order, or kNone.
  Index find_face(Index a, Index b, Index c) const {
    if (faces_at_[a].size() > faces_at_[b].size()) std::swap(a, b);
    for (const Index f : faces_at_[a]) {
      if (has_corner(faces_[f], b) && has_corner(faces_[f], c)) return f;
    }
    return kNone;
  }
  bool has_face(Index a, Index b, Index c) const { return find_face(a, b, c) != kNone; }

  /// The faces with the edge ab.
  std::vector<Index> faces_at_edge(Index a, Index b) const {
    std::vector<Index> result;
    for (const Index f : faces_at_[a]) {
      if (has_corner(faces_[f], b)) result.push_back(f);
    }
    return result;
  }

  /// Replaces the faces f = abc and g = bad by cad and dbc. Requires that cd is no edge yet.
  void flip_edge(Index f, Index g, Index a, Index b) {
    const Index c = third_corner(faces_[f], a, b);
    const Index d = third_corner(faces_[g], a, b);
    const bool forward = follows(faces_[f], a, b);  // ab runs in this order round f
    replace_face(f, forward ? Triangle{c, a, d} : Triangle{c, d, a});
    replace_face(g, forward ? Triangle{d, b, c} : Triangle{d, c, b});
  }

  /// Makes room for one more vertex.
  void add_vertex() { faces_at_.emplace_back(); }

  /// Adds a face; two corners may be equal, as of a mere edge to be kept.
  Index add_face(const Triangle& face) {
    const Index f = to_index(faces_.size());
    faces_.push_back(face);
    for (const Index v : face) {
      if (faces_at_[v].empty() || faces_at_[v].back() != f) faces_at_[v].push_back(f);
    }
    return f;
  }

  /// Halves all faces at the edge ab by the new vertex m. Returns the faces that changed or are
  /// new.
  std::vector<Index> split_edge(Index a, Index b, Index m) {
    std::vector<Index> changed = faces_at_edge(a, b);
    const std::size_t count = changed.size();
    for (std::size_t i = 0; i < count; ++i) {
      Triangle half = faces_[changed[i]];
      Triangle other = half;
      std::replace(half.begin(), half.end(), b, m);
      std::replace(other.begin(), other.end(), a, m);
      replace_face(changed[i], half);
      changed.push_back(add_face(other));
    }
    return changed;
  }

  /// Cuts all faces with the corners abc into three at the new vertex m. Returns the faces that
  /// changed or are new.
  std::vector<Index> split_face(Index a, Index b, Index c, Index m) {
    std::vector<Index> changed;
    for (const Index f : faces_at_edge(a, b)) {
      if (has_corner(faces_[f], c)) changed.push_back(f);
    }
    const std::size_t count = changed.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Triangle whole = faces_[changed[i]];
      replace_face(changed[i], {whole[0], whole[1], m});
      changed.push_back(add_face({whole[1], whole[2], m}));
      changed.push_back(add_face({whole[2], whole[0], m}));
    }
    return changed;
  }

 private:
  static bool follows(const Triangle& face, Index a, Index b) {
    return (face[0] == a && face[1] == b) || (face[1] == a && face[2] == b) ||
           (face[2] == a && face[0] == b);
  }

  void replace_face(Index f, const Triangle& face) {
    for (const Index v : faces_[f]) {
      if (has_corner(face, v)) continue;
      std::vector<Index>& list = faces_at_[v];
      list.erase(std::find(list.begin(), list.end(), f));
    }
    for (const Index v : face) {
      if (!has_corner(faces_[f], v)) faces_at_[v].push_back(f);
    }
    faces_[f] = face;
  }

  std::vector<Triangle> faces_;
  std::vector<std::vector<Index>> faces_at_;
};

}  // namespace mgf
