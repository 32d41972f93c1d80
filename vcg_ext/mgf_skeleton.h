// SPDX-License-Identifier: GPL-3.0-or-later
// The whole story: from a closed surface to its medial axis, medial geodesic function and curve
// skeleton (Dey & Sun 2006). Each function is a stage; each takes the results before it and changes
// none of them. What is made from a skeleton (branches, smoothing, circles, segmentation, parts) is
// in skeleton/ and surface/.
#pragma once

#include <string>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/input/diagnosis.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/input/sampling.h"
#include "vcg_ext/input/working_copy.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/medial/recover_interior.h"
#include "vcg_ext/skeleton/skeleton_hierarchy.h"

namespace mgf {

/// Seconds of wall time that a stage took.
struct StageTime {
  std::string stage;  ///< snake_case
  double seconds = 0.0;
};
using StageTimes = std::vector<StageTime>;

/// How the input is prepared and its medial axis made.
struct MedialAxisOptions {
  DiagnosisOptions diagnosis;
  PreparationOptions preparation;
  SamplingOptions sampling;
  RecoveryOptions recovery;

  /// How many threads all of that may use; 0: all.
  void use_threads(unsigned threads) {
    diagnosis.threads = threads;
    preparation.threads = threads;
    sampling.threads = threads;
    recovery.threads = threads;
  }
};

/// The medial axis with everything it stands on.
struct MedialAxis {
  Diagnosis diagnosis;     ///< of the user's mesh
  WorkingCopy working;     ///< that mesh repaired, with the way back to its numbering
  RefinedSurface surface;  ///< `working` with all added points on it: what geodesics run on
  InteriorTetrahedra interior;
  MedialComplex complex;
  Index samples_added = 0;  ///< vertices of `surface` that are none of `working`
  Warnings warnings;
  StageTimes times;
};

/// The MGF with its time.
struct MedialGeodesicFunction {
  MedialGeodesicField field;
  StageTimes times;
};

/// The skeleton at every theta, with what there is to say about it.
struct CurveSkeletonResult {
  SkeletonHierarchy hierarchy;
  Warnings warnings;
  StageTimes times;
};

/// The region of positive winding number of the surface behind `tree`, which must outlive it. If
/// the surface is `self_intersecting`, a segment may pass through sheets that lie inside the shape.
ShapeInterior shape_interior(const SurfaceTree& tree, bool self_intersecting);

/// Stage 1 (paper, section 5.1): the medial complex of a closed surface.
/// Throws `InputError` for a mesh that can't be served, with the diagnosis as its message.
MedialAxis compute_medial_axis(const TriangleSurface& input, const MedialAxisOptions& options = {},
                               const Progress& progress = {});

/// Stage 2 (paper, section 5.2): the MGF and its gradient on the facets of the medial axis.
MedialGeodesicFunction compute_medial_geodesic_function(const MedialAxis& axis,
                                                        const GeodesicOptions& options = {},
                                                        const Progress& progress = {});

/// Stage 3 (paper, sections 5.3 to 5.5): marking and erosion, the skeleton at every theta.
CurveSkeletonResult compute_skeleton_hierarchy(const MedialAxis& axis,
                                               const MedialGeodesicField& field,
                                               const SkeletonOptions& options = {},
                                               const Progress& progress = {});

}  // namespace mgf
