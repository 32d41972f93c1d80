// SPDX-License-Identifier: GPL-3.0-or-later
// Eccentricity without the noise of single edges: a running median along each branch.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/weighted_median.h"

namespace mgf {
namespace eccentricity_filter {

/// Reach of the median to either side, in units of the local radius rho = MGF / pi.
inline constexpr double kReach = 1.0;

/// Calls `visit(i)` for the edges of a branch, counted along it, whose midpoints lie within `reach`
/// of that of edge `centre` on its two sides; round the loop if `closed`, each edge once.
template <class Visit>
void for_each_near(const std::vector<double>& length, std::size_t centre, double reach, bool closed,
                   const Visit& visit) {
  const std::size_t n = length.size();
  visit(centre);
  std::size_t unseen = n - 1;
  for (const bool forward : {true, false}) {
    double distance = 0.0;
    for (std::size_t i = centre; unseen > 0; --unseen) {
      if (!closed && i == (forward ? n - 1 : 0)) break;
      const std::size_t next = (i + (forward ? 1 : n - 1)) % n;
      distance += 0.5 * (length[i] + length[next]);
      if (distance > reach) break;
      visit(next);
      i = next;
    }
  }
}

}  // namespace eccentricity_filter

/// One eccentricity per skeleton edge: the median, weighted by length, of those on the same branch
/// within rho = MGF / pi to either side. Cost: O(n w log w) for w edges a window.
inline std::vector<double> filtered_eccentricity(const CurveSkeleton& skeleton,
                                                 const BranchGraph& graph) {
  std::vector<double> filtered(skeleton.edge_count());
  for (const Branch& branch : graph.branches) {
    std::vector<double> length;
    for (const Index e : branch.edges) length.push_back(skeleton_edge_length(skeleton, e));
    const bool closed = branch.first_node == branch.last_node &&
                        graph.node_kind[branch.first_node] == NodeKind::kRegular;
    for (std::size_t i = 0; i < branch.edges.size(); ++i) {
      const double rho = skeleton.mgf[branch.edges[i]] / kPi;
      std::vector<double> values;
      std::vector<double> weights;
      eccentricity_filter::for_each_near(length, i, eccentricity_filter::kReach * rho, closed,
                                         [&](std::size_t j) {
                                           values.push_back(skeleton.eccentricity[branch.edges[j]]);
                                           weights.push_back(length[j]);
                                         });
      filtered[branch.edges[i]] = weighted_median(values, weights);
    }
  }
  return filtered;
}

}  // namespace mgf
