// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/random.h"
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

// Puts the least corner first and the second least next by an even permutation, of the neighbours
// along with them.
void least_first(Tetrahedron& corners, std::array<Index, 4>& neighbours) {
  bool even = true;
  for (std::size_t sorted = 0; sorted < 3; ++sorted) {
    for (std::size_t i = 3; i > sorted; --i) {
      if (corners[i - 1] < corners[i]) continue;
      std::swap(corners[i - 1], corners[i]);
      std::swap(neighbours[i - 1], neighbours[i]);
      even = !even;
    }
  }
  if (even) return;
  std::swap(corners[2], corners[3]);
  std::swap(neighbours[2], neighbours[3]);
}

// The order in which points are inserted (Amenta, Choi and Rote 2003): an eighth of them first, and
// of that an eighth before, and so on, chosen at random, each part in the order of the points.
std::vector<Index> insertion_order(std::size_t count) {
  constexpr unsigned kShareBits = 3;
  constexpr unsigned kMostRounds = 8;
  Random random(1);
  std::vector<Index> round;
  round.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Index rounds = 0;
    while (rounds + 1 < kMostRounds && random.below(std::size_t{1} << kShareBits) == 0) ++rounds;
    round.push_back(kMostRounds - 1 - rounds);
  }
  return group_by_key(round, kMostRounds).items;
}

Delaunay triangulate(const std::vector<Vec3>& points, const Progress& progress) {
  constexpr std::size_t kReportEvery = 256;
  Delaunay delaunay;
  Delaunay::Vertex_handle last;
  for (const Index i : insertion_order(points.size())) {
    const std::size_t done = delaunay.number_of_vertices();
    if (done % kReportEvery == 0) {
      progress.report(static_cast<double>(done) / static_cast<double>(points.size()), "topology");
    }
    const Kernel::Point_3 point = exact_detail::to_cgal(points[i]);
    last =
        last == Delaunay::Vertex_handle() ? delaunay.insert(point) : delaunay.insert(point, last);
    last->info() = i;
  }
  return delaunay;
}

// The finite cells as they lie in memory.
TetrahedronArrays as_stored(const Delaunay& delaunay) {
  TetrahedronArrays result;
  result.corners.reserve(delaunay.number_of_cells());
  result.neighbours.reserve(delaunay.number_of_cells());
  for (const auto cell : delaunay.all_cell_handles()) {
    if (delaunay.is_infinite(cell)) {
      cell->info() = kNone;
      continue;
    }
    cell->info() = to_index(result.corners.size());
    result.corners.push_back({cell->vertex(0)->info(), cell->vertex(1)->info(),
                              cell->vertex(2)->info(), cell->vertex(3)->info()});
  }
  for (const auto cell : delaunay.all_cell_handles()) {
    if (cell->info() == kNone) continue;
    result.neighbours.push_back({cell->neighbor(0)->info(), cell->neighbor(1)->info(),
                                 cell->neighbor(2)->info(), cell->neighbor(3)->info()});
  }
  return result;
}

}  // namespace

TetrahedronArrays in_order_of_corners(const TetrahedronArrays& unordered, std::size_t point_count,
                                      unsigned threads) {
  constexpr std::size_t kChunk = 1024;
  std::vector<Index> least;
  least.reserve(unordered.corners.size());
  for (const Tetrahedron& t : unordered.corners)
    least.push_back(*std::min_element(t.begin(), t.end()));
  Rows<Index> by_least = group_by_key(least, point_count);
  parallel_for(point_count, threads, kChunk, [&](std::size_t v, unsigned) {
    std::vector<Tetrahedron> row;  // the three other corners, ascending, and the number
    for (const Index t : by_least[v]) {
      Tetrahedron entry = unordered.corners[t];
      std::sort(entry.begin(), entry.end());
      row.push_back({entry[1], entry[2], entry[3], t});
    }
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i < row.size(); ++i) by_least.items[by_least.begin[v] + i] = row[i][3];
  });
  const std::vector<Index>& order = by_least.items;
  std::vector<Index> number(order.size());
  for (Index i = 0; i < order.size(); ++i) number[order[i]] = i;
  TetrahedronArrays result;
  result.corners.resize(order.size());
  result.neighbours.resize(order.size());
  parallel_for(order.size(), threads, kChunk, [&](std::size_t i, unsigned) {
    Tetrahedron corners = unordered.corners[order[i]];
    std::array<Index, 4> neighbours = unordered.neighbours[order[i]];
    for (Index& u : neighbours) u = u == kNone ? kNone : number[u];
    least_first(corners, neighbours);
    result.corners[i] = corners;
    result.neighbours[i] = neighbours;
  });
  return result;
}

TetrahedronArrays unordered_delaunay_tetrahedra(const std::vector<Vec3>& points,
                                                const Progress& progress) {
  const Delaunay delaunay = triangulate(points, progress);
  if (const std::size_t repeated = points.size() - delaunay.number_of_vertices(); repeated != 0) {
    throw InputError(
        "duplicate_vertices",
        "Points of the surface at the place of another one: " + std::to_string(repeated) +
            ". Merge them with 'Remove Duplicate Vertices'. If the mesh has none, it is so far "
            "from the origin that no digits are left for points between its vertices: centre it "
            "with 'Transform: Translate, Center, set Origin'.");
  }
  return as_stored(delaunay);
}

TetrahedronArrays delaunay_tetrahedra(const std::vector<Vec3>& points, unsigned threads,
                                      const Progress& progress) {
  return in_order_of_corners(unordered_delaunay_tetrahedra(points, progress), points.size(),
                             threads);
}

}  // namespace mgf
