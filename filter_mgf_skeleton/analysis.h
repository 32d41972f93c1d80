// SPDX-License-Identifier: GPL-3.0-or-later
// What the filters make of a study: the skeleton at a level of detail, its smooth form, and what it
// says about the surface.
#pragma once

#include <vector>

#include "filter_mgf_skeleton/workbench.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/smoothing.h"
#include "vcg_ext/surface/geodesic_circles.h"
#include "vcg_ext/surface/segmentation.h"
#include "vcg_ext/surface/surface_map.h"

namespace mgf::plugin {

/// A skeleton with its branches.
struct SkeletonLevel {
  CurveSkeleton skeleton;
  BranchGraph graph;
};

/// The skeleton at `theta` without branches less significant than `prune`.
SkeletonLevel skeleton_level(const SkeletonHierarchy& hierarchy, double theta, double prune);

/// What the user should know of this level beyond the hierarchy's own warnings.
Warnings warnings_of(const SkeletonLevel& level);

/// The smooth skeleton inside the shape.
SmoothSkeleton smooth_level(const Study& study, const SkeletonLevel& level);

/// What the geodesic circles of a skeleton say about the surface. Per face and per vertex of the
/// working copy.
struct SurfaceAnalysis {
  GeodesicCircles circles;
  Segmentation segmentation;
  SurfaceMap map;
  BranchGraph graph;  ///< the level's, with the measures that need the surface
};

SurfaceAnalysis analyse_surface(const Study& study, const SkeletonLevel& level,
                                double eccentricity_threshold);

/// The largest finite MGF of the Voronoi facets that touch each vertex and face of the working
/// copy: its local girth. A vertex that none touches takes the largest of its neighbours'.
struct SurfaceGirth {
  std::vector<double> of_vertex;
  std::vector<double> of_face;
};

SurfaceGirth surface_girth(const MedialAxis& axis, const MedialGeodesicField& field);

/// For each face of the user's mesh the face of the working copy that speaks for it: itself, or,
/// for one that was taken out, one that shares a vertex with it; kNone where there is none (the
/// faces of an ignored cavity).
std::vector<Index> faces_speaking_for(const TriangleSurface& input, const WorkingCopy& working);

}  // namespace mgf::plugin
