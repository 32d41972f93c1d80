// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart the samples of the surface are, as seen from the contacts and from the skeleton.
#pragma once

#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf {

/// The mean length of the edges at each point of a closed `surface`, in mesh units; 0 at a point
/// without faces. Linear time.
inline std::vector<double> contact_spacing(const TriangleSurface& surface) {
  std::vector<double> spacing(surface.points.size(), 0.0);
  std::vector<std::size_t> count(surface.points.size(), 0);
  for (const Triangle& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index next = t[(i + 1) % 3];  // a closed surface has this side a second time
      const double length = (surface.points[next] - surface.points[t[i]]).norm();
      for (const Index v : {t[i], next}) {
        spacing[v] += length;
        ++count[v];
      }
    }
  }
  for (std::size_t v = 0; v < spacing.size(); ++v) {
    if (count[v] > 0) spacing[v] /= static_cast<double>(count[v]);
  }
  return spacing;
}

/// At each node of `skeleton` the mean of `spacing`, one per contact, over the contacts of its
/// edges; 0 at a node without edges. Linear time.
inline std::vector<double> spacing_at_nodes(const CurveSkeleton& skeleton,
                                            const std::vector<double>& spacing) {
  std::vector<double> mean(skeleton.node_count(), 0.0);
  std::vector<std::size_t> count(skeleton.node_count(), 0);
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    for (const Index node : skeleton.edge[e]) {
      for (const Index contact : skeleton.contacts[e]) mean[node] += spacing[contact];
      count[node] += skeleton.contacts[e].size();
    }
  }
  for (std::size_t node = 0; node < mean.size(); ++node) {
    if (count[node] > 0) mean[node] /= static_cast<double>(count[node]);
  }
  return mean;
}

}  // namespace mgf
