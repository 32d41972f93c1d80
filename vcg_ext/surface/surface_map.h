// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of the curve skeleton each face and vertex of the surface belongs to.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Correspondence of surface elements to the skeleton.
struct SkeletonCorrespondence {
  std::vector<Index> branch;      ///< id in the BranchGraph
  std::vector<Index> edge;        ///< skeleton edge that the element belongs to
  std::vector<double> arc_length; ///< position along the branch from its first node, mesh units
  std::vector<double> distance;   ///< straight distance to that skeleton edge
  std::vector<double> girth;      ///< geodesic girth of that edge
};

/// The surface cut by branch.
struct SurfaceMap {
  SkeletonCorrespondence faces;     ///< one entry per face of the input surface
  SkeletonCorrespondence vertices;  ///< one entry per vertex of the input surface
};

}  // namespace mgf
