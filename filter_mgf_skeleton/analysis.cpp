// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/analysis.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "vcg_ext/exact/surface_tree.h"
#include "vcg_ext/skeleton/level_of_detail.h"
#include "vcg_ext/surface/branch_areas.h"
#include "vcg_ext/surface/contact_paths.h"

namespace mgf::plugin {
namespace {

/// Gives every vertex without a value the largest of its neighbours', ring by ring.
void fill_untouched(const std::vector<Triangle>& triangles, std::vector<double>& girth) {
  for (bool grew = true; grew;) {
    grew = false;
    const std::vector<double> former = girth;
    for (const Triangle& t : triangles) {
      const double largest = std::max({former[t[0]], former[t[1]], former[t[2]]});
      for (const Index v : t) {
        if (former[v] > 0.0 || girth[v] >= largest) continue;
        girth[v] = largest;
        grew = true;
      }
    }
  }
}

}  // namespace

SkeletonLevel skeleton_level(const SkeletonHierarchy& hierarchy, double theta, double prune) {
  SkeletonLevel level;
  level.skeleton = skeleton_at(hierarchy, theta, prune);
  level.graph = build_branches(level.skeleton);
  return level;
}

Warnings warnings_of(const SkeletonLevel& level) {
  const Index outside = count_outside_edges(level.skeleton);
  if (outside == 0) return {};
  return {{"outside_edges", std::to_string(outside) + " skeleton edges leave the shape."}};
}

SmoothSkeleton smooth_level(const Study& study, const SkeletonLevel& level) {
  const MedialAxis& axis = *study.axis;
  const SurfaceTree tree(axis.working.surface);
  return smooth_skeleton(level.skeleton, level.graph,
                         shape_interior(tree, axis.working.self_intersecting()));
}

SurfaceAnalysis analyse_surface(const Study& study, const SkeletonLevel& level,
                                double eccentricity_threshold) {
  const MedialAxis& axis = *study.axis;
  const TriangleSurface& surface = axis.working.surface;
  SurfaceAnalysis result;
  result.circles = trace_geodesic_circles(
      level.skeleton, ContactPaths(axis.surface.surface, study.function->field));
  result.segmentation = segment_surface(surface, axis.surface, level.skeleton, level.graph,
                                        result.circles, eccentricity_threshold);
  result.map = map_surface(surface, axis.surface, level.skeleton, level.graph, result.circles);
  result.graph = with_surface_measures(level.graph, surface, result.map, result.segmentation,
                                       eccentricity_threshold);
  return result;
}

SurfaceGirth surface_girth(const MedialAxis& axis, const MedialGeodesicField& field) {
  const TriangleSurface& refined = axis.surface.surface;
  std::vector<double> girth(refined.points.size(), 0.0);
  for (std::size_t f = 0; f < axis.complex.facet_count(); ++f) {
    if (!std::isfinite(field.mgf[f])) continue;
    const VertexPair& contacts = axis.complex.facet_contacts[f];
    girth[contacts.a] = std::max(girth[contacts.a], field.mgf[f]);
    girth[contacts.b] = std::max(girth[contacts.b], field.mgf[f]);
  }
  fill_untouched(refined.triangles, girth);

  SurfaceGirth result;
  result.of_face.assign(axis.working.surface.triangles.size(), 0.0);
  for (std::size_t t = 0; t < refined.triangles.size(); ++t) {
    double& of_face = result.of_face[axis.surface.parent_face[t]];
    for (const Index v : refined.triangles[t]) of_face = std::max(of_face, girth[v]);
  }
  girth.resize(axis.working.surface.points.size());
  result.of_vertex = std::move(girth);
  return result;
}

std::vector<Index> faces_speaking_for(const TriangleSurface& input, const WorkingCopy& working) {
  std::vector<Index> face_at_vertex(working.surface.points.size(), kNone);
  for (Index f = 0; f < working.surface.triangles.size(); ++f) {
    for (const Index v : working.surface.triangles[f]) {
      if (face_at_vertex[v] == kNone) face_at_vertex[v] = f;
    }
  }
  std::vector<Index> speaking = working.face_of_input;
  for (Index f = 0; f < speaking.size(); ++f) {
    for (const Index corner : input.triangles[f]) {
      if (speaking[f] != kNone) break;
      const Index v = working.vertex_of_input[corner];
      if (v != kNone) speaking[f] = face_at_vertex[v];
    }
  }
  return speaking;
}

}  // namespace mgf::plugin
