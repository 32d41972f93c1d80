// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton as smooth curves: the zigzag of Voronoi edges removed, the graph, its junctions and
// tips kept, and the shape never left.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/graph_edits.h"
#include "vcg_ext/skeleton/resampling.h"
#include "vcg_ext/skeleton/shape_interior.h"
#include "vcg_ext/skeleton/stiff_curve.h"

namespace mgf {

/// How smooth, and how near to the raw skeleton.
struct SmoothingOptions {
  double step = 0.2;                     ///< between nodes along a branch, in local radii
  double max_shift = 0.5;                ///< of a point from its raw place, in local radii
  double max_turning = 4.0 / 180 * kPi;  ///< mean angle between segments to aim at, radians
};

/// The smooth skeleton: a graph with the branches of the raw one, evenly resampled.
/// Edges carry the measures of the raw edge beneath their middle.
struct SmoothSkeleton : CurveSkeleton {
  std::vector<Index> raw_node;     ///< one per node: the tip, junction or isolated node of the raw
                                   ///< skeleton that it is, exactly in its place; else kNone
  std::vector<Index> raw_edge;     ///< one per edge: the raw edge beneath its middle
  std::vector<Index> edge_branch;  ///< one per edge: id in the BranchGraph
  Index outside_edges = 0;         ///< edges that leave the shape: those of the raw one, if any
  double mean_turning = 0.0;       ///< angle between consecutive segments of a branch, radians
};

namespace smoothing {

/// Rounds of stiffening (each doubling the smoothing length) and of yielding to constraints.
inline constexpr int kStiffenings = 4;
inline constexpr int kYieldings = 10;
/// First smoothing length in local radii: waves shorter than about six times this are damped.
inline constexpr double kSmoothingLength = 0.25;

/// Sum of the angles between consecutive segments, and their number.
struct Turning {
  double sum = 0.0;
  std::size_t count = 0;
  double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0.0; }
};

inline Turning turning_of(const std::vector<Vec3>& points) {
  Turning turning;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 before = points[i] - points[i - 1];
    const Vec3 after = points[i + 1] - points[i];
    turning.sum += std::atan2(before.cross(after).norm(), before.dot(after));
    ++turning.count;
  }
  return turning;
}

/// The samples whose smooth places break a constraint: shifted too far from the curve (judged at
/// samples and at the curve's own nodes), or an end of a segment that leaves the shape.
inline std::vector<char> broken_constraints(const BranchCurve& curve,
                                            const std::vector<CurveSample>& samples,
                                            const std::vector<Vec3>& smooth, double max_shift,
                                            const ShapeInterior& shape) {
  const std::size_t last = samples.size() - 1;
  std::vector<char> broken(samples.size(), 0);
  for (std::size_t k = 0; k <= last; ++k) {
    if ((smooth[k] - samples[k].point).norm() > max_shift * samples[k].radius) broken[k] = 1;
    if (k < last && !shape.stays_inside(smooth[k], smooth[k + 1])) broken[k] = broken[k + 1] = 1;
  }
  const double step = curve.parameter.back() / static_cast<double>(last);
  for (std::size_t i = 0; i < curve.point.size(); ++i) {
    const double at = step > 0.0 ? curve.parameter[i] / step : 0.0;
    const std::size_t k = std::min(last - 1, static_cast<std::size_t>(at));
    const double share = at - static_cast<double>(k);
    const Vec3 place = (1.0 - share) * smooth[k] + share * smooth[k + 1];
    if ((place - curve.point[i]).norm() > max_shift * curve.radius[i]) {
      broken[k] = broken[k + 1] = 1;
    }
  }
  return broken;
}

/// Where the samples go, and whether that keeps every constraint.
struct Attempt {
  std::vector<Vec3> points;
  bool allowed = false;
};

