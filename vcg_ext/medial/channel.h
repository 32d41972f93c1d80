// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the way of a missing edge or face: the part of the tetrahedral mesh it runs
// through.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/local_moves.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// A face or an edge of the mesh, named by corners, with a tetrahedron that had it when listed.
struct ListedFace {
  Index tetrahedron;
  Triangle corners;
};
struct ListedEdge {
  Index tetrahedron;
  Index x, y;
};

/// The obstacles on the way of a missing simplex and the tetrahedra next to them.
struct Channel {
  int cost = 0;                   ///< faces touched by the segment, or edges through the triangle
  std::vector<Index> tetrahedra;  ///< that have such a face or edge
  std::vector<ListedFace> faces;  ///< segment: the touched faces; triangle: faces at `edges`
  std::vector<ListedEdge> edges;  ///< segment: sides of `faces`; triangle: the piercing edges
};

/// Whether t still has the listed face; the corner opposite it, or 4.
inline unsigned find_listed(const TetrahedralMesh& mesh, const ListedFace& face) {
  if (!mesh.alive(face.tetrahedron)) return 4;
  unsigned opposite = 4;
  unsigned matches = 0;
  const Tetrahedron& corners = mesh.corners(face.tetrahedron);
  for (unsigned i = 0; i < 4; ++i) {
    const bool in_face = corners[i] == face.corners[0] || corners[i] == face.corners[1] ||
                         corners[i] == face.corners[2];
    matches += in_face ? 1U : 0U;
    if (!in_face) opposite = i;
  }
  return matches == 3 ? opposite : 4;
}

inline bool still_listed(const TetrahedralMesh& mesh, const ListedEdge& edge) {
  return mesh.alive(edge.tetrahedron) && corner_index(mesh.corners(edge.tetrahedron), edge.x) < 4 &&
         corner_index(mesh.corners(edge.tetrahedron), edge.y) < 4;
}

/// Finds channels; keeps its workspace from one to the next.
class ChannelFinder {
 public:
  explicit ChannelFinder(const TetrahedralMesh& mesh) : mesh_(mesh) {}

  Channel find(const SegmentObstacle& segment) {
    Channel channel;
    start(mesh_.star(segment.a));
    std::size_t next = 0;
    while (next < queue_.size()) {  // it grows meanwhile
      const Index t = queue_[next++];
      bool touched = false;
      for (unsigned i = 0; i < 4; ++i) {
        const Triangle face = face_of(mesh_.corners(t), i);
        if (segment.face_cost(mesh_, face[0], face[1], face[2]) == 0) continue;
        touched = true;
        const Index n = mesh_.neighbour(t, i);
        enqueue(n);
        if (n != kNone && n < t) continue;
        channel.faces.push_back({t, face});
        for (unsigned k = 0; k < 3; ++k) {
          channel.edges.push_back({t, face[k], face[(k + 1) % 3]});
        }
      }
      if (touched) channel.tetrahedra.push_back(t);
    }
    count_steps();
    channel.cost = static_cast<int>(channel.faces.size());
    make_unique(channel.edges);
    return channel;
  }

  Channel find(const TriangleObstacle& triangle) {
    Channel channel;
    start({});
    for (const auto& [a, b] : {std::array<Index, 2>{triangle.a, triangle.b},
                               std::array<Index, 2>{triangle.b, triangle.c},
                               std::array<Index, 2>{triangle.c, triangle.a}}) {
      const Index t = mesh_.find_edge(a, b);
      if (t != kNone) enqueue_ring(t, a, b);
    }
    std::size_t next = 0;
    while (next < queue_.size()) {  // it grows meanwhile
      const Index t = queue_[next++];
      const Tetrahedron corners = mesh_.corners(t);
      bool pierced = false;
      for (unsigned i = 0; i < 4; ++i) {
        for (unsigned j = 0; j < i; ++j) {
          if (triangle.edge_cost(mesh_, corners[i], corners[j]) == 0) continue;
          pierced = true;
          channel.edges.push_back({t, corners[i], corners[j]});
          enqueue_ring(t, corners[i], corners[j]);
          for (unsigned k = 0; k < 4; ++k) {
            if (k != i && k != j) channel.faces.push_back({t, face_of(corners, k)});
          }
        }
      }
      if (pierced) channel.tetrahedra.push_back(t);
    }
    count_steps();
    make_unique(channel.edges);
    channel.cost = static_cast<int>(channel.edges.size());
    return channel;
  }

  /// Tetrahedra looked at so far, those with an exact corner counted ten times, as predicates on
  /// them take about ten times as long.
  std::uint64_t steps() const { return steps_; }

  /// Adds to `tetrahedra` their neighbours.
  void add_layer(std::vector<Index>& tetrahedra) {
    start(tetrahedra);
    for (const Index t : tetrahedra) {
      for (unsigned i = 0; i < 4; ++i) enqueue(mesh_.neighbour(t, i));
    }
    tetrahedra = queue_;
  }

 private:
  void count_steps() {
    constexpr std::uint64_t kExactWeight = 10;
    for (const Index t : queue_) {
      const Tetrahedron& corners = mesh_.corners(t);
      const Index last = *std::max_element(corners.begin(), corners.end());
      steps_ += mesh_.is_exact(last) ? kExactWeight : 1;
    }
  }

  void start(const std::vector<Index>& tetrahedra) {
    ++epoch_;
    seen_.resize(mesh_.slot_count(), 0);
    queue_.clear();
    for (const Index t : tetrahedra) enqueue(t);
  }

  void enqueue(Index t) {
    if (t == kNone || seen_[t] == epoch_) return;
    seen_[t] = epoch_;
    queue_.push_back(t);
  }

  void enqueue_ring(Index t, Index x, Index y) {
    mesh_.ring_of(t, x, y, mesh_.slot_count(), ring_);
    for (const Index s : ring_.tetrahedra) enqueue(s);
  }

  static void make_unique(std::vector<ListedEdge>& edges) {
    for (ListedEdge& e : edges) {
      if (e.x > e.y) std::swap(e.x, e.y);
    }
    std::sort(edges.begin(), edges.end(), [](const ListedEdge& e, const ListedEdge& f) {
      return e.x != f.x ? e.x < f.x : (e.y != f.y ? e.y < f.y : e.tetrahedron < f.tetrahedron);
    });
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const ListedEdge& e, const ListedEdge& f) {
                              return e.x == f.x && e.y == f.y;
                            }),
                edges.end());
  }

  const TetrahedralMesh& mesh_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t epoch_ = 0;
  std::uint64_t steps_ = 0;
  std::vector<Index> queue_;
  EdgeRing ring_;
};

}  // namespace mgf
