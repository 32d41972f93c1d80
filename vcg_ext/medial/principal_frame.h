// SPDX-License-Identifier: GPL-3.0-or-later
// Axes that turn with a point set, so that what is decided along them doesn't depend on how the set
// lies in space.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A right-handed orthonormal frame.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< its axes as columns

  Vec3 to_local(const Vec3& p) const { return axes.transpose() * (p - origin); }
  Vec3 to_world(const Vec3& p) const { return origin + axes * p; }
};

/// The centroid and the principal axes of `points`, from the least spread to the largest, the
/// second and third pointing to where the outliers are. Turning the points turns it along, but for
/// rounding, unless spreads are equal or a spread is symmetric. Linear time.
inline Frame principal_frame(const std::vector<Vec3>& points) {
  Frame frame;
  if (points.empty()) return frame;
  for (const Vec3& p : points) frame.origin += p / static_cast<double>(points.size());
  const double diagonal = bounding_box_diagonal(points);
  const double scale = diagonal > 0.0 ? 1.0 / diagonal : 0.0;  // squares of tiny numbers are 0
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) {
    const Vec3 offset = scale * (p - frame.origin);
    covariance += offset * offset.transpose();
  }
  frame.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  Vec3 skew = Vec3::Zero();
  for (const Vec3& p : points) skew += (scale * frame.to_local(p)).array().cube().matrix();
  for (int axis = 1; axis < 3; ++axis) {
    if (skew[axis] < 0.0) frame.axes.col(axis) *= -1.0;
  }
  frame.axes.col(0) = frame.axes.col(1).cross(frame.axes.col(2));
  return frame;
}

}  // namespace mgf
