// SPDX-License-Identifier: GPL-3.0-or-later
// A branch as a curve with a parameter that counts local radii, and points taken evenly along it.
//
// A tube has one radius; a blade has two: that of its ball, half its thickness, and that of the
// tube with its MGF, which is about its width.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf {

/// Which radius lengths along a branch and across it are counted in.
enum class LocalRadius {
  kBall,  ///< the distance to the nearest contact point
  kTube,  ///< MGF / pi, or that of the ball if it is larger
};

/// A branch's nodes with their parameter: arc length measured in local radii.
struct BranchCurve {
  std::vector<Vec3> point;        ///< one per node of the branch
  std::vector<double> radius;     ///< likewise, of the ball
  std::vector<double> mgf;        ///< likewise; 0 where it is infinite
  std::vector<double> unit;       ///< likewise: the radius that lengths are counted in
  std::vector<double> parameter;  ///< likewise; not falling, 0 at the first node
};

/// A point on a `BranchCurve`.
struct CurveSample {
  double parameter = 0.0;
  Vec3 point = Vec3::Zero();
  double radius = 0.0;
  double mgf = 0.0;
  double unit = 0.0;
};

/// Radii below this share of the branch's largest count as it, so that a pinch gets no crowd of
/// samples.
inline constexpr double kLeastRadiusShare = 0.1;

inline BranchCurve branch_curve(const CurveSkeleton& skeleton, const Branch& branch,
                                LocalRadius counted) {
  BranchCurve curve;
  for (const Index v : branch.nodes) {
    const double ball = skeleton.radius[v];
    const bool has_path = std::isfinite(skeleton.node_mgf[v]);  // not between crossing pieces
    const double mgf = has_path ? skeleton.node_mgf[v] : 0.0;
    const double tube = mgf / kPi;
    curve.point.push_back(skeleton.position[v]);
    curve.radius.push_back(ball);
    curve.mgf.push_back(mgf);
    curve.unit.push_back(counted == LocalRadius::kTube ? std::max(ball, tube) : ball);
  }
  const double largest = *std::max_element(curve.unit.begin(), curve.unit.end());
  const double least =
      largest > 0.0 ? kLeastRadiusShare * largest : std::max(branch.length, 1e-300);
  for (double& unit : curve.unit) unit = std::max(unit, least);
  curve.parameter.push_back(0.0);
  for (std::size_t i = 1; i < curve.point.size(); ++i) {
    const double unit = 0.5 * (curve.unit[i - 1] + curve.unit[i]);
    const double length = (curve.point[i] - curve.point[i - 1]).norm();
    curve.parameter.push_back(curve.parameter.back() + length / unit);
  }
  return curve;
}

/// The segment of `parameters` (not falling, two or more) that holds `at`, and the share of it
/// before `at`.
struct CurvePosition {
  std::size_t segment = 0;
  double share = 0.0;
};

inline CurvePosition locate(const std::vector<double>& parameters, double at) {
  const auto above = std::upper_bound(parameters.begin() + 1, parameters.end() - 1, at);
  CurvePosition position;
  position.segment = static_cast<std::size_t>(above - parameters.begin()) - 1;
  const double from = parameters[position.segment];
  const double to = parameters[position.segment + 1];
  position.share = to > from ? std::clamp((at - from) / (to - from), 0.0, 1.0) : 0.0;
  return position;
}

/// `count` + 1 samples at equal steps of the parameter, both ends exactly among them.
inline std::vector<CurveSample> sample_evenly(const BranchCurve& curve, std::size_t count) {
  std::vector<CurveSample> samples(count + 1);
  for (std::size_t k = 0; k <= count; ++k) {
    CurveSample& sample = samples[k];
    sample.parameter = curve.parameter.back() * static_cast<double>(k) / static_cast<double>(count);
    const CurvePosition at = locate(curve.parameter, sample.parameter);
    const auto blend = [&](const auto& values) {
      return (1.0 - at.share) * values[at.segment] + at.share * values[at.segment + 1];
    };
    sample.point = blend(curve.point);
    sample.radius = blend(curve.radius);
    sample.mgf = blend(curve.mgf);
    sample.unit = blend(curve.unit);
  }
  samples.front().point = curve.point.front();
  samples.back().point = curve.point.back();
  return samples;
}

}  // namespace mgf
