// SPDX-License-Identifier: GPL-3.0-or-later
// A polyline bent as little as its ties to given places allow (a discrete smoothing spline).
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// The points x that minimise  sum_k tie_k |x_k - places_k|^2 + stiffness * sum |x_{k-1} - 2 x_k +
/// x_{k+1}|^2.  Bending, unlike length, doesn't shrink a curve: a wave of length w steps keeps the
/// share 1 / (1 + stiffness (2 pi / w)^4) of its height.
/// Two places or more. An open polyline keeps its ends exactly; of a `closed` one the last place
/// repeats the first (four or more) and every point is free. `tie` has a positive entry per place.
/// Linear time.
inline std::vector<Vec3> stiff_curve(const std::vector<Vec3>& places,
                                     const std::vector<double>& tie, double stiffness,
                                     bool closed) {
  const int count = static_cast<int>(places.size());
  const int first_free = closed ? 0 : 1;
  const auto offset = static_cast<std::size_t>(first_free);
  const int free_count = closed ? count - 1 : count - 2;
  if (free_count <= 0) return places;
  const auto unknown = [&](int k) { return closed ? (k + free_count) % free_count : k - 1; };
  const auto is_free = [&](int k) { return closed || (k > 0 && k < count - 1); };

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Matrix<double, Eigen::Dynamic, 3> target(free_count, 3);
  for (int i = 0; i < free_count; ++i) {
    const std::size_t k = static_cast<std::size_t>(i) + offset;
    entries.emplace_back(i, i, tie[k]);
    target.row(i) = tie[k] * places[k].transpose();
  }
  constexpr std::array<double, 3> kSecondDifference = {1.0, -2.0, 1.0};
  for (int i = 0; i < free_count; ++i) {
    const int middle = i + first_free;
    for (int p = 0; p < 3; ++p) {
      const int row = middle + p - 1;
      if (!is_free(row)) continue;
      for (int q = 0; q < 3; ++q) {
        const int column = middle + q - 1;
        const double bending = stiffness * kSecondDifference[static_cast<std::size_t>(p)] *
                               kSecondDifference[static_cast<std::size_t>(q)];
        if (is_free(column)) {
          entries.emplace_back(unknown(row), unknown(column), bending);
        } else {
          target.row(unknown(row)) -=
              bending * places[static_cast<std::size_t>(column)].transpose();
        }
      }
    }
  }
  Eigen::SparseMatrix<double> system(free_count, free_count);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  const Eigen::Matrix<double, Eigen::Dynamic, 3> solution = solver.solve(target);

  std::vector<Vec3> points = places;
  for (int i = 0; i < free_count; ++i) {
    points[static_cast<std::size_t>(i) + offset] = solution.row(i).transpose();
  }
  if (closed) points.back() = points.front();
  return points;
}

}  // namespace mgf
