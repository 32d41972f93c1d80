// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstddef>
#include <string>
#include <utility>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/exact/cgal_kernel.h"

namespace mgf {

namespace {

using exact_detail::Kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<Index, Kernel,
                                              CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using DataStructure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, DataStructure>;

Tetrahedron corner_numbers(Delaunay::Cell_handle cell) {
  return {cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
          cell->vertex(3)->info()};
}

// The even permutation of four numbers that puts the least first and the second least next.
std::array<int, 4> least_first(const Tetrahedron& corners) {
  std::array<int, 4> order{0, 1, 2, 3};
  bool even = true;
  for (std::size_t sorted = 0; sorted < 3; ++sorted) {
    for (std::size_t i = 3; i > sorted; --i) {
      if (corners[static_cast<std::size_t>(order[i - 1])] <
          corners[static_cast<std::size_t>(order[i])]) {
        continue;
      }
      std::swap(order[i - 1], order[i]);
      even = !even;
    }
  }
  if (!even) std::swap(order[2], order[3]);
  return order;
}

// The finite cells in the order of their ascending corners, numbered so: what is near among the
// points is near among the tetrahedra, and CGAL's way to them leaves no trace.
std::vector<Delaunay::Cell_handle> in_order_of_corners(const Delaunay& delaunay,
                                                       std::size_t point_count) {
  struct Numbered {
    Tetrahedron corners;  // ascending
    Delaunay::Cell_handle cell;
  };
  std::vector<Numbered> found;
  std::vector<Index> least;
  for (const auto cell : delaunay.finite_cell_handles()) {
    Tetrahedron corners = corner_numbers(cell);
    std::sort(corners.begin(), corners.end());
    found.push_back({corners, cell});
    least.push_back(corners[0]);
  }
  const Rows<Index> by_least = group_by_key(least, point_count);
  std::vector<Delaunay::Cell_handle> result;
  result.reserve(found.size());
  std::vector<Index> row;
  for (std::size_t v = 0; v < point_count; ++v) {
    row.assign(by_least[v].begin(), by_least[v].end());
    std::sort(row.begin(), row.end(),
              [&](Index s, Index t) { return found[s].corners < found[t].corners; });
    for (const Index t : row) {
      found[t].cell->info() = to_index(result.size());
      result.push_back(found[t].cell);
    }
  }
  return result;
}

}  // namespace

TetrahedronArrays delaunay_tetrahedra(const std::vector<Vec3>& points) {
  std::vector<std::pair<Kernel::Point_3, Index>> numbered;
  numbered.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    numbered.emplace_back(exact_detail::to_cgal(points[i]), i);
  }
  const Delaunay delaunay(numbered.begin(), numbered.end());
  if (const std::size_t repeated = points.size() - delaunay.number_of_vertices(); repeated != 0) {
    throw InputError(
        "duplicate_vertices",
        "Points of the surface at the place of another one: " + std::to_string(repeated) +
            ". Merge them with 'Remove Duplicate Vertices'. If the mesh has none, it is so far "
            "from the origin that no digits are left for points between its vertices: centre it "
            "with 'Transform: Translate, Center, set Origin'.");
  }
  const std::vector<Delaunay::Cell_handle> cells = in_order_of_corners(delaunay, points.size());
  TetrahedronArrays result;
  result.corners.reserve(cells.size());
  result.neighbours.reserve(cells.size());
  for (const auto cell : cells) {
    Tetrahedron corners{};
    std::array<Index, 4> neighbours{};
    const std::array<int, 4> order = least_first(corner_numbers(cell));
    for (std::size_t i = 0; i < 4; ++i) {
      const auto neighbour = cell->neighbor(order[i]);
      corners[i] = cell->vertex(order[i])->info();
      neighbours[i] = delaunay.is_infinite(neighbour) ? kNone : neighbour->info();
    }
    result.corners.push_back(corners);
    result.neighbours.push_back(neighbours);
  }
  return result;
}

}  // namespace mgf
