// SPDX-License-Identifier: GPL-3.0-or-later
// Recovery that always ends with the surface in the mesh: where flips get stuck, points exactly on
// the surface.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/local_moves.h"
#include "vcg_ext/medial/obstacle_clearing.h"
#include "vcg_ext/medial/simplex_split.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Bounds on the work of one exact recovery, counted so that they are the same on any machine.
struct ExactRecoveryLimits {
  int recursive_attempts = std::numeric_limits<int>::max();  ///< in all; once they are spent,
                                                             ///< points are added instead
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();  ///< tetrahedra looked at on the
                                                                    ///< ways of missing edges and
                                                                    ///< faces; give up beyond
};

/// Makes each face of a surface a union of faces of a tetrahedral mesh; the surface stays as it is.
/// Flips as long as they help, then points exactly on the surface: each takes a crossing of the
/// surface with the mesh away and makes none, so that this ends (docs/topology.md), if not before
/// because the steps of the limits are spent.
/// Requires a surface free of self-intersections, whose vertices are vertices of the mesh, and all
/// vertices of the mesh but those of its hull to lie on it.
class ExactRecovery {
 public:
  /// `missing` are the faces that the mesh doesn't have, ascending.
  ExactRecovery(TetrahedralMesh& mesh, const std::vector<Triangle>& faces,
                std::vector<Index> missing, const ExactRecoveryLimits& limits = {})
      : mesh_(mesh),
        faces_(faces),
        most_steps_(limits.steps),
        missing_(std::move(missing)),
        kept_(mesh.points().size(), faces),
        clearing_(mesh, kept_, kSeed, limits.recursive_attempts) {}

  /// The faces of the mesh that the surface consists of, oriented as it is. None if a crossing is
  /// met that only a self-intersecting surface can have, or if the limits don't do. The mesh is
  /// valid either way. Throws `Cancelled`.
  std::optional<std::vector<Triangle>> run(const Progress& progress) {
    flip_edges_free(progress.slice(0.0, 0.3));
    if (!recover_edges(progress.slice(0.3, 0.7))) return std::nullopt;
    return recover_faces(progress.slice(0.7, 1.0));
  }

  /// Tetrahedra looked at so far.
  std::uint64_t steps() const { return clearing_.steps() + own_steps_; }
  /// Whether the steps of the limits are spent.
  bool spent() const { return steps() > most_steps_; }

 private:
  // Where the way from a vertex leaves its star: an edge or a face, as the first `size` corners.
  struct Exit {
    Index tetrahedron;
    std::array<Index, 4> simplex;
    unsigned size;
    Triangle face;  // that the simplex is, or is a side of
  };

  using Edge = std::array<Index, 2>;

  bool clear(Index a, Index b, int depth) {
    ClearingEffort effort;
    effort.depth = depth;
    return clearing_.clear(SegmentObstacle{a, b}, effort);
  }

