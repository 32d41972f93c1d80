// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay tetrahedralisation of a point set as flat arrays.
#pragma once

#include <array>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"

namespace mgf {

/// Tetrahedra as arrays.
struct TetrahedronArrays {
  std::vector<Tetrahedron> corners;              ///< positively oriented
  std::vector<std::array<Index, 4>> neighbours;  ///< across the face opposite corner i; kNone: hull
};

/// The Delaunay tetrahedralisation of `points`. Cospherical sets are settled by CGAL's symbolic
/// perturbation, which depends on the coordinates alone, so the set of tetrahedra doesn't depend on
/// the order of the points (their numbering follows that of the points), nor on the number of
/// `threads`, which sort them.
/// Requires finite coordinates and four points not in a plane, or no points. Throws `InputError` on
/// duplicates, `Cancelled` if the user stops. About n log n; 4 us a point.
TetrahedronArrays delaunay_tetrahedra(const std::vector<Vec3>& points, unsigned threads = 1,
                                      const Progress& progress = {});

/// The same in two steps: the tetrahedra in no order that could be relied on,
TetrahedronArrays unordered_delaunay_tetrahedra(const std::vector<Vec3>& points,
                                                const Progress& progress = {});
/// and then in that of their ascending corners: what is near among the points is near among the
/// tetrahedra, and CGAL's way to them leaves no trace.
TetrahedronArrays in_order_of_corners(const TetrahedronArrays& unordered, std::size_t point_count,
                                      unsigned threads = 1);

}  // namespace mgf
