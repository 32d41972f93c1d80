// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary recovery: making a surface part of a tetrahedral mesh of its vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/face_lookup.h"
#include "vcg_ext/medial/obstacle_clearing.h"
#include "vcg_ext/medial/surface_splits.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Bounds on one attempt.
struct RecoveryLimits {
  std::size_t added_points = 0;  ///< give up beyond
  int recursive_attempts = 400;  ///< per missing edge or face
  int attempts_in_all = 0;       ///< recursive ones; once they are spent, points are added instead
  /// Tetrahedra looked at on the ways of missing edges and faces; give up beyond.
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t seed = 1;
};

/// Forces the edges, then the faces of a surface into a tetrahedral mesh by moves that never
/// destroy one that is there, and splits what stays stuck at a point on it.
class BoundaryRecovery {
 public:
  BoundaryRecovery(TetrahedralMesh& mesh, ConstrainedSurface& surface, const RecoveryLimits& limits)
      : mesh_(mesh),
        surface_(surface),
        limits_(limits),
        clearing_(mesh, surface, limits.seed, limits.attempts_in_all),
        splitter_(mesh, surface) {}

  /// True if every face of the surface is now a face of the mesh. The mesh is valid either way.
  bool run(const Progress& progress) {
    for (const Index f : missing_faces(mesh_, surface_.faces())) watch_face(f);
    while (!edges_.empty() || !faces_.empty()) {
      if (!recover_edges(progress) || !recover_faces(progress)) return false;
    }
    return true;
  }

  Index points_added() const { return splitter_.points_added(); }

 private:
  using Edge = std::array<Index, 2>;

  void watch_edge(Index a, Index b) {
    if (mesh_.find_edge(a, b) == kNone) edges_.push_back({std::min(a, b), std::max(a, b)});
  }

  void watch_face(Index f) {
    const Triangle& face = surface_.face(f);
    if (mesh_.find_face(face[0], face[1], face[2]) != kNone) return;
    faces_.push_back(f);
    for (unsigned i = 0; i < 3; ++i) watch_edge(face[i], face[(i + 1) % 3]);
  }

  double squared_length(const Edge& e) const {
    return (mesh_.point(e[0]) - mesh_.point(e[1])).squaredNorm();
  }

  // The missing edges of the surface, each once, shortest first.
  std::vector<Edge> take_missing_edges() {
    std::vector<Edge> edges;
    edges.swap(edges_);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges.erase(
        std::remove_if(edges.begin(), edges.end(), [&](const Edge& e) { return !missing(e); }),
        edges.end());
    std::stable_sort(edges.begin(), edges.end(), [&](const Edge& e, const Edge& f) {
      return squared_length(e) < squared_length(f);
    });
    return edges;
  }

  bool missing(const Edge& e) const {
    return surface_.has_edge(e[0], e[1]) && mesh_.find_edge(e[0], e[1]) == kNone;
  }

  bool spent() const { return clearing_.steps() > limits_.steps; }

  bool recover_edges(const Progress& progress) {
    std::size_t stuck_before = 0;
    int rises = 0;
    for (int round = 0; !edges_.empty(); ++round) {
      const double share = 1.0 - 1.0 / (1.0 + round);
      const std::vector<Edge> stuck = clear_edges(take_missing_edges(), share, progress);
      if (spent()) return false;
      rises = stuck.size() > stuck_before && round > 0 ? rises + 1 : 0;
      if (rises >= kRisesAllowed) return false;
      stuck_before = stuck.size();
      if (!split_stuck_edges(stuck)) return false;
    }
    return true;
  }

  // Flips. Gives the edges that resist.
  std::vector<Edge> clear_edges(std::vector<Edge> edges, double share, const Progress& progress) {
    for (const int depth : {0, 2}) {
      ClearingEffort effort;
      effort.depth = depth;
      effort.recursive_attempts = limits_.recursive_attempts;
      std::vector<Edge> stuck;
      for (const Edge& e : edges) {
        progress.report(share, "topology");
        if (spent()) return edges;
        if (missing(e) && !clearing_.clear(SegmentObstacle{e[0], e[1]}, effort)) stuck.push_back(e);
      }
      edges.swap(stuck);
    }
    return edges;
  }

  // An edge without room for a point waits for the next round, as splits of others make room.
  bool split_stuck_edges(const std::vector<Edge>& stuck) {
    const Index before = splitter_.points_added();
    for (const Edge& e : stuck) {
      if (!missing(e)) continue;
      if (!split_edge(e)) edges_.push_back(e);
      if (splitter_.points_added() > limits_.added_points) return false;
    }
    return edges_.empty() || splitter_.points_added() > before;
  }

  // A face without room for a point waits for the next round, too.
  bool recover_faces(const Progress& progress) {
    std::vector<Index> faces;
    faces.swap(faces_);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    ClearingEffort effort;
    effort.recursive_attempts = limits_.recursive_attempts;
    bool waiting = false;
    const Index before = splitter_.points_added();
    for (const Index f : faces) {
      progress.report(1.0, "topology");
      if (spent()) return false;
      const auto [a, b, c] = surface_.face(f);
      if (missing({a, b}) || missing({b, c}) || missing({c, a})) {
        watch_face(f);
        continue;
      }
      if (mesh_.find_face(a, b, c) != kNone) continue;
      const TriangleObstacle obstacle{a, b, c};
      if (clearing_.clear(obstacle, effort)) continue;
      if (split_face(obstacle)) {
        if (splitter_.points_added() > limits_.added_points) return false;
      } else {
        faces_.push_back(f);
        waiting = true;
      }
    }
    return !waiting || splitter_.points_added() > before;
  }

  bool split_edge(const Edge& e) {
    const SegmentObstacle segment{e[0], e[1]};
    return watch_all(splitter_.split_edge(segment, clearing_.finder().find(segment)));
  }

  bool split_face(const TriangleObstacle& triangle) {
    return watch_all(splitter_.split_face(triangle, clearing_.finder().find(triangle)));
  }

  // False if there is nothing to watch, as no point could be placed.
  bool watch_all(const std::vector<Index>& faces) {
    for (const Index f : faces) watch_face(f);
    return !faces.empty();
  }

  static constexpr int kRisesAllowed = 3;

  TetrahedralMesh& mesh_;
  ConstrainedSurface& surface_;
  RecoveryLimits limits_;
  ObstacleClearing clearing_;
  SurfaceSplitter splitter_;
  std::vector<Edge> edges_;   // perhaps missing
  std::vector<Index> faces_;  // perhaps missing
};

}  // namespace mgf
