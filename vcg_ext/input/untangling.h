// SPDX-License-Identifier: GPL-3.0-or-later
// Parts faces of a surface that cross near each other, by moving few vertices a little.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/box_tree.h"
#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/triangle_predicates.h"

namespace mgf {

/// What untangling did to a surface.
struct Untangling {
  std::size_t pairs_mended = 0;            ///< pairs of faces that crossed and no longer do
  std::vector<std::array<Index, 2>> left;  ///< pairs that still cross, ascending
  std::vector<Index> moved;                ///< vertices that are elsewhere now, ascending
  double largest_move = 0.0;               ///< mesh units
};

/// Relaxes the surface where it crosses itself until it doesn't: noise, folds, needles turned over,
/// sheets that graze each other. Crossing faces that hang together (by a crossing or a corner) are
/// a tangle. The corners of its faces are moved together, a quarter of the way towards the mean of
/// their neighbours, and so on with those that cross then, until by exact predicates no face that
/// moved crosses any other, but for pairs of other tangles that crossed before. Where 64 steps
/// don't get there, it starts again with one ring round these faces moved, too. (Of 240 noisy
/// meshes, with up to 38 000 crossings, that mended all; a second ring never helped.) No vertex
/// gets further away from where it was than twice the mean length of its edges, nor than a tenth of
/// the bounding box diagonal. A tangle that resists, such as limbs that pass deeply through each
/// other, is put back as it was; so is one of several shells, whose solids may be meant to overlap.
///
/// Connectivity, and so the genus, stays. Nothing passes through another sheet unless they crossed
/// before: a moving patch that does must cross it along its border, which stays, or swallow all the
/// rest of the surface or of another shell. Whether it has is for the caller to check (`Shells`).
///
/// `crossings` are the surface's self-intersections, ascending pairs i < j, ascending. Requires a
/// closed manifold without duplicate points and collinear faces, and leaves it so. The same for any
/// number of `threads` (0: all). Cost: 50 ns a face for a search tree, then about 15 us for each
/// face near a crossing.
Untangling untangle(TriangleSurface& surface, const std::vector<std::array<Index, 2>>& crossings,
                    unsigned threads = 0);

namespace untangling_detail {

using Pair = std::array<Index, 2>;

inline constexpr int kMostRings = 1;
inline constexpr int kSteps = 64;  // for each number of rings
inline constexpr double kStep = 0.25;
inline constexpr double kLongestMove = 2.0;   // mean lengths of a vertex' edges
inline constexpr double kLongestShare = 0.1;  // of the bounding box diagonal

/// The items, each once, ascending.
inline std::vector<Index> each_once(std::vector<Index> items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
  return items;
}

/// Vertices that were moved, and where from.
struct Patch {
  std::vector<Index> vertices;  ///< ascending
  std::vector<Vec3> start;

  /// Takes in those of `more`, ascending, that aren't in it.
  void add(const std::vector<Index>& more, const std::vector<Vec3>& points) {
    Patch merged;
    std::size_t i = 0;
    for (const Index v : more) {
      for (; i < vertices.size() && vertices[i] < v; ++i) merged.push_back(vertices[i], start[i]);
      if (i < vertices.size() && vertices[i] == v) continue;
      merged.push_back(v, points[v]);
    }
    for (; i < vertices.size(); ++i) merged.push_back(vertices[i], start[i]);
    *this = std::move(merged);
  }

 private:
  void push_back(Index v, const Vec3& p) {
    vertices.push_back(v);
    start.push_back(p);
  }
};

class Untangler {
 public:
  Untangler(TriangleSurface& surface, const std::vector<Pair>& crossings, unsigned threads)
      : surface_(surface),
        crossings_(crossings),
        threads_(thread_count(threads)),
        before_(surface.points),
        longest_share_(kLongestShare * bounding_box_diagonal(surface.points)),
        faces_at_(faces_by_corner(surface)),
        tree_(face_boxes(surface.points, surface.triangles)) {
    find_tangles();
  }

  Untangling run() {
    for (Index tangle = 0; tangle < tangles_.size(); ++tangle) {
      mended_[tangle] = mend(tangle) ? 1 : 0;
    }
    return outcome();
  }