/// Smooths at one stiffness, tying samples that break a constraint ever closer to their raw place.
inline Attempt smooth_within_limits(const BranchCurve& curve,
                                    const std::vector<CurveSample>& samples, bool closed,
                                    double stiffness, const SmoothingOptions& options,
                                    const ShapeInterior& shape) {
  constexpr double kTighter = 8.0;
  std::vector<Vec3> raw;
  raw.reserve(samples.size());
  for (const CurveSample& sample : samples) raw.push_back(sample.point);
  std::vector<double> tie(samples.size(), 1.0);
  Attempt attempt;
  for (int round = 0; round < kYieldings; ++round) {
    attempt.points = stiff_curve(raw, tie, stiffness, closed);
    const std::vector<char> broken =
        broken_constraints(curve, samples, attempt.points, options.max_shift, shape);
    attempt.allowed = std::find(broken.begin(), broken.end(), char{1}) == broken.end();
    if (attempt.allowed) break;
    for (std::size_t k = 0; k < tie.size(); ++k) {
      if (broken[k]) tie[k] *= kTighter;
    }
    if (closed) tie.front() = tie.back() = std::max(tie.front(), tie.back());
  }
  return attempt;
}

/// The least stiff smooth curve that turns no more than asked; else the one that turns least.
inline std::vector<Vec3> smooth_points(const BranchCurve& curve,
                                       const std::vector<CurveSample>& samples, bool closed,
                                       const SmoothingOptions& options,
                                       const ShapeInterior& shape) {
  std::vector<Vec3> best;
  double best_turning = 0.0;
  bool best_allowed = false;
  double reach = kSmoothingLength / options.step;  // in steps
  for (int i = 0; i < kStiffenings; ++i, reach *= 2.0) {
    Attempt attempt =
        smooth_within_limits(curve, samples, closed, std::pow(reach, 4), options, shape);
    const double turning = turning_of(attempt.points).mean();
    const bool better = best.empty() || (attempt.allowed && !best_allowed) ||
                        (attempt.allowed == best_allowed && turning < best_turning);
    if (better) {
      best = std::move(attempt.points);
      best_turning = turning;
      best_allowed = attempt.allowed;
    }
    if (best_allowed && best_turning <= options.max_turning) break;
  }
  return best;
}

/// Puts samples back on the curve until every segment between samples that isn't the curve's own
/// is inside. Returns, per segment, whether it has to follow the curve's nodes.
inline std::vector<char> retreat_inside(const std::vector<CurveSample>& samples, bool closed,
                                        const ShapeInterior& shape, std::vector<Vec3>& points) {
  const std::size_t segments = samples.size() - 1;
  std::vector<char> on_curve(samples.size(), 0);
  on_curve.front() = on_curve.back() = closed ? 0 : 1;
  std::vector<char> follows(segments, 0);
  const auto put_back = [&](std::size_t k) {
    points[k] = samples[k].point;
    on_curve[k] = 1;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t k = 0; k < segments; ++k) {
      if (follows[k] || shape.stays_inside(points[k], points[k + 1])) continue;
      changed = true;
      follows[k] = on_curve[k] != 0 && on_curve[k + 1] != 0 ? 1 : 0;
      put_back(k);
      put_back(k + 1);
      if (closed && (k == 0 || k + 1 == segments)) {
        put_back(0);
        put_back(segments);
      }
    }
  }
  return follows;
}

/// A branch's smooth polyline with, per point, its place on the raw curve.
inline std::vector<CurveSample> smooth_branch(const Branch& branch, const BranchCurve& curve,
                                              bool closed, const SmoothingOptions& options,
                                              const ShapeInterior& shape) {
  // So that no edge becomes a loop and no two edges join the same nodes.
  const std::size_t least = branch.first_node == branch.last_node ? 3 : 2;
  const std::size_t count =
      std::max(least, static_cast<std::size_t>(std::ceil(curve.parameter.back() / options.step)));
  std::vector<CurveSample> samples = sample_evenly(curve, count);
  std::vector<Vec3> points = smooth_points(curve, samples, closed, options, shape);
  const std::vector<char> follows = retreat_inside(samples, closed, shape, points);

  std::vector<CurveSample> polyline;
  std::size_t node = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].point = points[k];
    polyline.push_back(samples[k]);
    if (k == count || !follows[k]) continue;
    while (curve.parameter[node] <= samples[k].parameter) ++node;
    for (; curve.parameter[node] < samples[k + 1].parameter; ++node) {
      polyline.push_back(
          {curve.parameter[node], curve.point[node], curve.radius[node], curve.mgf[node]});
    }
  }
  return polyline;
}

/// Adds a node; returns its number.
inline Index add_node(const CurveSample& sample, Index raw_node, SmoothSkeleton& smooth) {
  smooth.position.push_back(sample.point);
  smooth.radius.push_back(sample.radius);
  smooth.node_eccentricity.push_back(0.0);
  smooth.node_mgf.push_back(sample.mgf);
  smooth.raw_node.push_back(raw_node);
  return to_index(smooth.position.size() - 1);
}