  // The edges of the surface that the mesh hasn't, each once, the shortest first.
  std::vector<Edge> missing_edges() const {
    std::vector<Edge> edges;
    for (const Index f : missing_) {
      for (unsigned i = 0; i < 3; ++i) {
        const Index a = faces_[f][i];
        const Index b = faces_[f][(i + 1) % 3];
        if (mesh_.find_edge(a, b) == kNone) edges.push_back({std::min(a, b), std::max(a, b)});
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const auto squared_length = [&](const Edge& e) {
      return (mesh_.point(e[0]) - mesh_.point(e[1])).squaredNorm();
    };
    std::stable_sort(edges.begin(), edges.end(), [&](const Edge& e, const Edge& f) {
      return squared_length(e) < squared_length(f);
    });
    return edges;
  }

  // Flips alone, the quick ones first.
  void flip_edges_free(const Progress& progress) {
    stuck_ = missing_edges();
    for (const int depth : {0, 2}) {
      std::vector<Edge> left;
      for (const Edge& e : stuck_) {
        progress.report(0.5 * depth, "topology");
        if (spent()) return;
        if (!clear(e[0], e[1], depth)) left.push_back(e);
      }
      stuck_.swap(left);
    }
  }

  // Makes every edge of the surface a chain of edges of the mesh.
  bool recover_edges(const Progress& progress) {
    double done = 0.0;
    for (const auto& [a, b] : stuck_) {
      if (spent()) return false;
      const std::vector<Index> faces = kept_.faces_at_edge(a, b);
      for (Index at = a; mesh_.find_edge(at, b) == kNone && !clear(at, b, kWalkDepth);) {
        progress.report(done / static_cast<double>(stuck_.size()), "topology");
        const std::optional<Exit> exit = exit_towards(at, b);
        if (!exit || spent()) return false;
        const Index m = split(*exit, [&, a = a, b = b](unsigned bits) {
          return mesh_.add_point_on_segment(a, b, exit->face, bits);
        });
        kept_.add_face({at, m, m});
        kept_.add_face({m, b, b});
        for (const Index f : faces) points_on_[f].push_back(m);
        at = m;
      }
      done += 1.0;
    }
    return true;
  }

  // Makes every face of the surface a union of faces of the mesh, and gives these. None if that
  // takes more steps than allowed.
  std::optional<std::vector<Triangle>> recover_faces(const Progress& progress) {
    missing_.erase(std::remove_if(missing_.begin(), missing_.end(),
                                  [&](Index f) {
                                    const auto [a, b, c] = faces_[f];
                                    return mesh_.find_face(a, b, c) != kNone;
                                  }),
                   missing_.end());
    std::vector<Triangle> parts;
    for (Index f = 0, next = 0; f < faces_.size(); ++f) {
      if (next < missing_.size() && missing_[next] == f) {
        ++next;
      } else {
        parts.push_back(faces_[f]);
      }
    }
    for (const Index f : missing_) {
      progress.report(f / static_cast<double>(faces_.size()), "topology");
      if (spent()) return std::nullopt;
      const auto [a, b, c] = faces_[f];
      const bool whole = points_on_.find(f) == points_on_.end();
      if (whole && clearing_.clear(TriangleObstacle{a, b, c}, {})) {
        parts.push_back(faces_[f]);
        continue;
      }
      if (!clear_face(f)) return std::nullopt;
      const std::size_t first = parts.size();
      collect_parts(f, parts);
      for (std::size_t i = first; i < parts.size(); ++i) kept_.add_face(parts[i]);
    }
    return parts;
  }

  // None if the way ends in a vertex.
  std::optional<Exit> exit_towards(Index at, Index goal) {
    for (const Index t : mesh_.star(at)) {
      ++own_steps_;
      const auto [x, y, z] = face_of(mesh_.corners(t), corner_index(mesh_.corners(t), at));
      const int yz = mesh_.orientation(at, goal, y, z);
      const int zx = mesh_.orientation(at, x, goal, z);
      const int xy = mesh_.orientation(at, x, y, goal);
      if (yz < 0 || zx < 0 || xy < 0) continue;
      const int touched = (yz == 0 ? 1 : 0) + (zx == 0 ? 1 : 0) + (xy == 0 ? 1 : 0);
      if (touched > 1) return std::nullopt;
      if (yz == 0) return Exit{t, {y, z, kNone, kNone}, 2, {x, y, z}};
      if (zx == 0) return Exit{t, {z, x, kNone, kNone}, 2, {x, y, z}};
      if (xy == 0) return Exit{t, {x, y, kNone, kNone}, 2, {x, y, z}};
      return Exit{t, {x, y, z, kNone}, 3, {x, y, z}};
    }
    return std::nullopt;
  }

  // Splits a simplex at the point that `add` gives near the crossing.
  template <class Add>
  Index split(const Exit& exit, const Add& add) {
    const std::vector<Index> old =
        tetrahedra_round(mesh_, exit.tetrahedron, exit.simplex, exit.size);
    kept_.add_vertex();
    return split_simplex_near(mesh_, old, exit.simplex, exit.size, add);
  }

  // Removes or splits the edges of the mesh that go through face f, whose own edges must have been
  // recovered. False if that takes more steps than allowed.
  bool clear_face(Index f) {
    LocalMoves<TriangleObstacle> moves(mesh_, kept_, {faces_[f][0], faces_[f][1], faces_[f][2]});
    std::vector<Index>& points = points_on_[f];
    points.insert(points.end(), faces_[f].begin(), faces_[f].end());
    for (std::size_t next = 0; next < points.size(); ++next) {  // it grows meanwhile
      while (const std::optional<Exit> piercing = edge_through(f, points[next])) {
        const auto [p, q, r, s] = piercing->simplex;
        if (moves.remove_edge(piercing->tetrahedron, p, q, -1)) continue;
        if (spent()) return false;
        points.push_back(split(*piercing, [&, p = p, q = q](unsigned bits) {
          return mesh_.add_point_on_triangle(faces_[f], p, q, bits);
        }));
      }
    }
    return true;
  }

  // An edge through the inside of face f of a tetrahedron at v.
  std::optional<Exit> edge_through(Index f, Index v) {
    const auto [a, b, c] = faces_[f];
    for (const Index t : mesh_.star(v)) {
      ++own_steps_;
      const Tetrahedron corners = mesh_.corners(t);
      std::array<int, 4> side{};
      for (unsigned i = 0; i < 4; ++i) side[i] = mesh_.orientation(a, b, c, corners[i]);
      for (unsigned i = 0; i < 4; ++i) {
        for (unsigned j = 0; j < i; ++j) {
          const Index p = corners[i];
          const Index q = corners[j];
          if (side[i] * side[j] >= 0) continue;
          const int ab = mesh_.orientation(p, q, a, b);
          if (ab == 0 || mesh_.orientation(p, q, b, c) != ab ||
              mesh_.orientation(p, q, c, a) != ab) {
            continue;
          }
          return Exit{t, {p, q, kNone, kNone}, 2, faces_[f]};
        }
      }
    }
    return std::nullopt;
  }

  // Appends the faces of the mesh whose corners all lie on face f, each once.
  void collect_parts(Index f, std::vector<Triangle>& parts) {
    std::vector<Index>& points = points_on_[f];
    std::sort(points.begin(), points.end());
    const auto on_face = [&](Index v) {
      return std::binary_search(points.begin(), points.end(), v);
    };
    const auto [a, b, c] = faces_[f];
    for (const Index v : points) {
      for (const Index t : mesh_.star(v)) {
        const Tetrahedron corners = mesh_.corners(t);
        for (unsigned i = 0; i < 4; ++i) {
          const Triangle part = face_of(corners, i);
          if (*std::min_element(part.begin(), part.end()) != v) continue;
          if (!on_face(part[0]) || !on_face(part[1]) || !on_face(part[2])) continue;
          // Seen from inside, so that it is oriented as f.
          if (mesh_.orientation(a, b, c, corners[i]) < 0) parts.push_back(part);
        }
      }
    }
  }

  static constexpr std::uint64_t kSeed = 1;
  static constexpr int kWalkDepth = 2;

  TetrahedralMesh& mesh_;
  const std::vector<Triangle>& faces_;
  std::uint64_t most_steps_;
  std::vector<Index> missing_;  // faces that the mesh hasn't; flips and points take none away
  std::vector<Edge> stuck_;     // edges of the surface that flips can't make way for
  std::unordered_map<Index, std::vector<Index>> points_on_;  // of a face: points added, its corners
  ConstrainedSurface kept_;  // what flips must not destroy: the faces, parts of edges and of faces
  ObstacleClearing clearing_;
  std::uint64_t own_steps_ = 0;  // besides those of `clearing_`
};

}  // namespace mgf
