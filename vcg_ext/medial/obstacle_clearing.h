// SPDX-License-Identifier: GPL-3.0-or-later
// Flipping the obstacles away from a missing edge or face.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/core/random.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/channel.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/local_moves.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// How hard to try.
struct ClearingEffort {
  int depth = 2;                 ///< of recursive edge removals; 0: plain moves only
  int recursive_attempts = 400;  ///< per missing simplex
  int idle_rounds = 8;           ///< without a new minimum of obstacles before giving up
  int random_moves = 5;          ///< per missing simplex
};

/// Makes way for one missing simplex after another.
class ObstacleClearing {
 public:
  /// After `attempts_in_all` recursive ones, only plain and random moves are tried.
  ObstacleClearing(TetrahedralMesh& mesh, const ConstrainedSurface& surface, std::uint64_t seed,
                   int attempts_in_all = std::numeric_limits<int>::max())
      : mesh_(mesh),
        surface_(surface),
        finder_(mesh),
        random_(seed),
        attempts_left_(attempts_in_all) {}

  ChannelFinder& finder() { return finder_; }

  /// The steps of `finder`: a measure of the work.
  std::uint64_t steps() const { return finder_.steps(); }

  /// Flips until nothing is in the way, which makes the simplex part of the mesh. False if stuck.
  template <class Obstacle>
  bool clear(const Obstacle& obstacle, const ClearingEffort& effort) {
    LocalMoves<Obstacle> moves(mesh_, surface_, obstacle);
    int fewest = std::numeric_limits<int>::max();
    int idle = 0;
    int budget = std::min(effort.recursive_attempts, attempts_left_);
    int random_moves = effort.random_moves;
    tabu_.clear();
    for (;;) {
      const Channel channel = finder_.find(obstacle);
      if (channel.cost == 0) return true;
      if (channel.cost < fewest) {
        fewest = channel.cost;
        idle = 0;
      } else if (++idle > effort.idle_rounds) {
        return false;
      }
      if (lower(moves, channel)) continue;
      if (effort.depth == 0) return false;
      if (lower_recursively(moves, channel, effort.depth, budget)) continue;
      if (budget <= 0 || random_moves-- <= 0 || !move_at_random(moves, channel)) return false;
    }
  }

 private:
  using Edge = std::pair<Index, Index>;

  // Moves that lower the number of obstacles; tries each listed face and edge once.
  template <class Obstacle>
  bool lower(LocalMoves<Obstacle>& moves, const Channel& channel) {
    bool moved = false;
    for (const ListedFace& face : channel.faces) {
      const unsigned i = find_listed(mesh_, face);
      if (i < 4 && moves.flip_face(face.tetrahedron, i, -1)) moved = true;
    }
    if (moved) return true;
    for (const ListedEdge& edge : channel.edges) {
      if (still_listed(mesh_, edge) && moves.remove_edge(edge.tetrahedron, edge.x, edge.y, -1)) {
        moved = true;
      }
    }
    return moved;
  }

  template <class Obstacle>
  bool lower_recursively(LocalMoves<Obstacle>& moves, const Channel& channel, int depth,
                         int& budget) {
    const int before = budget;
    mesh_.open_journal();
    bool moved = false;
    for (int d = 1; d <= depth && !moved; ++d) {
      for (const ListedEdge& edge : channel.edges) {
        if (budget <= 0) break;
        moved = moves.remove_edge_recursively(edge.x, edge.y, -1, d, budget);
        if (moved) break;
      }
    }
    mesh_.close_journal();
    attempts_left_ -= before - budget;
    return moved;
  }

  // One move near the channel that doesn't add obstacles and doesn't undo the one before.
  template <class Obstacle>
  bool move_at_random(LocalMoves<Obstacle>& moves, const Channel& channel) {
    std::vector<Index> near = channel.tetrahedra;
    finder_.add_layer(near);
    for (int attempt = 0; attempt < 30; ++attempt) {
      const Index t = near[random_.below(near.size())];
      const Tetrahedron corners = mesh_.corners(t);
      const unsigned i = random_.below(4);
      if (random_.below(2) == 0) {
        const Index u = mesh_.neighbour(t, i);
        if (u == kNone || !moves.flip_face(t, i, 0)) continue;
        tabu_.push_back(created_edge(corners, i));
        return true;
      }
      const unsigned j = (i + 1 + random_.below(3)) % 4;
      const Edge edge{std::min(corners[i], corners[j]), std::max(corners[i], corners[j])};
      if (std::find(tabu_.begin(), tabu_.end(), edge) != tabu_.end()) continue;
      if (moves.remove_edge(t, edge.first, edge.second, 0)) return true;
    }
    return false;
  }

  // The edge that the 2-3 flip of the face opposite corner i of `corners` has just made.
  Edge created_edge(const Tetrahedron& corners, unsigned i) const {
    const Index p = corners[i];
    const Triangle face = face_of(corners, i);
    const Index t = mesh_.find_at(p, [&](const Tetrahedron& c) {
      return corner_index(c, face[0]) < 4 && corner_index(c, face[1]) < 4 &&
             corner_index(c, face[2]) == 4;
    });
    Index q = p;
    for (const Index v : mesh_.corners(t)) {
      if (v != p && v != face[0] && v != face[1]) q = v;
    }
    return {std::min(p, q), std::max(p, q)};
  }

  TetrahedralMesh& mesh_;
  const ConstrainedSurface& surface_;
  ChannelFinder finder_;
  Random random_;
  int attempts_left_;
  std::vector<Edge> tabu_;
};

}  // namespace mgf
