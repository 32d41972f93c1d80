// SPDX-License-Identifier: GPL-3.0-or-later
// From any corridor to a locally shortest path: straighten, and flip past vertices.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/funnel.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"

namespace mgf {

/// How far a path is shortened.
enum class ShorteningEffort {
  kRough,  ///< a few passes over its bends: near a locally shortest path, for a bound
  kFull,   ///< until it is locally shortest, trying the ways round convex vertices, too
};

/// Shortens paths on one mesh; keeps its memory between calls.
class PathShortener {
 public:
  explicit PathShortener(const HalfedgeMesh& mesh,
                         ShorteningEffort effort = ShorteningEffort::kFull)
      : mesh_(mesh),
        most_flips_(effort == ShorteningEffort::kFull ? kMostPasses : 2),
        most_peaks_(effort == ShorteningEffort::kFull ? kMostPasses : 0),
        best_(mesh),
        other_way_(mesh),
        flipped_(mesh) {}

  /// Makes `corridor` from a to b one whose shortest path is locally shortest on the surface, and
  /// returns that path's length (or near to it, with little effort). Where the path bends at a
  /// vertex with less than a half turn on the far side, the corridor is led past the vertex there;
  /// and past a convex vertex close by where the way round its far side is shorter.
  double shorten(Index a, Index b, std::vector<Index>& corridor) {
    trim_corridor(mesh_, a, b, corridor);
    best_.corridor.swap(corridor);
    best_.length = best_.funnel.straighten(a, b, best_.corridor);
    flip_all(a, b, best_);
    for (int pass = 0; pass < most_peaks_ && lead_round_peak(best_, other_way_.corridor); ++pass) {
      straighten_like(a, b, best_, other_way_);
      flip_all(a, b, other_way_);
      if (!(other_way_.length < best_.length * (1.0 - kLeastGain))) break;
      std::swap(best_, other_way_);
    }
    best_.corridor.swap(corridor);
    return best_.length;
  }

  /// The unit tangents of the path that `shorten` ended with, leaving a and leaving b; its
  /// arguments again.
  std::array<Vec3, 2> tangents(Index a, Index b, const std::vector<Index>& corridor) const {
    return {best_.funnel.tangent_at_start(a, b, corridor),
            best_.funnel.tangent_at_end(a, b, corridor)};
  }

 private:
  /// A corridor with its shortest path.
  struct Strip {
    explicit Strip(const HalfedgeMesh& mesh) : funnel(mesh) {}
    std::vector<Index> corridor;
    Funnel funnel;
    double length = 0.0;
  };

  /// Flips bends until none gains by it.
  void flip_all(Index a, Index b, Strip& strip) {
    for (int pass = 0; pass < most_flips_ && flip_bends(strip, flipped_.corridor); ++pass) {
      straighten_like(a, b, strip, flipped_);
      if (!(flipped_.length < strip.length * (1.0 - kLeastGain))) break;
      std::swap(strip, flipped_);
    }
  }

  /// Straightens the corridor of `strip`, which begins like that of `like`.
  void straighten_like(Index a, Index b, const Strip& like, Strip& strip) {
    trim_corridor(mesh_, a, b, strip.corridor);
    const auto differ = std::mismatch(like.corridor.begin(), like.corridor.end(),
                                      strip.corridor.begin(), strip.corridor.end());
    const auto same = static_cast<std::size_t>(differ.first - like.corridor.begin());
    strip.length = strip.funnel.straighten(a, b, strip.corridor, like.funnel, same);
  }

