// SPDX-License-Identifier: GPL-3.0-or-later
// Tubular and flat regions of the surface (paper, section 5.6).
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// Per face of the input surface.
struct Segmentation {
  std::vector<char> tubular;         ///< 1 tubular, 0 flat; every face has a label
  std::vector<double> eccentricity;  ///< that of the nearest geodesic circles, continuous
  std::vector<double> confidence;    ///< in [0, 1]: share of agreeing evidence near the face
  double tubular_area_share = 0.0;   ///< in [0, 1]
  Index unlabelled_faces = 0;        ///< 0 unless the skeleton has no edge
};

}  // namespace mgf
