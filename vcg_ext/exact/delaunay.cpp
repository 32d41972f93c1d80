// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <utility>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/exact/cgal_kernel.h"

namespace mgf {

TetrahedronArrays delaunay_tetrahedra(const std::vector<Vec3>& points) {
  using exact_detail::Kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
  using CellBase =
      CGAL::Triangulation_cell_base_with_info_3<Index, Kernel,
                                                CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  using DataStructure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, DataStructure>;

  std::vector<std::pair<Kernel::Point_3, Index>> numbered;
  numbered.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    numbered.emplace_back(exact_detail::to_cgal(points[i]), i);
  }
  const Delaunay delaunay(numbered.begin(), numbered.end());
  if (delaunay.number_of_vertices() != points.size()) {
    throw InputError("duplicate_vertices",
                     "Two vertices of the mesh lie at the same place. Merge "
                     "duplicate vertices first.");
  }
  // Numbered by their least corner: what is near among the points is near among the tetrahedra.
  std::vector<Delaunay::Cell_handle> cells(delaunay.finite_cell_handles().begin(),
                                           delaunay.finite_cell_handles().end());
  std::vector<Index> least_corner;
  least_corner.reserve(cells.size());
  for (const auto cell : cells) {
    least_corner.push_back(std::min({cell->vertex(0)->info(), cell->vertex(1)->info(),
                                     cell->vertex(2)->info(), cell->vertex(3)->info()}));
  }
  const std::vector<Index> order = group_by_key(least_corner, points.size()).items;
  for (Index t = 0; t < order.size(); ++t) cells[order[t]]->info() = t;
  TetrahedronArrays result;
  result.corners.reserve(cells.size());
  result.neighbours.reserve(cells.size());
  for (const Index c : order) {
    const auto cell = cells[c];
    Tetrahedron corners{};
    std::array<Index, 4> neighbours{};
    for (int i = 0; i < 4; ++i) {
      const auto neighbour = cell->neighbor(i);
      corners[static_cast<std::size_t>(i)] = cell->vertex(i)->info();
      neighbours[static_cast<std::size_t>(i)] =
          delaunay.is_infinite(neighbour) ? kNone : neighbour->info();
    }
    result.corners.push_back(corners);
    result.neighbours.push_back(neighbours);
  }
  return result;
}

}  // namespace mgf
