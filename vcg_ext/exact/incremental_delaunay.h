// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay tetrahedralisation point by point (Bowyer 1981, Watson 1981) on flat arrays: the
// tetrahedra whose spheres hold the new point make way for its star.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/delaunay.h"
#include "vcg_ext/exact/predicates.h"

namespace mgf {

/// Whether e lies inside the sphere through a, b, c, d. Points on the sphere count by a symbolic
/// perturbation that depends on the coordinates alone (Devillers and Teillaud 2003), the one that
/// CGAL uses. Requires abcd to be positively oriented and the five points to differ. Exact.
inline bool in_perturbed_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                const Vec3& e) {
  if (const int side = in_sphere(a, b, c, d, e); side != 0) return side > 0;
  std::array<const Vec3*, 5> ascending{&a, &b, &c, &d, &e};
  std::sort(ascending.begin(), ascending.end(), [](const Vec3* p, const Vec3* q) {
    return std::lexicographical_compare(p->data(), p->data() + 3, q->data(), q->data() + 3);
  });
  for (std::size_t i = 4; i > 2; --i) {  // the last or the last but one decides
    if (ascending[i] == &e) return false;
    int side = 0;
    if (ascending[i] == &a) side = orient3d(e, b, c, d);
    if (ascending[i] == &b) side = orient3d(a, e, c, d);
    if (ascending[i] == &c) side = orient3d(a, b, e, d);
    if (ascending[i] == &d) side = orient3d(a, b, c, e);
    if (side != 0) return side > 0;
  }
  return false;
}

/// A Delaunay tetrahedralisation that grows by points inside it.
class IncrementalDelaunay {
 public:
  /// Starts from the Delaunay tetrahedralisation `hull` of some of the points. Refers to `points`,
  /// which must outlive it.
  IncrementalDelaunay(const std::vector<Vec3>& points, TetrahedronArrays hull)
      : points_(points),
        corners_(std::move(hull.corners)),
        neighbours_(std::move(hull.neighbours)),
        mark_(corners_.size(), 0),
        local_(points.size(), kNone),
        side_at_(kFew * kFew, kNoSide) {
    constexpr std::size_t kPerPoint = 7;
    corners_.reserve(kPerPoint * points.size());
    neighbours_.reserve(kPerPoint * points.size());
    mark_.reserve(kPerPoint * points.size());
  }

  /// Inserts point number v, which must lie strictly inside the hull; false if there is a vertex at
  /// its place. Fast if the point inserted before lies near.
  bool insert(Index v) {
    const Vec3& p = points_[v];
    const Index first = locate(p);
    for (const Index corner : corners_[first]) {
      if (points_[corner] == p) return false;
    }
    find_conflicts(p, first);
    make_star(v);
    return true;
  }

  /// The tetrahedra, with free slots between them, whose first corner is kNone.
  const std::vector<Tetrahedron>& corners() const { return corners_; }
  const std::vector<std::array<Index, 4>>& neighbours() const { return neighbours_; }

 private:
  // A face between the tetrahedra in conflict and the others: a new tetrahedron.
  struct Wall {
    Tetrahedron corners;  // the new vertex instead of the one that lay opposite the face
    std::uint8_t apex;    // where
    std::uint8_t back;    // the face as seen from outside
    Index outside;        // kNone: it's of the hull
  };
  // A face of a new tetrahedron at the new vertex.
  struct Side {
    Index tetrahedron;
    std::uint8_t face;
  };

  static constexpr std::size_t kFew = 64;  // vertices of a usual conflict zone, at most
  static constexpr Side kNoSide{kNone, 0};

  // kOpposite[i][j] = (k, l) such that i, j, k, l is an even permutation of 0, 1, 2, 3.
  static constexpr std::array<std::array<std::array<std::uint8_t, 2>, 4>, 4> kOpposite = {
      {{{{{9, 9}}, {{2, 3}}, {{3, 1}}, {{1, 2}}}},
       {{{{3, 2}}, {{9, 9}}, {{0, 3}}, {{2, 0}}}},
       {{{{1, 3}}, {{3, 0}}, {{9, 9}}, {{0, 1}}}},
       {{{{2, 1}}, {{0, 2}}, {{1, 0}}, {{9, 9}}}}}};

  // Whether p lies beyond the face of t opposite corner i.
  bool is_beyond(const Vec3& p, Index t, unsigned i) const {
    std::array<const Vec3*, 4> at{};
    for (unsigned k = 0; k < 4; ++k) at[k] = &points_[corners_[t][k]];
    at[i] = &p;
    return orient3d(*at[0], *at[1], *at[2], *at[3]) < 0;
  }

  // A tetrahedron with p, by a walk through faces that p lies beyond; that ends, as the
  // tetrahedralisation is Delaunay.
  Index locate(const Vec3& p) const {
    Index t = last_;
    Index from = kNone;
    for (;;) {
      unsigned i = 0;
      while (i < 4 &&
             (neighbours_[t][i] == kNone || neighbours_[t][i] == from || !is_beyond(p, t, i))) {
        ++i;
      }
      if (i == 4) return t;
      from = std::exchange(t, neighbours_[t][i]);
    }
  }

