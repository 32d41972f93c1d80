// SPDX-License-Identifier: GPL-3.0-or-later
// The surface as recovery wants it: in an order of its own, within a box, beside the Delaunay
// tetrahedralisation of its vertices.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/spatial_order.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/delaunay.h"
#include "vcg_ext/exact/delaunay_ahead.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/principal_frame.h"
#include "vcg_ext/medial/surface_flips.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"
#include "vcg_ext/medial/topology_certificate.h"

namespace mgf {

/// A surface whose used vertices are renumbered in spatial order along its own axes and whose faces
/// are sorted, so that what is made from it depends neither on how the caller numbered them nor,
/// but for symmetric shapes, on how the surface is turned.
struct OrderedSurface {
  TriangleSurface surface;
  std::vector<Index> original;  ///< the caller's number of each vertex
  Frame frame;                  ///< the axes
};

inline OrderedSurface in_spatial_order(const TriangleSurface& surface) {
  std::vector<char> used(surface.points.size(), 0);
  for (const Triangle& face : surface.triangles) {
    for (const Index v : face) used[v] = 1;
  }
  std::vector<Index> vertices;
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v] != 0) vertices.push_back(v);
  }
  OrderedSurface result;
  // First along the coordinate axes: the frame is to be the same to the bit for any numbering.
  vertices = spatial_order(surface.points, std::move(vertices));
  std::vector<Vec3> local;
  local.reserve(vertices.size());
  for (const Index v : vertices) local.push_back(surface.points[v]);
  result.frame = principal_frame(local);
  std::vector<Index> places;
  places.reserve(local.size());
  for (Vec3& p : local) {
    p = result.frame.to_local(p);
    places.push_back(to_index(places.size()));
  }
  for (const Index place : spatial_order(local, std::move(places))) {
    result.original.push_back(vertices[place]);
  }
  std::vector<Index> number(surface.points.size(), kNone);
  for (Index i = 0; i < result.original.size(); ++i) {
    number[result.original[i]] = i;
    result.surface.points.push_back(surface.points[result.original[i]]);
  }
  for (const Triangle& face : surface.triangles) {
    result.surface.triangles.push_back({number[face[0]], number[face[1]], number[face[2]]});
  }
  result.surface.triangles = canonical_sorted(result.surface.triangles);
  return result;
}

inline constexpr std::size_t kBoxCorners = 8;
inline constexpr std::size_t kBoxFaces = 12;

/// The vertices of an ordered surface and the eight corners of a box along its axes, far outside,
/// which keep the surface off the hull. The box is slightly irregular, which spares the
/// triangulation cospherical cases.
inline std::vector<Vec3> with_box(const OrderedSurface& ordered) {
  constexpr double kFar = 6.0;
  constexpr double kIrregular[kBoxCorners] = {0.0, 0.031, 0.073, 0.011, 0.057, 0.097, 0.043, 0.083};
  std::vector<Vec3> result = ordered.surface.points;
  Vec3 low = ordered.frame.to_local(result.front());
  Vec3 high = low;
  for (const Vec3& p : result) {
    low = low.cwiseMin(ordered.frame.to_local(p));
    high = high.cwiseMax(ordered.frame.to_local(p));
  }
  const double reach = kFar * (high - low).norm();
  for (unsigned i = 0; i < kBoxCorners; ++i) {
    const Vec3 corner((i & 1U) != 0 ? 1.0 : -1.0, (i & 2U) != 0 ? 1.0 : -1.0,
                      (i & 4U) != 0 ? 1.0 : -1.0);
    result.push_back(
        ordered.frame.to_world(0.5 * (low + high) + reach * (1.0 + kIrregular[i]) * corner));
  }
  return result;
}

/// The points that recovery of `surface` tetrahedralises first.
inline std::vector<Vec3> boxed_vertices(const TriangleSurface& surface) {
  return with_box(in_spatial_order(surface));
}

/// The Delaunay tetrahedralisation of the vertices of an ordered surface, of the box, and of points
/// added before recovery, in this order; and the faces to be recovered.
struct BoxedSurface {
  std::vector<Vec3> points;
  TetrahedronArrays delaunay;
  std::vector<Triangle> faces;
  FlatFlipped flat;  ///< `faces` with flat edges flipped
};

namespace boxed_detail {

// Fills in what follows from points and faces.
inline void prepare_recovery(BoxedSurface& boxed, unsigned threads, const Progress& progress,
                             DelaunayAhead* ahead) {
  parallel_beside(
      threads,
      [&] {
        boxed.delaunay = ahead != nullptr ? ahead->finish(boxed.points, threads, progress)
                                          : delaunay_tetrahedra(boxed.points, threads, progress);
      },
      [&] { boxed.flat = flip_flat_edges(boxed.points, boxed.faces); });
}

}  // namespace boxed_detail

/// `ordered` in its box. `ahead`: a tetrahedralisation of these points begun before, or nullptr.
inline BoxedSurface boxed(const OrderedSurface& ordered, unsigned threads = 1,
                          const Progress& progress = {}, DelaunayAhead* ahead = nullptr) {
  BoxedSurface result;
  result.points = with_box(ordered);
  result.faces = ordered.surface.triangles;
  boxed_detail::prepare_recovery(result, threads, progress, ahead);
  return result;
}

/// A refinement of `ordered`, whose vertices come first in it, in the same box.
inline BoxedSurface boxed(const OrderedSurface& ordered, const TriangleSurface& refined,
                          unsigned threads, const Progress& progress) {
  BoxedSurface result;
  const std::size_t own = ordered.surface.points.size();
  result.points = with_box(ordered);
  result.points.insert(result.points.end(),
                       refined.points.begin() + static_cast<std::ptrdiff_t>(own),
                       refined.points.end());
  result.faces = refined.triangles;
  for (Triangle& face : result.faces) {
    for (Index& v : face) {
      if (v >= own) v += static_cast<Index>(kBoxCorners);
    }
  }
  boxed_detail::prepare_recovery(result, threads, progress, nullptr);
  return result;
}

/// Gives `interior` and `boundary` the caller's numbers: its points, then the added ones. The box
/// is dropped.
inline void restore_numbers(InteriorTetrahedra& interior, std::vector<Triangle>& boundary,
                            const OrderedSurface& ordered, const std::vector<Vec3>& caller_points) {
  const std::size_t own = ordered.original.size();
  std::vector<Index> number(interior.points.size(), kNone);
  std::vector<Vec3> points = caller_points;
  for (Index v = 0; v < number.size(); ++v) {
    if (v < own) {
      number[v] = ordered.original[v];
    } else if (v >= own + kBoxCorners) {
      number[v] = to_index(points.size());
      points.push_back(interior.points[v]);
    }
  }
  for (Tetrahedron& t : interior.tetrahedra) {
    for (Index& v : t) v = number[v];
  }
  for (Triangle& face : boundary) {
    for (Index& v : face) v = number[v];
  }
  interior.points = std::move(points);
  interior.input_points = to_index(caller_points.size());
}

}  // namespace mgf
