// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of axis-parallel boxes: finds the few of many items that a query can concern.
#pragma once

#include <algorithm>
#include <array>
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

/// Items given by their boxes, in a binary tree of boxes. Built in O(n log n). Threads may share it
/// as long as none extends it. Visits come in a fixed order.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    std::vector<Place> places = centres();
    build(places, 0, to_index(places.size()));
    sort_items(places);
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
  // The centre of an item's box, as far as single precision tells, in shares of all: small, as
  // these are moved about a lot.
  struct Place {
    std::array<float, 3> centre;
    Index item;
  };

  std::vector<Place> centres() const {
    Box all = boxes_.front();
    for (const Box& box : boxes_) all.extend(box);
    const double extent = (all.high - all.low).maxCoeff();
    const double scale = extent > 0.0 ? 1.0 / extent : 0.0;
    std::vector<Place> places;
    places.reserve(boxes_.size());
    for (Index i = 0; i < boxes_.size(); ++i) {
      const Vec3 share = scale * ((0.5 * boxes_[i].low + 0.5 * boxes_[i].high) - all.low);
      places.push_back({{static_cast<float>(share.x()), static_cast<float>(share.y()),
                         static_cast<float>(share.z())},
                        i});
    }
    return places;
  }

  // Halves [begin, end) across its widest axis, down to leaves. Returns the box of all.
  Box build(std::vector<Place>& places, Index begin, Index end) {
    const Index self = to_index(nodes_.size());
    nodes_.push_back({boxes_[places[begin].item], begin, end, kNone});
    if (end - begin <= kLeafSize) {
      for (Index i = begin + 1; i < end; ++i) nodes_[self].box.extend(boxes_[places[i].item]);
      return nodes_[self].box;
    }
    const std::size_t axis = widest_axis(places, begin, end);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(places.begin() + begin, places.begin() + middle, places.begin() + end,
                     [axis](const Place& p, const Place& q) {
                       const float x = p.centre[axis];
                       const float y = q.centre[axis];
                       return x != y ? x < y : p.item < q.item;
                     });
    Box box = build(places, begin, middle);
    nodes_[self].second_child = to_index(nodes_.size());
    box.extend(build(places, middle, end));
    return nodes_[self].box = box;
  }

  static std::size_t widest_axis(const std::vector<Place>& places, Index begin, Index end) {
    std::array<float, 3> low = places[begin].centre;
    std::array<float, 3> high = low;
    for (Index i = begin + 1; i < end; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], places[i].centre[axis]);
        high[axis] = std::max(high[axis], places[i].centre[axis]);
      }
    }
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
    }
    return widest;
  }

  // Puts the boxes in the order of the leaves: what is visited together lies together.
  void sort_items(const std::vector<Place>& places) {
    std::vector<Box> sorted;
    sorted.reserve(places.size());
    items_.reserve(places.size());
    place_of_item_.resize(places.size());
    for (const Place& place : places) {
      place_of_item_[place.item] = to_index(items_.size());
      sorted.push_back(boxes_[place.item]);
      items_.push_back(place.item);
    }
    boxes_ = std::move(sorted);
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
