// SPDX-License-Identifier: GPL-3.0-or-later
// A tetrahedral mesh that can be changed piece by piece, and taken back.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/exact_points.h"
#include "vcg_ext/exact/predicates.h"

namespace mgf {

/// Corners of the face opposite corner i of a positive tetrahedron, anticlockwise from outside.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFaceCorners = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// kEvenThird[i][j] = k such that (i, j, k, 6 - i - j - k) is an even permutation of 0, 1, 2, 3.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> kEvenThird = {
    {{9, 2, 3, 1}, {3, 9, 0, 2}, {1, 3, 9, 0}, {2, 0, 1, 9}}};

/// The position of v among the corners; 4 if it is none of them.
inline unsigned corner_index(const Tetrahedron& corners, Index v) {
  unsigned i = 0;
  while (i < 4 && corners[i] != v) ++i;
  return i;
}

/// The face opposite corner i, outward.
inline Triangle face_of(const Tetrahedron& corners, unsigned i) {
  return {corners[kFaceCorners[i][0]], corners[kFaceCorners[i][1]], corners[kFaceCorners[i][2]]};
}

/// Whether face i of s is face j of t, seen from the other side.
inline bool is_glued(const Tetrahedron& s, unsigned i, const Tetrahedron& t, unsigned j) {
  const Triangle f = face_of(s, i);
  const Triangle g = face_of(t, j);
  for (std::size_t k = 0; k < 3; ++k) {
    if (g[k] == f[0]) return g[(k + 1) % 3] == f[2] && g[(k + 2) % 3] == f[1];
  }
  return false;
}

/// The tetrahedra round an edge xy: tetrahedron i has the corners x, y, link[i], link[i + 1], in
/// positive order, and link is cyclic.
struct EdgeRing {
  std::vector<Index> tetrahedra;
  std::vector<Index> link;
};

/// Memory of walks through a mesh; one per thread.
class MeshWalk {
 public:
  /// Forgets where it has been, in a mesh of that many slots.
  void begin(std::size_t slots) {
    visits_.resize(std::max(visits_.size(), slots), 0);
    ++epoch_;
    found_.clear();
  }
  /// Whether it has been there. `visit` says that it is now.
  bool has_visited(Index t) const { return visits_[t] == epoch_; }
  void visit(Index t) { visits_[t] = epoch_; }
  /// Visits t, which is to be walked on from.
  void find(Index t) {
    visit(t);
    found_.push_back(t);
  }
  /// All that is to be walked on from, so far.
  const std::vector<Index>& found() const { return found_; }

 private:
  std::vector<std::uint32_t> visits_;  // one per slot: epoch of the last
  std::uint32_t epoch_ = 0;
  std::vector<Index> found_;
};

/// Tetrahedra with adjacency. All changes go through `replace`, which exchanges the tetrahedra of a
/// ball for others that fill the same ball; bistellar moves and point insertions are its special
/// cases. Since the boundary of the ball stays, the mesh remains a triangulation of the same
/// manifold whatever the coordinates are. While a journal is open, changes can be rolled back.
class TetrahedralMesh {
 public:
  TetrahedralMesh(std::vector<Vec3> points, std::vector<Tetrahedron> corners,
                  std::vector<std::array<Index, 4>> neighbours)
      : points_(std::move(points)),
        corners_(std::move(corners)),
        neighbours_(std::move(neighbours)),
        changed_(corners_.size(), 0),
        tetrahedron_at_(points_.size(), kNone) {
    for (Index t = 0; t < corners_.size(); ++t) {
      for (const Index v : corners_[t]) tetrahedron_at_[v] = t;
    }
  }

  const std::vector<Vec3>& points() const { return points_; }
  const Vec3& point(Index v) const { return points_[v]; }
  std::size_t slot_count() const { return corners_.size(); }  ///< alive or not
  bool alive(Index t) const { return corners_[t][0] != kNone; }
  const Tetrahedron& corners(Index t) const { return corners_[t]; }
  Index neighbour(Index t, unsigned i) const { return neighbours_[t][i]; }

  /// As `orient3d`, for exact points as well.
  int orientation(Index a, Index b, Index c, Index d) const {
    if (exact_ && std::max(std::max(a, b), std::max(c, d)) >= first_exact_) {
      return exact_->orientation(a, b, c, d);
    }
    return orient3d(points_[a], points_[b], points_[c], points_[d]);
  }

  /// Whether v has exact coordinates, of which `point` gives the nearest doubles.
  bool is_exact(Index v) const { return v >= first_exact_; }
  /// How many have.
  std::size_t exact_point_count() const { return exact_ ? points_.size() - first_exact_ : 0; }

  /// Adds a point that belongs to no tetrahedron yet.
  Index add_point(const Vec3& p) {
    points_.push_back(p);
    tetrahedron_at_.push_back(kNone);
    return to_index(points_.size() - 1);
  }

