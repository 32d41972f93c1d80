// SPDX-License-Identifier: GPL-3.0-or-later
// All stages in one call, for tests of what comes out at the end.
#pragma once

#include <gtest/gtest.h>

#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/input/refined_surface.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/medial/placement.h"
#include "vcg_ext/medial/recover_interior.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/skeleton_hierarchy.h"
#include "vcg_ext/skeleton/smoothing.h"
#include "vcg_ext/surface/branch_areas.h"
#include "vcg_ext/surface/contact_paths.h"

namespace mgf::test {

/// What all stages make of a surface at the default theta and pruning.
struct Anatomy {
  CurveSkeleton skeleton;
  SmoothSkeleton smooth;
  GeodesicCircles circles;
  Segmentation segmentation;
  SurfaceMap map;
  BranchGraph graph;
};

/// Runs all stages at the default theta and pruning, by `threshold` on eccentricity.
inline Anatomy dissect(const TriangleSurface& surface, double threshold) {
  const SkeletonOptions defaults;
  const InteriorTetrahedra interior = recover_interior(surface, {});
  EXPECT_EQ(interior.points.size(), surface.points.size()) << "T itself has to be recovered";
  MedialComplex complex = build_medial_complex(interior);
  place_voronoi_vertices(interior, complex);
  const MedialGeodesicField field =
      evaluate_medial_geodesic_function(surface, complex, {Certification::kPractical, 1}, {});
  const SurfaceTree tree(surface);
  const ShapeInterior inside{
      [&tree](const Vec3& p) { return tree.inside(p); },
      [&tree](const Vec3& a, const Vec3& b) { return a == b || !tree.segment_meets(a, b); }};
  const SkeletonHierarchy hierarchy = build_skeleton_hierarchy(
      interior, complex, field, surface, bounding_box_diagonal(surface.points), {},
      [&inside] { return inside; });
  Anatomy result;
  result.skeleton = skeleton_at(hierarchy, defaults.theta, defaults.prune);
  const BranchGraph graph = build_branches(result.skeleton);
  const RefinedSurface refined = unrefined(surface);
  result.smooth = smooth_skeleton(result.skeleton, graph, inside);
  result.circles = trace_geodesic_circles(result.skeleton, ContactPaths(surface, field));
  result.segmentation =
      segment_surface(surface, refined, result.skeleton, graph, result.circles, threshold);
  result.map = map_surface(surface, refined, result.skeleton, graph, result.circles);
  result.graph = with_surface_measures(graph, surface, result.map, result.segmentation, threshold);
  return result;
}

}  // namespace mgf::test
