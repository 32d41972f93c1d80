// SPDX-License-Identifier: GPL-3.0-or-later
// A corridor laid flat, and the shortest path in it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
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

  explicit Funnel(const HalfedgeMesh& mesh) : mesh_(&mesh) {}

  /// Lays the corridor from a to b flat and finds the shortest path in it; returns its length.
  double straighten(Index a, Index b, const std::vector<Index>& corridor) {
    return straighten(a, b, corridor, *this, 0);
  }

  /// The same for a corridor whose first `same` directed edges are those of the last corridor of
  /// `like`, from a, too: only what comes after them is laid.
  double straighten(Index a, Index b, const std::vector<Index>& corridor, const Funnel& like,
                    std::size_t same) {
    path_.clear();
    if (corridor.empty()) return straighten_edge(a, b);
    if (same == 0) {
      lay_first(a, corridor.front());
    } else {
      begin_like(like, same);
    }
    for (std::size_t k = ends_.size(); k < corridor.size(); ++k)
      lay_next(corridor, to_index(k) - 1);
    lay_last(b, corridor);
    return trace();
  }

  /// The path found: nodes from the start, over the bends, to the end.
  const std::vector<Index>& path() const { return path_; }
  const Node& node(Index i) const { return nodes_[i]; }
  /// All vertices of the strip in the order they come up: the start, the border, the end.
  Index node_count() const { return to_index(nodes_.size()); }

  /// Ends of the directed edge number k of the corridor in the flat strip.
  Vec2 left_of(Index k) const { return nodes_[ends_[k][kLeft]].place; }
  Vec2 right_of(Index k) const { return nodes_[ends_[k][kRight]].place; }

  /// Unit tangents of the path found, leaving a and leaving b.
  Vec3 tangent_at_start(Index a, Index b, const std::vector<Index>& corridor) const {
    if (corridor.empty()) return edge_tangent(a, b);
    // The first directed edge lies on the x axis, and the first triangle below it.
    const Vec2 leaving = nodes_[path_[1]].place - nodes_[path_[0]].place;
    return direction_in_triangle(*mesh_, mesh_->opposite(corridor.front()),
                                 {-leaving.x, -leaving.y});
  }
  Vec3 tangent_at_end(Index a, Index b, const std::vector<Index>& corridor) const {
    if (corridor.empty()) return edge_tangent(b, a);
    const Index last = to_index(corridor.size()) - 1;
    const Vec2 leaving = nodes_[path_[path_.size() - 2]].place - nodes_[path_.back()].place;
    const Vec2 along = right_of(last) - left_of(last);
    const double length = norm(along);
    return direction_in_triangle(*mesh_, corridor.back(),
                                 {dot(along, leaving) / length, cross(along, leaving) / length});
  }

 private:
  static constexpr std::size_t kLeft = 0;
  static constexpr std::size_t kRight = 1;

  /// The shortest path from the apex to one side's last node: the nodes from `front` on.
  struct Chain {
    std::vector<Index> nodes;
    std::size_t front = 0;
  };

  Vec3 edge_tangent(Index from, Index to) const {
    const Vec3 edge = mesh_->points[to] - mesh_->points[from];
    const double length = edge.norm();
    return length > 0.0 ? Vec3(edge / length) : Vec3(Vec3::Zero());
  }

  double straighten_edge(Index a, Index b) {
    const double length = (mesh_->points[a] - mesh_->points[b]).norm();
    nodes_.clear();
    ends_.clear();
    nodes_.push_back({{0.0, 0.0}, a, 0, kNone, false});
    nodes_.push_back({{length, 0.0}, b, 0, 0, false});
    path_ = {0, 1};
    return length;
  }

  void lay_first(Index a, Index h) {
    const Halfedge& back = mesh_->halfedges[mesh_->opposite(h)];
    nodes_.clear();
    nodes_.push_back({{back.length - back.apex.x, -back.apex.y}, a, 0, kNone, false});
    nodes_.push_back({{0.0, 0.0}, mesh_->tail(h), 0, 0, true});
    nodes_.push_back({{back.length, 0.0}, mesh_->head(h), 0, 0, false});
    ends_.assign(1, {1, 2});
    clear_chains();
    apex_ = 0;
    chains_[kLeft].nodes.push_back(1);
    chains_[kRight].nodes.push_back(2);
  }

  /// Takes over what `like` laid up to its first `count` directed edges. The funnel is then what
  /// the shortest paths to the two ends of the last of these don't share.
  void begin_like(const Funnel& like, std::size_t count) {
    // Its nodes are the start, two for the first directed edge, and one for each other.
    nodes_.assign(like.nodes_.begin(),
                  like.nodes_.begin() + static_cast<std::ptrdiff_t>(count + 2));
    ends_.assign(like.ends_.begin(), like.ends_.begin() + static_cast<std::ptrdiff_t>(count));
    clear_chains();
    std::array<Index, 2> ends = ends_.back();
    while (ends[kLeft] != ends[kRight]) {
      // A node comes after its previous one, so the later of the two is not shared.
      const std::size_t later = ends[kLeft] > ends[kRight] ? kLeft : kRight;
      chains_[later].nodes.push_back(ends[later]);
      ends[later] = nodes_[ends[later]].previous;
    }
    apex_ = ends[kLeft];
    for (Chain& chain : chains_) std::reverse(chain.nodes.begin(), chain.nodes.end());
  }

  /// Where the apex of directed edge number k of the corridor lies.
  Vec2 unfolded_apex(const std::vector<Index>& corridor, Index k) const {
    const Halfedge& side = mesh_->halfedges[corridor[k]];
    const Vec2 origin = left_of(k);
    const Vec2 span = right_of(k) - origin;
    // A very short span is not as long as it should be; what follows must not take over its scale.
    constexpr double kRounding = 1e-9;
    const double squared = dot(span, span);
    const bool is_short = std::abs(squared - side.length * side.length) > kRounding * squared;
    const double scale = 1.0 / (is_short ? std::sqrt(squared) : side.length);
    const double x = side.apex.x * scale;
    const double y = side.apex.y * scale;
    return {origin.x + x * span.x - y * span.y, origin.y + x * span.y + y * span.x};
  }

  /// Enters the next triangle: its new vertex is on the left or on the right of the way on.
  void lay_next(const std::vector<Index>& corridor, Index k) {
    const Index entered = corridor[k];
    const bool is_left = mesh_->opposite(corridor[k + 1]) == next_in_triangle(entered);
    const std::size_t side = is_left ? kLeft : kRight;
    const Index added = to_index(nodes_.size());
    nodes_.push_back({unfolded_apex(corridor, k), mesh_->apex(entered), k + 1, kNone, is_left});
    ends_.push_back(ends_[k]);
    ends_.back()[side] = added;
    widen(added, side);
  }

  void lay_last(Index b, const std::vector<Index>& corridor) {
    const Index k = to_index(corridor.size()) - 1;
    const Index added = to_index(nodes_.size());
    nodes_.push_back({unfolded_apex(corridor, k), b, k + 1, kNone, true});
    widen(added, kLeft);
  }

  double turn(Index p, Index q, Index r) const {
    return cross(nodes_[q].place - nodes_[p].place, nodes_[r].place - nodes_[p].place);
  }

  /// Adds a node to the chain on its side. The chains start at the apex, which itself is in
  /// neither.
  void widen(Index added, std::size_t side) {
    const double sign = side == kLeft ? 1.0 : -1.0;
    Chain& own = chains_[side];
    while (own.nodes.size() > own.front) {
      const std::size_t count = own.nodes.size();
      const Index before = count - own.front >= 2 ? own.nodes[count - 2] : apex_;
      if (sign * turn(before, own.nodes.back(), added) > 0.0) break;
      own.nodes.pop_back();
    }
    if (own.nodes.size() == own.front) {
      Chain& other = chains_[1 - side];
      while (other.front < other.nodes.size() &&
             sign * turn(apex_, other.nodes[other.front], added) < 0.0) {
        apex_ = other.nodes[other.front++];
      }
      nodes_[added].previous = apex_;
    } else {
      nodes_[added].previous = own.nodes.back();
    }
    own.nodes.push_back(added);
  }

  void clear_chains() {
    for (Chain& chain : chains_) {
      chain.nodes.clear();
      chain.front = 0;
    }
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

  const HalfedgeMesh* mesh_;  ///< a pointer, so that funnels can be swapped
  std::vector<Node> nodes_;
  std::vector<std::array<Index, 2>> ends_;  ///< one per directed edge: its left and right node
  std::array<Chain, 2> chains_;             ///< left and right
  Index apex_ = 0;
  std::vector<Index> path_;
};

}  // namespace mgf