  bool is_in_conflict(const Vec3& p, Index t) const {
    const Tetrahedron& c = corners_[t];
    return in_perturbed_sphere(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]], p);
  }

  // Collects the tetrahedra whose spheres hold p, and the walls round them.
  void find_conflicts(const Vec3& p, Index first) {
    epoch_ += 2;  // its marks: epoch_ in conflict, epoch_ + 1 not
    conflicts_.assign(1, first);
    mark_[first] = epoch_;
    walls_.clear();
    for (std::size_t next = 0; next < conflicts_.size(); ++next) {
      const Index t = conflicts_[next];
      for (unsigned i = 0; i < 4; ++i) {
        const Index u = neighbours_[t][i];
        if (u != kNone && mark_[u] < epoch_) {
          const bool in_conflict = is_in_conflict(p, u);
          mark_[u] = in_conflict ? epoch_ : epoch_ + 1;
          if (in_conflict) conflicts_.push_back(u);
        }
        if (u != kNone && mark_[u] == epoch_) continue;
        walls_.push_back({corners_[t], static_cast<std::uint8_t>(i),
                          u == kNone ? std::uint8_t{0} : back_face(u, t), u});
      }
    }
  }

  std::uint8_t back_face(Index u, Index t) const {
    std::uint8_t i = 0;
    while (neighbours_[u][i] != t) ++i;
    return i;
  }

  // Replaces the tetrahedra in conflict by those between the walls and v.
  void make_star(Index v) {
    free_.insert(free_.end(), conflicts_.rbegin(), conflicts_.rend());
    zone_.clear();
    wide_sides_.clear();
    for (Wall& wall : walls_) {
      const Index t = take_slot();
      wall.corners[wall.apex] = v;
      corners_[t] = wall.corners;
      mark_[t] = 0;
      neighbours_[t][wall.apex] = wall.outside;
      if (wall.outside != kNone) neighbours_[wall.outside][wall.back] = t;
      for (std::uint8_t face = 0; face < 4; ++face) {
        if (face == wall.apex) continue;
        const auto [k, l] = kOpposite[wall.apex][face];
        glue(wall.corners[k], wall.corners[l], {t, face});
      }
      last_ = t;
    }
    for (const Index corner : zone_) local_[corner] = kNone;
    glue_wide_sides();
    for (const Index t : free_) corners_[t].fill(kNone);
  }

  Index take_slot() {
    if (!free_.empty()) {
      const Index t = free_.back();
      free_.pop_back();
      return t;
    }
    corners_.emplace_back();
    neighbours_.emplace_back();
    mark_.push_back(0);
    return to_index(corners_.size() - 1);
  }

  // Glues the side on the edge from x to y of the zone to the one on the edge from y to x, which
  // waits for it or will come.
  void glue(Index x, Index y, const Side& side) {
    const std::size_t i = local_number(x);
    const std::size_t j = local_number(y);
    if (i >= kFew || j >= kFew) {
      wide_sides_.push_back({{std::min(x, y), std::max(x, y)}, side});
      return;
    }
    Side& waiting = side_at_[kFew * j + i];
    if (waiting.tetrahedron == kNone) {
      side_at_[kFew * i + j] = side;
    } else {
      link(side, waiting);
      waiting = kNoSide;
    }
  }

  std::size_t local_number(Index vertex) {
    if (local_[vertex] == kNone) {
      local_[vertex] = to_index(zone_.size());
      zone_.push_back(vertex);
    }
    return local_[vertex];
  }

  void link(const Side& a, const Side& b) {
    neighbours_[a.tetrahedron][a.face] = b.tetrahedron;
    neighbours_[b.tetrahedron][b.face] = a.tetrahedron;
  }

  // Those on edges with a vertex that the table has no place for.
  void glue_wide_sides() {
    std::sort(wide_sides_.begin(), wide_sides_.end(),
              [](const WideSide& a, const WideSide& b) { return a.edge < b.edge; });
    for (std::size_t i = 0; i + 1 < wide_sides_.size(); i += 2) {
      link(wide_sides_[i].side, wide_sides_[i + 1].side);
    }
  }

  struct WideSide {
    std::array<Index, 2> edge;
    Side side;
  };

  const std::vector<Vec3>& points_;
  std::vector<Tetrahedron> corners_;  // kNone: a free slot
  std::vector<std::array<Index, 4>> neighbours_;
  std::vector<std::uint32_t> mark_;  // of the last conflict zone that a tetrahedron was asked about
  std::uint32_t epoch_ = 0;
  std::vector<Index> free_;
  Index last_ = 0;  // where to look for the next point first
  // Workspace of `insert`.
  std::vector<Index> conflicts_;
  std::vector<Wall> walls_;
  std::vector<Index> zone_;    // the vertices of the conflict zone
  std::vector<Index> local_;   // their place in it, one per point; kNone for others
  std::vector<Side> side_at_;  // of edges of the zone, by place of both ends
  std::vector<WideSide> wide_sides_;
};

}  // namespace mgf
