// SPDX-License-Identifier: GPL-3.0-or-later
// A corridor: a strip of triangles from one vertex to another, laid flat, and the shortest path in
// it.
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

/// The unit direction in 3D of a vector given in the frame of h.
inline Vec3 direction_in_triangle(const HalfedgeMesh& mesh, Index h, Vec2 vector) {
  const Vec3& tail = mesh.points[mesh.tail(h)];
  const Vec3 along = (mesh.points[mesh.head(h)] - tail).normalized();
  const Vec3 arm = mesh.points[mesh.apex(h)] - tail;
  const Vec3 across = (arm - along * along.dot(arm)).normalized();
  return (vector.x * along + vector.y * across).normalized();
}

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

/// The shortest path inside a corridor by the funnel of Lee & Preparata (1984), in linear time.
/// Keeps its memory between calls.
class Funnel {
 public:
  /// A point of the flat strip: a vertex of its border.
  struct Node {
    Vec2 place;
    Index vertex = kNone;
    Index portal = 0;  ///< the first directed edge of the corridor with this vertex at its end
    Index previous = kNone;  ///< the node before it on the shortest path from the start
    bool is_left = false;    ///< on the left border
  };

  explicit Funnel(const HalfedgeMesh& mesh) : mesh_(mesh) {}

  /// Lays the corridor from a to b flat and finds the shortest path in it; returns its length.
  double straighten(Index a, Index b, const std::vector<Index>& corridor) {
    nodes_.clear();
    path_.clear();
    ends_.clear();
    if (corridor.empty()) return straighten_edge(a, b);
    lay_first(a, corridor.front());
    for (Index k = 0; k + 1 < corridor.size(); ++k) lay_next(corridor, k);
    lay_last(b, corridor);
    return trace();
  }

  /// The path found: nodes from the start, over the bends, to the end.
  const std::vector<Index>& path() const { return path_; }
  const Node& node(Index i) const { return nodes_[i]; }
  /// All vertices of the strip in the order they come up: the start, the border, the end.
  Index node_count() const { return to_index(nodes_.size()); }

  /// Ends of the directed edge number k of the corridor in the flat strip.
  Vec2 left_of(Index k) const { return nodes_[ends_[k][0]].place; }
  Vec2 right_of(Index k) const { return nodes_[ends_[k][1]].place; }

  /// Unit tangents of the path found, leaving a and leaving b.
  Vec3 tangent_at_start(Index a, Index b, const std::vector<Index>& corridor) const {
    if (corridor.empty()) return edge_tangent(a, b);
    // The first directed edge lies on the x axis, and the first triangle below it.
    const Vec2 leaving = nodes_[path_[1]].place - nodes_[path_[0]].place;
    return direction_in_triangle(mesh_, mesh_.opposite(corridor.front()), {-leaving.x, -leaving.y});
  }
  Vec3 tangent_at_end(Index a, Index b, const std::vector<Index>& corridor) const {
    if (corridor.empty()) return edge_tangent(b, a);
    const Index last = to_index(corridor.size()) - 1;
    const Vec2 leaving = nodes_[path_[path_.size() - 2]].place - nodes_[path_.back()].place;
    const Vec2 along = right_of(last) - left_of(last);
    const double length = norm(along);
    return direction_in_triangle(mesh_, corridor.back(),
                                 {dot(along, leaving) / length, cross(along, leaving) / length});
  }

 private:
  Vec3 edge_tangent(Index from, Index to) const {
    const Vec3 edge = mesh_.points[to] - mesh_.points[from];
    const double length = edge.norm();
    return length > 0.0 ? Vec3(edge / length) : Vec3(Vec3::Zero());
  }

  double straighten_edge(Index a, Index b) {
    const double length = (mesh_.points[a] - mesh_.points[b]).norm();
    nodes_.push_back({{0.0, 0.0}, a, 0, kNone, false});
    nodes_.push_back({{length, 0.0}, b, 0, 0, false});
    path_ = {0, 1};
    return length;
  }

  void lay_first(Index a, Index h) {
    const Halfedge& back = mesh_.halfedges[mesh_.opposite(h)];
    nodes_.push_back({{back.length - back.apex.x, -back.apex.y}, a, 0, kNone, false});
    nodes_.push_back({{0.0, 0.0}, mesh_.tail(h), 0, 0, true});
    nodes_.push_back({{back.length, 0.0}, mesh_.head(h), 0, 0, false});
    left_chain_.clear();
    right_chain_.clear();
    apex_ = 0;
    left_chain_.push_back(1);
    right_chain_.push_back(2);
    left_front_ = right_front_ = 0;
    ends_.push_back({1, 2});
  }