  /// Writes the strip's corridor, led round the other side of the one convex vertex on its border
  /// where that promises most, to `out`; returns whether there is one.
  bool lead_round_peak(const Strip& strip, std::vector<Index>& out) const {
    const Funnel& funnel = strip.funnel;
    const std::vector<Index>& path = funnel.path();
    double best_gain = 0.0;
    Index best = kNone;
    std::size_t piece = 0;  // the path's piece that portals are on, by the bend that ends it
    for (Index i = 1; i + 1 < funnel.node_count(); ++i) {
      const Funnel::Node& node = funnel.node(i);
      while (piece + 2 < path.size() && funnel.node(path[piece + 1]).portal <= node.portal) ++piece;
      const Vec2 back = funnel.node(path[piece]).place - node.place;
      const Vec2 ahead = funnel.node(path[piece + 1]).place - node.place;
      if (!is_wider_than_half(node.vertex, back, ahead)) continue;
      if (i == path[piece] || i == path[piece + 1]) continue;
      const double around = mesh_.total_angle[node.vertex];
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
    out.clear();
    const Funnel::Node& peak = funnel.node(best);
    const Index last = last_portal_of(peak, strip.corridor);
    copy(strip.corridor, 0, peak.portal, out);
    pass_other_side(peak, strip.corridor[peak.portal], strip.corridor[last], out);
    copy(strip.corridor, last + 1, to_index(strip.corridor.size()), out);
    return true;
  }

  /// Whether v is convex and the angle there between two directions is blunt and more than half of
  /// what is around v, up to rounding.
  bool is_wider_than_half(Index v, Vec2 back, Vec2 ahead) const {
    const double half = mesh_.half_angle_cosine[v];
    const double product = dot(back, ahead);
    if (half <= -1.0 + kLeastTurn || product >= 0.0) return false;
    return half >= 0.0 || product * product > half * half * dot(back, back) * dot(ahead, ahead);
  }

  /// The last directed edge of the corridor that ends at the node's vertex without a break.
  Index last_portal_of(const Funnel::Node& node, const std::vector<Index>& corridor) const {
    Index last = node.portal;
    while (last + 1 < corridor.size() && end_of(corridor[last + 1], node.is_left) == node.vertex) {
      ++last;
    }
    return last;
  }

  /// Writes the strip's corridor, with all bends flipped that gain by it and don't touch, to `out`;
  /// returns whether there are any.
  bool flip_bends(const Strip& strip, std::vector<Index>& out) const {
    const std::vector<Index>& corridor = strip.corridor;
    const Funnel& funnel = strip.funnel;
    const std::vector<Index>& path = funnel.path();
    out.clear();
    bool any = false;
    Index done = 0;  // portals before this are copied
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const Funnel::Node& bend = funnel.node(path[i]);
      const Vec2 before = bend.place - funnel.node(path[i - 1]).place;
      const Vec2 after = funnel.node(path[i + 1]).place - bend.place;
      const double turn = std::abs(std::atan2(cross(before, after), dot(before, after)));
      if (!(turn > mesh_.total_angle[bend.vertex] - 2.0 * kPi + kLeastTurn)) continue;
      const Index first = bend.portal;
      if (first < done) continue;
      const Index last = last_portal_of(bend, corridor);
      copy(corridor, done, first, out);
      pass_other_side(bend, corridor[first], corridor[last], out);
      done = last + 1;
      any = true;
    }
    if (any) copy(corridor, done, to_index(corridor.size()), out);
    return any;
  }

  /// Appends the corridor's directed edges [first, last) to `out`.
  void copy(const std::vector<Index>& corridor, Index first, Index last,
            std::vector<Index>& out) const {
    cross_edges(mesh_, corridor.data() + first, corridor.data() + last, out);
  }

  Index end_of(Index h, bool left) const { return left ? mesh_.tail(h) : mesh_.head(h); }

  void pass_other_side(const Funnel::Node& bend, Index first, Index last,
                       std::vector<Index>& out) const {
    Index h = bend.is_left ? mesh_.rotated_back(first) : mesh_.opposite(first);
    const Index to = bend.is_left ? last : next_in_triangle(last);
    while (h != to) {
      if (bend.is_left) {
        cross_edge(mesh_, mesh_.opposite(h), out);
        h = mesh_.rotated_back(h);
      } else {
        h = mesh_.rotated(h);
        cross_edge(mesh_, h, out);
      }
    }
  }

  static constexpr int kMostPasses = 64;
  static constexpr double kLeastGain = 1e-12;  ///< relative; smaller gains are rounding
  static constexpr double kLeastTurn = 1e-10;  ///< smaller turns are rounding

  const HalfedgeMesh& mesh_;
  int most_flips_;  ///< passes over the bends
  int most_peaks_;  ///< convex vertices to be led round
  Strip best_;
  Strip other_way_;  ///< round a peak
  Strip flipped_;    ///< with some vertices passed on the other side
};

}  // namespace mgf