  /// As `ExactPoints::add_on_segment`, of a point that belongs to no tetrahedron yet. All points
  /// added from now on must be exact.
  Index add_point_on_segment(Index a, Index b, const Triangle& xyz, unsigned bits) {
    return add_point(exact_points().add_on_segment(a, b, xyz, bits));
  }

  /// As `ExactPoints::add_on_triangle`, likewise.
  Index add_point_on_triangle(const Triangle& abc, Index p, Index q, unsigned bits) {
    return add_point(exact_points().add_on_triangle(abc, p, q, bits));
  }

  /// Takes back the last point added, which no tetrahedron has.
  void drop_last_point() {
    if (is_exact(to_index(points_.size() - 1))) exact_->drop_last();
    points_.pop_back();
    tetrahedron_at_.pop_back();
  }

  /// A tetrahedron at v whose corners satisfy `wanted`, or kNone.
  template <class Wanted>
  Index find_at(Index v, const Wanted& wanted) const {
    return find_at(v, walk_, wanted);
  }
  /// The same for threads that each have a `walk` of their own.
  template <class Wanted>
  Index find_at(Index v, MeshWalk& walk, const Wanted& wanted) const {
    Index found = kNone;
    walk_star(v, walk, [&](Index t) {
      if (wanted(corners_[t])) found = t;
      return found == kNone;
    });
    return found;
  }

  std::vector<Index> star(Index v) const {
    std::vector<Index> result;
    walk_star(v, walk_, [&](Index t) {
      result.push_back(t);
      return true;
    });
    return result;
  }

  /// Calls `visit` with the corners of each tetrahedron at v; for threads that each have a `walk`
  /// of their own.
  template <class Visit>
  void visit_star(Index v, MeshWalk& walk, const Visit& visit) const {
    walk_star(v, walk, [&](Index t) {
      visit(corners_[t]);
      return true;
    });
  }

  /// A tetrahedron with the edge ab, or kNone.
  Index find_edge(Index a, Index b) const { return find_edge(a, b, walk_); }
  /// The same for threads that each have a `walk` of their own.
  Index find_edge(Index a, Index b, MeshWalk& walk) const {
    return find_at(a, walk, [&](const Tetrahedron& t) { return corner_index(t, b) < 4; });
  }

  /// A tetrahedron with the face abc, or kNone.
  Index find_face(Index a, Index b, Index c) const {
    return find_at(
        a, [&](const Tetrahedron& t) { return corner_index(t, b) < 4 && corner_index(t, c) < 4; });
  }

  /// Fills `ring` with the tetrahedra round the edge xy of tetrahedron t. False, with the ring
  /// unfinished, if the edge is on the hull or has more than `limit` tetrahedra.
  bool ring_of(Index t, Index x, Index y, std::size_t limit, EdgeRing& ring) const {
    ring.tetrahedra.clear();
    ring.link.clear();
    const Index first = t;
    do {
      if (ring.tetrahedra.size() == limit) return false;
      const Tetrahedron& c = corners_[t];
      const unsigned i = corner_index(c, x);
      const unsigned j = corner_index(c, y);
      const unsigned k = kEvenThird[i][j];
      ring.tetrahedra.push_back(t);
      ring.link.push_back(c[k]);
      t = neighbours_[t][k];
    } while (t != kNone && t != first);
    return t == first;
  }

  /// Exchanges the tetrahedra `old` for `made`, which must fill the same ball. Returns the numbers
  /// of the new ones.
  std::vector<Index> replace(const std::vector<Index>& old, const std::vector<Tetrahedron>& made) {
    std::vector<Index> numbers(
        old.begin(), old.begin() + static_cast<std::ptrdiff_t>(std::min(old.size(), made.size())));
    while (numbers.size() < made.size()) numbers.push_back(take_slot());
    if (journal_open_) {
      Change change{old, {}, numbers};
      for (const Index t : old) change.corners.push_back(corners_[t]);
      journal_.push_back(std::move(change));
    }
    exchange(old, numbers, made);
    free_.insert(free_.end(),
                 old.begin() + static_cast<std::ptrdiff_t>(std::min(old.size(), made.size())),
                 old.end());
    return numbers;
  }

  /// Whether t was made by `replace`.
  bool changed(Index t) const { return changed_[t] != 0; }

  void open_journal() {
    journal_open_ = true;
    journal_.clear();
  }
  void close_journal() { journal_open_ = false; }
  std::size_t journal_mark() const { return journal_.size(); }