  /// Where the apex of directed edge number k of the corridor lies.
  Vec2 unfolded_apex(const std::vector<Index>& corridor, Index k) const {
    const Halfedge& side = mesh_.halfedges[corridor[k]];
    const Vec2 origin = left_of(k);
    const Vec2 span = right_of(k) - origin;
    const double x = side.apex.x / side.length;
    const double y = side.apex.y / side.length;
    return {origin.x + x * span.x - y * span.y, origin.y + x * span.y + y * span.x};
  }

  void lay_next(const std::vector<Index>& corridor, Index k) {
    const Index apex = mesh_.apex(corridor[k]);
    const Index next = corridor[k + 1];
    const bool is_left = mesh_.opposite(next) == next_in_triangle(corridor[k]);
    const Index added = to_index(nodes_.size());
    nodes_.push_back({unfolded_apex(corridor, k), apex, k + 1, kNone, is_left});
    if (is_left) {
      widen(added, left_chain_, left_front_, right_chain_, right_front_, 1.0);
      ends_.push_back({added, ends_[k][1]});
    } else {
      widen(added, right_chain_, right_front_, left_chain_, left_front_, -1.0);
      ends_.push_back({ends_[k][0], added});
    }
  }

  void lay_last(Index b, const std::vector<Index>& corridor) {
    const Index k = to_index(corridor.size()) - 1;
    const Index added = to_index(nodes_.size());
    nodes_.push_back({unfolded_apex(corridor, k), b, k + 1, kNone, true});
    widen(added, left_chain_, left_front_, right_chain_, right_front_, 1.0);
  }

  double turn(Index p, Index q, Index r) const {
    return cross(nodes_[q].place - nodes_[p].place, nodes_[r].place - nodes_[p].place);
  }

  /// Adds a node to the chain on its side (`side` is +1 on the left, -1 on the right). The chains
  /// start at the apex, which itself is in neither, and their used parts begin at their fronts.
  void widen(Index added, std::vector<Index>& own, std::size_t& own_front,
             std::vector<Index>& other, std::size_t& other_front, double side) {
    while (own.size() > own_front) {
      const Index before = own.size() - own_front >= 2 ? own[own.size() - 2] : apex_;
      if (side * turn(before, own.back(), added) > 0.0) break;
      own.pop_back();
    }
    if (own.size() == own_front) {
      while (other_front < other.size() && side * turn(apex_, other[other_front], added) < 0.0) {
        apex_ = other[other_front++];
      }
      nodes_[added].previous = apex_;
    } else {
      nodes_[added].previous = own.back();
    }
    own.push_back(added);
  }

  /// Follows the shortest path back from the last node.
  double trace() {
    double length = 0.0;
    Index at = to_index(nodes_.size()) - 1;
    path_.push_back(at);
    while (nodes_[at].previous != kNone) {
      const Index before = nodes_[at].previous;
      length += norm(nodes_[at].place - nodes_[before].place);
      at = before;
      path_.push_back(at);
    }
    std::reverse(path_.begin(), path_.end());
    return length;
  }

  const HalfedgeMesh& mesh_;
  std::vector<Node> nodes_;
  std::vector<std::array<Index, 2>> ends_;  ///< one per directed edge: its left and right node
  std::vector<Index> left_chain_, right_chain_;
  std::size_t left_front_ = 0, right_front_ = 0;
  Index apex_ = 0;
  std::vector<Index> path_;
};

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

/// One straight piece of a path: from vertex `from` across the directed edges `crossed` to vertex
/// `to`. With none crossed, the piece runs along the edge between the two.
struct PathPiece {
  Index from = kNone;
  Index to = kNone;
  std::vector<Index> crossed;
};

/// The corridor of a path given by its pieces in order.
inline std::vector<Index> corridor_of_pieces(const HalfedgeMesh& mesh,
                                             const std::vector<PathPiece>& pieces) {
  std::vector<Index> corridor;
  Index arrived = kNone;  // the halfedge out of the last piece's end, in its last triangle
  for (const PathPiece& piece : pieces) {
    const bool on_edge = piece.crossed.empty();
    const Index edge = on_edge ? find_halfedge(mesh, piece.from, piece.to) : kNone;
    const Index leaving =
        on_edge ? edge : previous_in_triangle(mesh.opposite(piece.crossed.front()));
    if (arrived != kNone) turn_about_vertex(mesh, arrived, leaving, corridor);
    for (const Index h : piece.crossed) cross_edge(mesh, h, corridor);
    arrived = on_edge ? next_in_triangle(edge) : previous_in_triangle(piece.crossed.back());
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
