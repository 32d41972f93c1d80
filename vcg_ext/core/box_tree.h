// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of axis-parallel boxes: finds the few of many items that a query can concern.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A closed axis-parallel box.
struct Box {
  Vec3 low;
  Vec3 high;

  void extend(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool meets(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  /// Squared distance from `point` to the box; 0 inside.
  double squared_distance(const Vec3& point) const {
    return (low - point).cwiseMax(point - high).cwiseMax(Vec3::Zero()).squaredNorm();
  }
};

inline Box box_of_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

/// Items given by their boxes, in a binary tree of boxes. Built in O(n log n); immutable, so that
/// threads may share it. Visits come in a fixed order.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), items_(boxes_.size()) {
    for (Index i = 0; i < items_.size(); ++i) items_[i] = i;
    if (!items_.empty()) build(0, to_index(items_.size()));
  }

  /// Calls `visit(item)` for the items of every leaf that can be reached through boxes with
  /// `enter(box)`.
  template <class Enter, class Visit>
  void visit(const Enter& enter, const Visit& visit) const {
    if (!nodes_.empty()) visit_from(0, enter, visit);
  }

  /// Calls `visit(item, bound)` where `bound` is the squared distance to the nearest item so far
  /// and is lowered by the visitor; leaves out what is further away than that.
  template <class Visit>
  void visit_near(const Vec3& point, double bound, const Visit& visit) const {
    if (!nodes_.empty()) visit_near_from(0, point, bound, visit);
  }

  /// Calls `visit(i, j)` once for each two items i != j whose boxes meet.
  template <class Visit>
  void visit_meeting_pairs(const Visit& visit) const {
    if (!nodes_.empty()) visit_pairs_within(0, visit);
  }

 private:
  static constexpr Index kLeafSize = 4;

  struct Node {
    Box box;
    Index begin;  // items of a leaf
    Index end;
    Index second_child;  // kNone: a leaf; the first child follows its parent
  };

  void build(Index begin, Index end) {
    const Index self = to_index(nodes_.size());
    nodes_.push_back({boxes_[items_[begin]], begin, end, kNone});
    Vec3 low = centre(items_[begin]);
    Vec3 high = low;
    for (Index i = begin; i < end; ++i) {
      nodes_[self].box.extend(boxes_[items_[i]]);
      low = low.cwiseMin(centre(items_[i]));
      high = high.cwiseMax(centre(items_[i]));
    }
    if (end - begin <= kLeafSize) return;
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](Index i, Index j) {
                       const double ci = centre(i)[axis];
                       const double cj = centre(j)[axis];
                       return ci != cj ? ci < cj : i < j;
                     });
    build(begin, middle);
    nodes_[self].second_child = to_index(nodes_.size());
    build(middle, end);
  }

  Vec3 centre(Index item) const { return 0.5 * boxes_[item].low + 0.5 * boxes_[item].high; }

  template <class Enter, class Visit>
  void visit_from(Index at, const Enter& enter, const Visit& visit) const {
    const Node& node = nodes_[at];
    if (!enter(node.box)) return;
    if (node.second_child == kNone) {
      for (Index i = node.begin; i < node.end; ++i) visit(items_[i]);
      return;
    }
    visit_from(at + 1, enter, visit);
    visit_from(node.second_child, enter, visit);
  }

  template <class Visit>
  void visit_near_from(Index at, const Vec3& point, double& bound, const Visit& visit) const {
    const Node& node = nodes_[at];
    if (node.second_child == kNone) {
      for (Index i = node.begin; i < node.end; ++i) visit(items_[i], bound);
      return;
    }
    Index near = at + 1;
    Index far = node.second_child;
    double near_distance = nodes_[near].box.squared_distance(point);
    double far_distance = nodes_[far].box.squared_distance(point);
    if (far_distance < near_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (near_distance <= bound) visit_near_from(near, point, bound, visit);
    if (far_distance <= bound) visit_near_from(far, point, bound, visit);
  }

  template <class Visit>
  void visit_pairs_within(Index at, const Visit& visit) const {
    const Node& node = nodes_[at];
    if (node.second_child == kNone) {
      for (Index i = node.begin; i < node.end; ++i) {
        for (Index j = i + 1; j < node.end; ++j) visit_pair(items_[i], items_[j], visit);
      }
      return;
    }
    visit_pairs_within(at + 1, visit);
    visit_pairs_within(node.second_child, visit);
    visit_pairs_between(at + 1, node.second_child, visit);
  }

  template <class Visit>
  void visit_pairs_between(Index a, Index b, const Visit& visit) const {
    if (!nodes_[a].box.meets(nodes_[b].box)) return;
    const bool leaf_a = nodes_[a].second_child == kNone;
    const bool leaf_b = nodes_[b].second_child == kNone;
    if (leaf_a && leaf_b) {
      for (Index i = nodes_[a].begin; i < nodes_[a].end; ++i) {
        for (Index j = nodes_[b].begin; j < nodes_[b].end; ++j) {
          visit_pair(items_[i], items_[j], visit);
        }
      }
      return;
    }
    const Index size_a = nodes_[a].end - nodes_[a].begin;
    const Index size_b = nodes_[b].end - nodes_[b].begin;
    if (leaf_b || (!leaf_a && size_a >= size_b)) std::swap(a, b);
    visit_pairs_between(a, b + 1, visit);
    visit_pairs_between(a, nodes_[b].second_child, visit);
  }

  template <class Visit>
  void visit_pair(Index i, Index j, const Visit& visit) const {
    if (boxes_[i].meets(boxes_[j])) visit(i, j);
  }

  std::vector<Box> boxes_;
  std::vector<Index> items_;
  std::vector<Node> nodes_;
};

}  // namespace mgf