/// Adds an edge with the measures of raw edge `e`.
inline void add_edge(const CurveSkeleton& raw, Index e, Index branch, std::array<Index, 2> ends,
                     SmoothSkeleton& smooth) {
  smooth.edge.push_back(ends);
  smooth.mgf.push_back(raw.mgf[e]);
  smooth.girth.push_back(raw.girth[e]);
  smooth.circumference.push_back(raw.circumference[e]);
  smooth.eccentricity.push_back(raw.eccentricity[e]);
  smooth.theta_birth.push_back(raw.theta_birth[e]);
  smooth.voronoi_edge.push_back(raw.voronoi_edge[e]);
  smooth.contacts.push_back(raw.contacts[e]);
  smooth.raw_edge.push_back(e);
  smooth.edge_branch.push_back(branch);
}

/// The nodes that every branch end maps to: one per tip, junction and isolated node.
inline std::vector<Index> add_kept_nodes(const CurveSkeleton& raw, const BranchGraph& graph,
                                         SmoothSkeleton& smooth) {
  std::vector<Index> kept(raw.node_count(), kNone);
  for (Index v = 0; v < raw.node_count(); ++v) {
    if (graph.node_kind[v] == NodeKind::kRegular) continue;
    kept[v] = add_node({0.0, raw.position[v], raw.radius[v], raw.node_mgf[v]}, v, smooth);
  }
  return kept;
}

/// Adds a branch's polyline between its kept ends.
inline void add_branch(const CurveSkeleton& raw, const Branch& branch, Index id,
                       const BranchCurve& curve, const std::vector<CurveSample>& polyline,
                       const std::vector<Index>& kept, SmoothSkeleton& smooth) {
  Index previous = kept[branch.first_node];
  if (previous == kNone) previous = add_node(polyline.front(), kNone, smooth);
  const Index last = kept[branch.last_node] == kNone ? previous : kept[branch.last_node];
  for (std::size_t k = 1; k < polyline.size(); ++k) {
    const Index node = k + 1 == polyline.size() ? last : add_node(polyline[k], kNone, smooth);
    const double middle = 0.5 * (polyline[k - 1].parameter + polyline[k].parameter);
    const Index e = branch.edges[locate(curve.parameter, middle).segment];
    add_edge(raw, e, id, {previous, node}, smooth);
    previous = node;
  }
}

}  // namespace smoothing

/// Resamples every branch and bends it as little as its constraints allow: ends in place (a loop
/// without junction is free all round), no point further than `max_shift` radii from its raw place,
/// no segment outside the shape unless the raw one's is.
/// `shape` is asked a few times a node. Cost: a banded linear system a branch and round.
inline SmoothSkeleton smooth_skeleton(const CurveSkeleton& skeleton, const BranchGraph& graph,
                                      const ShapeInterior& shape,
                                      const SmoothingOptions& options = {}) {
  SmoothSkeleton smooth;
  const std::vector<Index> kept = smoothing::add_kept_nodes(skeleton, graph, smooth);
  smoothing::Turning turning;
  for (Index b = 0; b < graph.branches.size(); ++b) {
    const Branch& branch = graph.branches[b];
    const BranchCurve curve = branch_curve(skeleton, branch);
    const bool closed = graph.node_kind[branch.first_node] == NodeKind::kRegular;
    const std::vector<CurveSample> polyline =
        smoothing::smooth_branch(branch, curve, closed, options, shape);
    smoothing::add_branch(skeleton, branch, b, curve, polyline, kept, smooth);

    std::vector<Vec3> points;
    points.reserve(polyline.size());
    for (const CurveSample& sample : polyline) points.push_back(sample.point);
    const smoothing::Turning own = smoothing::turning_of(points);
    turning.sum += own.sum;
    turning.count += own.count;
  }
  const InsideParts inside = find_inside_parts(shape, smooth.position, smooth.edge, 1);
  for (Index e = 0; e < smooth.edge_count(); ++e) {
    smooth.outside.push_back(inside.has_edge(e, smooth.edge[e]) ? 0 : 1);
    smooth.outside_edges += smooth.outside.back() != 0 ? 1 : 0;
  }
  average_eccentricity(smooth);
  smooth.mean_turning = turning.mean();
  return smooth;
}

}  // namespace mgf
