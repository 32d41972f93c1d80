// SPDX-License-Identifier: GPL-3.0-or-later
// The whole story: from a closed surface to its medial axis, medial geodesic function, curve
// skeleton and tubular/flat segmentation (Dey & Sun 2006). Each function is a stage; each takes the
// results before it and changes none of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/surface/geodesic_circles.h"
#include "vcg_ext/surface/segmentation.h"
#include "vcg_ext/surface/surface_map.h"

namespace mgf {

/// Seconds of wall time that a stage took.
struct StageTime {
  std::string stage;  ///< snake_case
  double seconds = 0.0;
};

/// How the input is prepared and its medial axis made.
struct MedialAxisOptions {
  /// Longest edge of the sampled surface, mesh units; 0: leave the sampling; none: choose it by
  /// local thickness where the surface is too coarse for a medial axis.
  std::optional<double> sampling_length;
  bool ignore_cavities = false;  ///< drop shells that lie inside another instead of refusing
  bool lift_overlaps = true;     ///< let limbs pass through each other without a junction
  unsigned threads = 0;          ///< 0: all
};

/// The medial axis with everything it stands on.
struct MedialAxis {
  TriangleSurface input;          ///< the working copy: repaired, the user's numbering kept
  RefinedSurface surface;         ///< T with all added points: what geodesics run on
  InteriorTetrahedra interior;
  MedialComplex complex;
  std::vector<Index> vertex_component;  ///< solid of each vertex of `surface`
  Index components = 0;           ///< solids in the mesh
  Index genus = 0;                ///< sum over the solids
  Index samples_added = 0;        ///< points that are no vertex of the input
  Warnings warnings;
  std::vector<StageTime> times;
};

/// Which edges make the skeleton, and how it is shown.
struct SkeletonOptions {
  double theta = -0.7;  ///< divergence threshold of the marking, in [-1.1, 0]; smaller: less detail
  double prune = 0.75;  ///< significance below which a leaf branch is dropped; 0: the paper's output
  bool one_mark_per_facet = false;  ///< the paper's rule against small branches
  bool open_pockets = false;        ///< open a closed pocket of the medial axis at its lowest MGF
};

/// The skeleton at every theta, from one erosion.
struct SkeletonHierarchy {
  CurveSkeleton full;          ///< at the loosest theta; edges carry `theta_birth`
  Index residual_facets = 0;   ///< facets that no collapse could reach: a closed pocket
  Index pockets_opened = 0;    ///< loops or voids given up by `open_pockets`
  Index outside_edges = 0;     ///< graph edges that meet the surface
  BettiNumbers betti_before;   ///< of the medial complex
  BettiNumbers betti_after;    ///< of the eroded complex
  Index last_node = kNone;     ///< node of `full` that remains of a tree when every mark is gone
  Warnings warnings;
  std::vector<StageTime> times;
};

}  // namespace mgf
