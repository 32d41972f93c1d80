// SPDX-License-Identifier: GPL-3.0-or-later
// From any corridor to a locally shortest path: straighten, and flip past vertices.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// Shortens paths on one mesh; keeps its memory between calls.
class PathShortener {
 public:
  explicit PathShortener(const HalfedgeMesh& mesh) : mesh_(mesh), funnel_(mesh) {}

  /// Makes `corridor` from a to b one whose shortest path is locally shortest on the surface, and
  /// returns that path's length. Where the path bends at a vertex with less than a half turn on the
  /// far side, the corridor is led past the vertex there; and past a convex vertex close by where
  /// the way round its far side is shorter.
  double shorten(Index a, Index b, std::vector<Index>& corridor) {
    trim_corridor(mesh_, a, b, corridor);
    double length = straighten_and_flip(a, b, corridor, funnel_.straighten(a, b, corridor));
    for (int pass = 0; pass < kMostPasses && lead_round_peak(corridor); ++pass) {
      std::swap(other_way_, flipped_);
      trim_corridor(mesh_, a, b, other_way_);
      const double shorter =
          straighten_and_flip(a, b, other_way_, funnel_.straighten(a, b, other_way_));
      if (!(shorter < length * (1.0 - kLeastGain))) {
        funnel_.straighten(a, b, corridor);
        break;
      }
      length = shorter;
      std::swap(corridor, other_way_);
    }
    return length;
  }

  /// The path that `shorten` ended with.
  const Funnel& funnel() const { return funnel_; }

 private:
  /// Flips bends until none gains by it. The funnel holds the corridor's path, before and after.
  double straighten_and_flip(Index a, Index b, std::vector<Index>& corridor, double length) {
    for (int pass = 0; pass < kMostPasses && flip_bends(corridor); ++pass) {
      trim_corridor(mesh_, a, b, flipped_);
      const double shorter = funnel_.straighten(a, b, flipped_);
      if (!(shorter < length * (1.0 - kLeastGain))) {
        funnel_.straighten(a, b, corridor);
        break;
      }
      length = shorter;
      std::swap(corridor, flipped_);
    }
    return length;
  }

  /// Writes `corridor` led round the other side of the one convex vertex on its border where that
  /// promises most to `flipped_`; returns whether there is one.
  bool lead_round_peak(const std::vector<Index>& corridor) {
    const std::vector<Index>& path = funnel_.path();
    double best_gain = 0.0;
    Index best = kNone;
    std::size_t piece = 0;  // the path's piece that portals are on, by the bend that ends it
    for (Index i = 1; i + 1 < funnel_.node_count(); ++i) {
      const Funnel::Node& node = funnel_.node(i);
      while (piece + 2 < path.size() && funnel_.node(path[piece + 1]).portal <= node.portal)
        ++piece;
      const double around = mesh_.total_angle[node.vertex];
      if (around >= 2.0 * kPi || i == path[piece] || i == path[piece + 1]) continue;
      const Vec2 back = funnel_.node(path[piece]).place - node.place;
      const Vec2 ahead = funnel_.node(path[piece + 1]).place - node.place;
      if (!(dot(back, ahead) < 0.0)) continue;
      const double seen = std::atan2(std::abs(cross(back, ahead)), dot(back, ahead));
      if (!(seen > around - seen + kLeastTurn)) continue;
      const double product = 2.0 * norm(back) * norm(ahead);
      const double gain = product * (std::cos(around - seen) - std::cos(seen));
      if (gain > best_gain) {
        best_gain = gain;
        best = i;
      }
    }
    if (best == kNone) return false;
    flipped_.clear();
    const Funnel::Node& peak = funnel_.node(best);
    const Index last = last_portal_of(peak, corridor);
    for (Index k = 0; k < peak.portal; ++k) cross_edge(mesh_, corridor[k], flipped_);
    pass_other_side(peak, corridor[peak.portal], corridor[last]);
    for (Index k = last + 1; k < corridor.size(); ++k) cross_edge(mesh_, corridor[k], flipped_);
    return true;
  }

  /// The last directed edge of the corridor that ends at the node's vertex without a break.
  Index last_portal_of(const Funnel::Node& node, const std::vector<Index>& corridor) const {
    Index last = node.portal;
    while (last + 1 < corridor.size() && end_of(corridor[last + 1], node.is_left) == node.vertex) {
      ++last;
    }
    return last;
  }

  /// Writes `corridor` with all bends flipped that gain by it and don't touch to `flipped_`;
  /// returns whether there are any.
  bool flip_bends(const std::vector<Index>& corridor) {
    const std::vector<Index>& path = funnel_.path();
    flipped_.clear();
    bool any = false;
    Index done = 0;  // portals before this are copied
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const Funnel::Node& bend = funnel_.node(path[i]);
      const Vec2 in = bend.place - funnel_.node(path[i - 1]).place;
      const Vec2 out = funnel_.node(path[i + 1]).place - bend.place;
      const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
      if (!(turn > mesh_.total_angle[bend.vertex] - 2.0 * kPi + kLeastTurn)) continue;
      const Index first = bend.portal;
      if (first < done) continue;
      const Index last = last_portal_of(bend, corridor);
      for (; done < first; ++done) cross_edge(mesh_, corridor[done], flipped_);
      pass_other_side(bend, corridor[first], corridor[last]);
      done = last + 1;
      any = true;
    }
    for (; any && done < corridor.size(); ++done) cross_edge(mesh_, corridor[done], flipped_);
    return any;
  }

  Index end_of(Index h, bool left) const { return left ? mesh_.tail(h) : mesh_.head(h); }

  void pass_other_side(const Funnel::Node& bend, Index first, Index last) {
    Index h = bend.is_left ? mesh_.rotated_back(first) : mesh_.opposite(first);
    const Index to = bend.is_left ? last : next_in_triangle(last);
    while (h != to) {
      if (bend.is_left) {
        cross_edge(mesh_, mesh_.opposite(h), flipped_);
        h = mesh_.rotated_back(h);
      } else {
        h = mesh_.rotated(h);
        cross_edge(mesh_, h, flipped_);
      }
    }
  }

  static constexpr int kMostPasses = 64;
  static constexpr double kLeastGain = 1e-12;  ///< relative; smaller gains are rounding
  static constexpr double kLeastTurn = 1e-10;  ///< smaller turns are rounding

  const HalfedgeMesh& mesh_;
  Funnel funnel_;
  std::vector<Index> flipped_;    ///< the corridor with some vertices passed on the other side
  std::vector<Index> other_way_;  ///< the corridor round a peak
};

}  // namespace mgf