 private:
  static Rows<Index> faces_by_corner(const TriangleSurface& surface) {
    Rows<Index> rows = group_by_key(corners(surface), surface.points.size());
    for (Index& corner : rows.items) corner /= 3;
    return rows;
  }
  static std::vector<Index> corners(const TriangleSurface& surface) {
    std::vector<Index> result;
    result.reserve(3 * surface.triangles.size());
    for (const Triangle& t : surface.triangles) result.insert(result.end(), t.begin(), t.end());
    return result;
  }
  static Box face_box(const TriangleSurface& surface, Index face) {
    const Triangle& t = surface.triangles[face];
    return box_of_triangle(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
  }

  // Groups the crossing faces; leaves out groups of several shells.
  void find_tangles() {
    DisjointSets joined(surface_.points.size());
    DisjointSets shells(surface_.points.size());
    for (const Triangle& t : surface_.triangles) {
      shells.join(t[0], t[1]);
      shells.join(t[0], t[2]);
    }
    std::vector<Index> crossing;
    for (const Pair& pair : crossings_) {
      const Index anchor = surface_.triangles[pair[0]][0];
      for (const Index f : pair) {
        for (const Index v : surface_.triangles[f]) joined.join(anchor, v);
        crossing.push_back(f);
      }
    }
    tangle_of_.assign(surface_.triangles.size(), kNone);
    std::vector<Index> tangle_of_root(surface_.points.size(), kNone);
    std::vector<Index> shell;
    for (const Index f : each_once(std::move(crossing))) {
      const Index corner = surface_.triangles[f][0];
      Index& tangle = tangle_of_root[joined.find(corner)];
      if (tangle == kNone) {
        tangle = to_index(tangles_.size());
        tangles_.emplace_back();
        mended_.push_back(0);
        shell.push_back(shells.find(corner));
      }
      tangles_[tangle].push_back(f);
      tangle_of_[f] = tangle;
      if (shells.find(corner) != shell[tangle]) shell[tangle] = kNone;
    }
    for (Index tangle = 0; tangle < tangles_.size(); ++tangle) {
      if (shell[tangle] == kNone) tangles_[tangle].clear();
    }
  }

  bool mend(Index tangle) {
    if (tangles_[tangle].empty()) return false;
    for (int rings = 0; rings <= kMostRings; ++rings) {
      if (relax(tangle, rings)) return true;
    }
    return false;
  }

  // Moves the corners of faces that cross, and those up to `rings` edges away, until none crosses;
  // puts them back if that fails.
  bool relax(Index tangle, int rings) {
    Patch patch;
    std::vector<Index> crossing = tangles_[tangle];
    for (int steps = 0; steps < kSteps; ++steps) {
      std::vector<Index> vertices = corners_of(crossing);
      for (int ring = 0; ring < rings; ++ring) vertices = corners_of(faces_at(vertices));
      patch.add(vertices, surface_.points);
      step(vertices);
      // The corners of all faces that crossed have moved: no other face can cross now.
      crossing = unsound(faces_at(vertices), tangle);
      if (crossing.empty()) return true;
    }
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
      surface_.points[patch.vertices[i]] = patch.start[i];
    }
    return false;
  }

  std::vector<Index> corners_of(const std::vector<Index>& faces) const {
    std::vector<Index> result;
    for (const Index f : faces) {
      result.insert(result.end(), surface_.triangles[f].begin(), surface_.triangles[f].end());
    }
    return each_once(std::move(result));
  }

  std::vector<Index> faces_at(const std::vector<Index>& vertices) const {
    std::vector<Index> result;
    for (const Index v : vertices) {
      result.insert(result.end(), faces_at_[v].begin(), faces_at_[v].end());
    }
    return each_once(std::move(result));
  }

  // All at once, so that their order doesn't matter.
  void step(const std::vector<Index>& vertices) {
    std::vector<Vec3> next;
    next.reserve(vertices.size());
    for (const Index v : vertices) {
      const Vec3& here = surface_.points[v];
      const Vec3 wanted = here + kStep * (mean_of_neighbours(v) - here);
      const Vec3 move = wanted - before_[v];
      const double longest = std::min(kLongestMove * mean_edge_length(v), longest_share_);
      const double length = move.norm();
      next.push_back(length <= longest ? wanted : Vec3(before_[v] + longest / length * move));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) surface_.points[vertices[i]] = next[i];
  }