  /// Undoes all changes since the journal had `mark` entries, numbers of tetrahedra included.
  void roll_back(std::size_t mark) {
    while (journal_.size() > mark) {
      const Change change = std::move(journal_.back());
      journal_.pop_back();
      exchange(change.made, change.removed, change.corners);
      // The slots that `replace` took, back in the order that makes the next undo find its own.
      const std::size_t kept = std::min(change.made.size(), change.removed.size());
      free_.resize(free_.size() - (change.removed.size() - kept));
      for (std::size_t i = change.made.size(); i > kept; --i) free_.push_back(change.made[i - 1]);
    }
  }

 private:
  ExactPoints& exact_points() {
    if (!exact_) {
      exact_ = std::make_unique<ExactPoints>(points_);
      first_exact_ = to_index(points_.size());
    }
    return *exact_;
  }

  struct Change {
    std::vector<Index> removed;
    std::vector<Tetrahedron> corners;  // of `removed`
    std::vector<Index> made;
  };
  struct OpenFace {
    Triangle key;       // corners, ascending
    Index tetrahedron;  // kNone: the hull's outside
    unsigned index;     // of the face in it
  };

  static Triangle sorted(Triangle t) {
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    if (t[1] > t[2]) std::swap(t[1], t[2]);
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    return t;
  }

  unsigned back_index(Index t, Index neighbour) const {
    unsigned i = 0;
    while (neighbours_[t][i] != neighbour) ++i;
    return i;
  }

  template <class Visit>
  void walk_star(Index v, MeshWalk& walk, const Visit& visit) const {
    const Index first = tetrahedron_at_[v];
    if (first == kNone) return;
    walk.begin(slot_count());
    walk.find(first);
    for (std::size_t next = 0; next < walk.found().size(); ++next) {
      const Index t = walk.found()[next];
      if (!visit(t)) return;
      const Tetrahedron& c = corners_[t];
      for (unsigned i = 0; i < 4; ++i) {
        const Index n = neighbours_[t][i];
        if (c[i] != v && n != kNone && !walk.has_visited(n)) walk.find(n);
      }
    }
  }

  Index take_slot() {
    if (!free_.empty()) {
      const Index t = free_.back();
      free_.pop_back();
      return t;
    }
    corners_.push_back({kNone, kNone, kNone, kNone});
    neighbours_.push_back({kNone, kNone, kNone, kNone});
    changed_.push_back(0);
    return to_index(corners_.size() - 1);
  }

  // Takes the tetrahedra `old` out and puts `made` in their place, into the slots `numbers`.
  void exchange(const std::vector<Index>& old, const std::vector<Index>& numbers,
                const std::vector<Tetrahedron>& made) {
    walk_.begin(slot_count());
    for (const Index t : old) walk_.visit(t);
    faces_.clear();
    for (const Index t : old) {
      for (unsigned i = 0; i < 4; ++i) {
        const Index n = neighbours_[t][i];
        if (n != kNone && walk_.has_visited(n)) continue;
        faces_.push_back({sorted(face_of(corners_[t], i)), n, n == kNone ? 0 : back_index(n, t)});
      }
    }
    for (const Index t : old) {
      for (const Index v : corners_[t]) tetrahedron_at_[v] = kNone;
      corners_[t].fill(kNone);
    }
    for (std::size_t k = 0; k < made.size(); ++k) {
      const Index t = numbers[k];
      corners_[t] = made[k];
      neighbours_[t].fill(kNone);
      changed_[t] = 1;
      for (const Index v : made[k]) tetrahedron_at_[v] = t;
      for (unsigned i = 0; i < 4; ++i) faces_.push_back({sorted(face_of(made[k], i)), t, i});
    }
    link_faces();
  }

  // Pairs equal faces; each occurs twice.
  void link_faces() {
    std::sort(faces_.begin(), faces_.end(),
              [](const OpenFace& f, const OpenFace& g) { return f.key < g.key; });
    for (std::size_t i = 0; i + 1 < faces_.size(); i += 2) {
      const OpenFace& f = faces_[i];
      const OpenFace& g = faces_[i + 1];
      if (f.tetrahedron != kNone) neighbours_[f.tetrahedron][f.index] = g.tetrahedron;
      if (g.tetrahedron != kNone) neighbours_[g.tetrahedron][g.index] = f.tetrahedron;
    }
  }

  std::vector<Vec3> points_;
  std::unique_ptr<ExactPoints> exact_;  // all points, once there is an exact one
  Index first_exact_ = kNone;           // all from here on are
  std::vector<Tetrahedron> corners_;
  std::vector<std::array<Index, 4>> neighbours_;
  std::vector<char> changed_;
  std::vector<Index> tetrahedron_at_;  // one of each vertex
  std::vector<Index> free_;
  std::vector<OpenFace> faces_;  // workspace of `replace`
  mutable MeshWalk walk_;
  std::vector<Change> journal_;
  bool journal_open_ = false;
};

}  // namespace mgf
