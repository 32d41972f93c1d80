// SPDX-License-Identifier: GPL-3.0-or-later
// A corridor: a strip of triangles from one vertex to another.
//
// A corridor is the list of directed edges crossed, each belonging to the triangle that is entered.
// The first is crossed out of a triangle with the start as its apex, the last into one with the end
// as its apex. An empty corridor is the edge between two neighbours.
#pragma once

#include <algorithm>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// The halfedge from `from` to its neighbour `to`, or kNone.
inline Index find_halfedge(const HalfedgeMesh& mesh, Index from, Index to) {
  const Index first = mesh.outgoing[from];
  if (first == kNone) return kNone;
  Index h = first;
  do {
    if (mesh.head(h) == to) return h;
    h = mesh.rotated(h);
  } while (h != first);
  return kNone;
}

/// Takes away the crossings at both ends that only turn about the start or the end.
inline void trim_corridor(const HalfedgeMesh& mesh, Index a, Index b,
                          std::vector<Index>& corridor) {
  const auto touches = [&](Index h, Index v) { return mesh.tail(h) == v || mesh.head(h) == v; };
  std::size_t last = corridor.size();
  while (last > 0 && touches(corridor[last - 1], b)) --last;
  std::size_t first = 0;
  while (first < last && touches(corridor[first], a)) ++first;
  corridor.erase(corridor.begin() + static_cast<std::ptrdiff_t>(last), corridor.end());
  corridor.erase(corridor.begin(), corridor.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Appends a crossing, or takes the last one back if it is the same edge crossed the other way.
inline void cross_edge(const HalfedgeMesh& mesh, Index h, std::vector<Index>& corridor) {
  if (!corridor.empty() && corridor.back() == mesh.opposite(h)) {
    corridor.pop_back();
  } else {
    corridor.push_back(h);
  }
}

/// Appends the crossings [first, last) of a corridor likewise.
inline void cross_edges(const HalfedgeMesh& mesh, const Index* first, const Index* last,
                        std::vector<Index>& corridor) {
  while (first < last && !corridor.empty() && corridor.back() == mesh.opposite(*first)) {
    corridor.pop_back();
    ++first;
  }
  corridor.insert(corridor.end(), first, last);
}

/// Turns about v from the triangle of `from` to that of `to`, both halfedges out of v, the way with
/// fewer crossings, and appends these.
inline void turn_about_vertex(const HalfedgeMesh& mesh, Index from, Index to,
                              std::vector<Index>& corridor) {
  Index forward = from;
  Index backward = from;
  int steps = 0;
  while (forward != to && backward != to) {
    forward = mesh.rotated(forward);
    backward = mesh.rotated_back(backward);
    ++steps;
  }
  const bool anticlockwise = forward == to;
  for (Index h = from; steps > 0; --steps) {
    if (anticlockwise) {
      h = mesh.rotated(h);
      cross_edge(mesh, h, corridor);
    } else {
      // Clockwise, the edge crossed is h itself, into the triangle on its other side.
      cross_edge(mesh, mesh.opposite(h), corridor);
      h = mesh.rotated_back(h);
    }
  }
}

/// Writes the corridor of a path that comes in pieces, each along an edge or across some. Between
/// two pieces it turns about the vertex where they meet.
class CorridorBuilder {
 public:
  /// Writes to `corridor`, which must stay alive and is emptied.
  CorridorBuilder(const HalfedgeMesh& mesh, std::vector<Index>& corridor)
      : mesh_(mesh), corridor_(corridor) {
    corridor_.clear();
  }

  /// A piece along halfedge `edge`, from its tail to its head.
  void follow_edge(Index edge) {
    turn_to(edge);
    arrived_ = next_in_triangle(edge);
  }

  /// A piece across the directed edges [first, last), at least one.
  void cross(const Index* first, const Index* last) {
    turn_to(previous_in_triangle(mesh_.opposite(*first)));
    cross_edges(mesh_, first, last, corridor_);
    arrived_ = previous_in_triangle(*(last - 1));
  }

  /// The same piece in the other direction, that is from the end of [first, last) to its start.
  void cross_back(const Index* first, const Index* last) {
    turn_to(previous_in_triangle(*(last - 1)));
    for (const Index* h = last; h != first; --h) {
      cross_edge(mesh_, mesh_.opposite(h[-1]), corridor_);
    }
    arrived_ = previous_in_triangle(mesh_.opposite(*first));
  }

 private:
  void turn_to(Index leaving) {
    if (arrived_ != kNone) turn_about_vertex(mesh_, arrived_, leaving, corridor_);
  }

  const HalfedgeMesh& mesh_;
  std::vector<Index>& corridor_;
  Index arrived_ = kNone;  ///< the halfedge out of the last piece's end, in its last triangle
};

/// One straight piece of a path: from vertex `from` across the directed edges `crossed`, at
/// `points`, to vertex `to`. With none crossed, the piece runs along the edge between the two.
struct PathPiece {
  Index from = kNone;
  Index to = kNone;
  std::vector<Index> crossed;
  std::vector<Vec3> points;
};

/// The corridor of a path given by its pieces in order.
inline std::vector<Index> corridor_of_pieces(const HalfedgeMesh& mesh,
                                             const std::vector<PathPiece>& pieces) {
  std::vector<Index> corridor;
  CorridorBuilder builder(mesh, corridor);
  for (const PathPiece& piece : pieces) {
    if (piece.crossed.empty()) {
      builder.follow_edge(find_halfedge(mesh, piece.from, piece.to));
    } else {
      builder.cross(piece.crossed.data(), piece.crossed.data() + piece.crossed.size());
    }
  }
  if (!pieces.empty()) trim_corridor(mesh, pieces.front().from, pieces.back().to, corridor);
  return corridor;
}

/// The corridor in the other direction.
inline std::vector<Index> reversed_corridor(const HalfedgeMesh& mesh,
                                            const std::vector<Index>& corridor) {
  std::vector<Index> reversed(corridor.size());
  for (std::size_t i = 0; i < corridor.size(); ++i) {
    reversed[corridor.size() - 1 - i] = mesh.opposite(corridor[i]);
  }
  return reversed;
}

}  // namespace mgf