  // Each neighbour belongs to two of the faces.
  Vec3 mean_of_neighbours(Index v) const {
    Vec3 sum = Vec3::Zero();
    for (const Index f : faces_at_[v]) {
      for (const Index w : surface_.triangles[f]) {
        if (w != v) sum += surface_.points[w];
      }
    }
    return sum / (2.0 * static_cast<double>(faces_at_[v].size()));
  }

  double mean_edge_length(Index v) const {
    double sum = 0.0;
    for (const Index f : faces_at_[v]) {
      for (const Index w : surface_.triangles[f]) sum += (before_[w] - before_[v]).norm();
    }
    return sum / (2.0 * static_cast<double>(faces_at_[v].size()));
  }

  // Of the faces at vertices that have just moved, those that cross others, and these; all if one
  // has no area, which leaves open what it crosses.
  std::vector<Index> unsound(const std::vector<Index>& faces, Index tangle) {
    for (const Index f : faces) {
      const Triangle& t = surface_.triangles[f];
      if (exact::collinear(surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]])) {
        return faces;
      }
    }
    for (const Index f : faces) tree_.extend(f, face_box(surface_, f));
    constexpr std::size_t kChunk = 16;
    std::vector<std::vector<Index>> found(threads_);  // by each worker
    parallel_for(faces.size(), threads_, kChunk, [&](std::size_t i, unsigned worker) {
      collect_crossings(faces[i], tangle, faces, found[worker]);
    });
    std::vector<Index> result;
    for (const std::vector<Index>& some : found) {
      result.insert(result.end(), some.begin(), some.end());
    }
    return each_once(std::move(result));
  }

  // Adds f and what it crosses, but for those of `asked` before it, which have been looked at.
  void collect_crossings(Index f, Index tangle, const std::vector<Index>& asked,
                         std::vector<Index>& crossing) const {
    const Box box = face_box(surface_, f);
    tree_.visit([&](const Box& other) { return other.meets(box); },
                [&](Index g) {
                  if (g == f || !box.meets(face_box(surface_, g)) ||
                      (g < f && std::binary_search(asked.begin(), asked.end(), g)) ||
                      !intersect(f, g) ||
                      crosses_elsewhere({std::min(f, g), std::max(f, g)}, tangle)) {
                    return;
                  }
                  crossing.push_back(f);
                  crossing.push_back(g);
                });
  }

  bool intersect(Index f, Index g) const {
    return exact::triangles_intersect(surface_.points, surface_.triangles[f],
                                      surface_.triangles[g]);
  }

  // A crossing that was there before, of another tangle not mended so far.
  bool crosses_elsewhere(const Pair& pair, Index tangle) const {
    const Index other = tangle_of_[pair[0]];
    return other != kNone && other != tangle && mended_[other] == 0 &&
           std::binary_search(crossings_.begin(), crossings_.end(), pair);
  }

  Untangling outcome() const {
    Untangling result;
    for (const Pair& pair : crossings_) {
      // Those that resisted may have been moved by a neighbour that didn't.
      if (mended_[tangle_of_[pair[0]]] == 0 && intersect(pair[0], pair[1])) {
        result.left.push_back(pair);
      }
    }
    result.pairs_mended = crossings_.size() - result.left.size();
    for (Index v = 0; v < before_.size(); ++v) {
      if (surface_.points[v] == before_[v]) continue;
      result.moved.push_back(v);
      result.largest_move = std::max(result.largest_move, (surface_.points[v] - before_[v]).norm());
    }
    return result;
  }

  TriangleSurface& surface_;
  const std::vector<Pair>& crossings_;
  unsigned threads_;
  std::vector<Vec3> before_;                 // where the vertices were
  double longest_share_;                     // no vertex moves further than that
  Rows<Index> faces_at_;                     // one row per vertex
  BoxTree tree_;                             // of the faces, wherever they have been
  std::vector<std::vector<Index>> tangles_;  // faces; none: not to be touched
  std::vector<char> mended_;                 // one per tangle
  std::vector<Index> tangle_of_;             // one per face; kNone: doesn't cross
};

}  // namespace untangling_detail

inline Untangling untangle(TriangleSurface& surface,
                           const std::vector<std::array<Index, 2>>& crossings, unsigned threads) {
  if (crossings.empty()) return {};
  return untangling_detail::Untangler(surface, crossings, threads).run();
}

}  // namespace mgf
