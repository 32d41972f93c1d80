// SPDX-License-Identifier: GPL-3.0-or-later
// One branch as a smooth curve: the zigzag of its Voronoi edges removed, its ends kept, and the
// shape never left.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
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

namespace smoothing {

/// Rounds of stiffening (each doubling the smoothing length) and of yielding to constraints.
inline constexpr int kStiffenings = 4;
inline constexpr int kYieldings = 10;
/// First smoothing length in local radii: waves shorter than about six times this are damped.
inline constexpr double kSmoothingLength = 0.25;
/// A branch that turns by more than this, mean angle in radians, after all stiffening still
/// zigzags.
inline constexpr double kZigzag = 5.0 / 180 * kPi;

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
    if ((smooth[k] - samples[k].point).norm() > max_shift * samples[k].unit) broken[k] = 1;
    if (k < last && !shape.stays_inside(smooth[k], smooth[k + 1])) broken[k] = broken[k + 1] = 1;
  }
  const double step = curve.parameter.back() / static_cast<double>(last);
  for (std::size_t i = 0; i < curve.point.size(); ++i) {
    const double at = step > 0.0 ? curve.parameter[i] / step : 0.0;
    const std::size_t k = std::min(last - 1, static_cast<std::size_t>(at));
    const double share = at - static_cast<double>(k);
    const Vec3 place = (1.0 - share) * smooth[k] + share * smooth[k + 1];
    if ((place - curve.point[i]).norm() > max_shift * curve.unit[i]) {
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

/// A branch's raw curve, and its smooth polyline with, per point, its place on that curve.
struct SmoothBranch {
  BranchCurve curve;
  std::vector<CurveSample> polyline;
  Turning turning;
};

/// The smooth polyline of a branch whose steps and shifts are counted in the curve's unit.
inline std::vector<CurveSample> smooth_polyline(const Branch& branch, const BranchCurve& curve,
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
      polyline.push_back({curve.parameter[node], curve.point[node], curve.radius[node],
                          curve.mgf[node], curve.unit[node]});
    }
  }
  return polyline;
}

/// Bends a branch as little as its constraints allow, and counts them in radii of its balls. Where
/// a plate is thinner than the edges of its mesh, the raw curve swings by more than that from side
/// to side of the plate: a branch that still zigzags is smoothed anew, counted in radii of its
/// tube.
inline SmoothBranch smooth_branch(const CurveSkeleton& skeleton, const Branch& branch, bool closed,
                                  const SmoothingOptions& options, const ShapeInterior& shape) {
  SmoothBranch best;
  for (const LocalRadius counted : {LocalRadius::kBall, LocalRadius::kTube}) {
    SmoothBranch attempt;
    attempt.curve = branch_curve(skeleton, branch, counted);
    attempt.polyline = smooth_polyline(branch, attempt.curve, closed, options, shape);
    std::vector<Vec3> points;
    points.reserve(attempt.polyline.size());
    for (const CurveSample& sample : attempt.polyline) points.push_back(sample.point);
    attempt.turning = turning_of(points);
    if (best.polyline.empty() || attempt.turning.mean() < best.turning.mean()) {
      best = std::move(attempt);
    }
    if (best.turning.mean() <= kZigzag) break;
  }
  return best;
}

}  // namespace smoothing
}  // namespace mgf
