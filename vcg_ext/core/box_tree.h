// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of axis-parallel boxes: finds the few of many items that a query can concern.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/spatial_order.h"
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

/// The box of each triangle.
inline std::vector<Box> face_boxes(const std::vector<Vec3>& points,
                                   const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    boxes.push_back(box_of_triangle(points[t[0]], points[t[1]], points[t[2]]));
  }
  return boxes;
}

/// Items given by their boxes, in a binary tree of boxes. Built in O(n log n). Threads may share it
/// as long as none extends it. Visits come in a fixed order.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    const std::vector<std::uint64_t> sorted_codes = sort_items(codes());
    nodes_.reserve(boxes_.size());
    build(sorted_codes, 0, to_index(boxes_.size()));
  }

  /// A box round all; of no extent at the origin if there is none.
  Box bounds() const {
    return nodes_.empty() ? Box{Vec3::Zero(), Vec3::Zero()} : nodes_.front().box;
  }

  /// Makes the box of `item` hold `box`, too. O(log n).
  void extend(Index item, const Box& box) {
    const Index place = place_of_item_[item];
    boxes_[place].extend(box);
    for (Index at = 0;;) {
      nodes_[at].box.extend(box);
      const Index second = nodes_[at].second_child;
      if (second == kNone) return;
      at = place < nodes_[second].begin ? at + 1 : second;
    }
  }

  /// Calls `visit(item)` for the items whose box, and every box round it in the tree, has
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

  /// Calls `visit(i, j, worker)` once for each two items i != j whose boxes meet, in no fixed order
  /// if there are several `threads`, and then at the same time; `worker` is as in `parallel_for`.
  template <class Visit>
  void visit_meeting_pairs(unsigned threads, const Visit& visit) const {
    if (nodes_.empty()) return;
    constexpr std::size_t kTasks = 64;
    std::vector<NodePair> tasks;
    collect_tasks(0, boxes_.size() / kTasks, tasks);
    parallel_for(tasks.size(), threads, 1, [&](std::size_t task, unsigned worker) {
      const auto [a, b] = tasks[task];
      const auto visit_as_worker = [&](Index i, Index j) { visit(i, j, worker); };
      if (a == b) {
        visit_pairs_within(a, visit_as_worker);
      } else {
        visit_pairs_between(a, b, visit_as_worker);
      }
    });
  }

 private:
  static constexpr Index kLeafSize = 4;

  using NodePair = std::array<Index, 2>;

  struct Node {
    Box box;
    Index begin;  // items of a leaf
    Index end;
    Index second_child;  // kNone: a leaf; the first child follows its parent
  };

  // The Morton codes of the centres of the boxes, in shares of all.
  std::vector<std::uint64_t> codes() const {
    Box all = boxes_.front();
    for (const Box& box : boxes_) all.extend(box);
    const MortonGrid grid(all.low, all.high);
    std::vector<std::uint64_t> result;
    result.reserve(boxes_.size());
    for (const Box& box : boxes_) result.push_back(grid.code(0.5 * box.low + 0.5 * box.high));
    return result;
  }

  // Puts the boxes in the order of the leaves: what is visited together lies together.
  std::vector<std::uint64_t> sort_items(const std::vector<std::uint64_t>& codes) {
    items_ = sorted_by_key(codes);
    place_of_item_.resize(items_.size());
    std::vector<Box> boxes;
    std::vector<std::uint64_t> sorted;
    boxes.reserve(items_.size());
    sorted.reserve(items_.size());
    for (const Index item : items_) {
      place_of_item_[item] = to_index(boxes.size());
      boxes.push_back(boxes_[item]);
      sorted.push_back(codes[item]);
    }
    boxes_ = std::move(boxes);
    return sorted;
  }

  // Parts [begin, end) where the first bit changes in which its codes differ, down to leaves.
  // Returns the box of all.
  Box build(const std::vector<std::uint64_t>& codes, Index begin, Index end) {
    const Index self = to_index(nodes_.size());
    nodes_.push_back({boxes_[begin], begin, end, kNone});
    if (end - begin <= kLeafSize) {
      for (Index i = begin + 1; i < end; ++i) nodes_[self].box.extend(boxes_[i]);
      return nodes_[self].box;
    }
    const Index middle = first_of_second_half(codes, begin, end);
    Box box = build(codes, begin, middle);
    nodes_[self].second_child = to_index(nodes_.size());
    box.extend(build(codes, middle, end));
    return nodes_[self].box = box;
  }

  static Index first_of_second_half(const std::vector<std::uint64_t>& codes, Index begin,
                                    Index end) {
    std::uint64_t change = codes[begin] ^ codes[end - 1];
    if (change == 0) return begin + (end - begin) / 2;
    while ((change & (change - 1)) != 0) change &= change - 1;  // its highest bit
    const auto first =
        std::partition_point(codes.begin() + begin, codes.begin() + end,
                             [&](std::uint64_t code) { return (code & change) == 0; });
    return to_index(static_cast<std::size_t>(first - codes.begin()));
  }

  template <class Enter, class Visit>
  void visit_from(Index at, const Enter& enter, const Visit& visit) const {
    const Node& node = nodes_[at];
    if (!enter(node.box)) return;
    if (node.second_child == kNone) {
      for (Index i = node.begin; i < node.end; ++i) {
        if (enter(boxes_[i])) visit(items_[i]);
      }
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

  // Parts the search for pairs within a node into searches within nodes of no more than `size`
  // items, or leaves, and between others.
  void collect_tasks(Index at, std::size_t size, std::vector<NodePair>& tasks) const {
    const Node& node = nodes_[at];
    if (node.second_child == kNone || node.end - node.begin <= size) {
      tasks.push_back({at, at});
      return;
    }
    tasks.push_back({at + 1, node.second_child});
    collect_tasks(at + 1, size, tasks);
    collect_tasks(node.second_child, size, tasks);
  }

  template <class Visit>
  void visit_pairs_within(Index at, const Visit& visit) const {
    const Node& node = nodes_[at];
    if (node.second_child == kNone) {
      for (Index i = node.begin; i < node.end; ++i) {
        for (Index j = i + 1; j < node.end; ++j) visit_pair(i, j, visit);
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
          visit_pair(i, j, visit);
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
    if (boxes_[i].meets(boxes_[j])) visit(items_[i], items_[j]);
  }

  std::vector<Box> boxes_;    // in the order of the leaves
  std::vector<Index> items_;  // whose they are
  std::vector<Index> place_of_item_;
  std::vector<Node> nodes_;
};

}  // namespace mgf
