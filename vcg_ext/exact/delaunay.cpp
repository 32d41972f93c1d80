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
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/random.h"
#include "vcg_ext/exact/cgal_kernel.h"
#include "vcg_ext/exact/incremental_delaunay.h"

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

// The Delaunay tetrahedralisation of the points numbered `hull`.
TetrahedronArrays tetrahedra_of_hull(const std::vector<Vec3>& points,
                                     const std::vector<Index>& hull) {
  Delaunay delaunay;
  for (const Index i : hull) delaunay.insert(exact_detail::to_cgal(points[i]))->info() = i;
  TetrahedronArrays result;
  for (const auto cell : delaunay.all_cell_handles()) {
    cell->info() = kNone;
    if (delaunay.is_infinite(cell)) continue;
    cell->info() = to_index(result.corners.size());
    result.corners.push_back({cell->vertex(0)->info(), cell->vertex(1)->info(),
                              cell->vertex(2)->info(), cell->vertex(3)->info()});
  }
  for (const auto cell : delaunay.finite_cell_handles()) {
    result.neighbours.push_back({cell->neighbor(0)->info(), cell->neighbor(1)->info(),
                                 cell->neighbor(2)->info(), cell->neighbor(3)->info()});
  }
  return result;
}

struct SortedTetrahedron {
  std::uint64_t middle;  // the second and third least corner
  Index greatest;
  Index slot;
};

// The slots of a tetrahedralisation ordered by the ascending corners of their tetrahedra.
std::vector<Index> slots_in_order(const std::vector<Tetrahedron>& corners,
                                  std::size_t point_count) {
  std::vector<Index> begin(point_count + 1, 0);  // of the tetrahedra with each least corner
  for (const Tetrahedron& t : corners) {
    if (t[0] != kNone) ++begin[std::size_t{*std::min_element(t.begin(), t.end())} + 1];
  }
  for (std::size_t v = 0; v < point_count; ++v) begin[v + 1] += begin[v];
  std::vector<SortedTetrahedron> sorted(begin.back());
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  for (Index slot = 0; slot < corners.size(); ++slot) {
    Tetrahedron t = corners[slot];
    if (t[0] == kNone) continue;
    const auto order = [&](std::size_t i, std::size_t j) {
      const Index low = std::min(t[i], t[j]);
      t[j] = std::max(t[i], t[j]);
      t[i] = low;
    };
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
    sorted[next[t[0]]++] = {std::uint64_t{t[1]} << 32U | t[2], t[3], slot};
  }
  for (std::size_t v = 0; v < point_count; ++v) {
    std::sort(sorted.begin() + begin[v], sorted.begin() + begin[v + 1],
              [](const SortedTetrahedron& s, const SortedTetrahedron& t) {
                return s.middle != t.middle ? s.middle < t.middle : s.greatest < t.greatest;
              });
  }
  std::vector<Index> slots;
  slots.reserve(sorted.size());
  for (const SortedTetrahedron& t : sorted) slots.push_back(t.slot);
  return slots;
}

// Renumbers tetrahedra by their ascending corners: what is near among the points is near among the
// tetrahedra, and the order of insertion leaves no trace.
TetrahedronArrays in_order_of_corners(const IncrementalDelaunay& delaunay,
                                      std::size_t point_count) {
  const std::vector<Index> slots = slots_in_order(delaunay.corners(), point_count);
  std::vector<Index> number(delaunay.corners().size());
  for (Index i = 0; i < slots.size(); ++i) number[slots[i]] = i;
  TetrahedronArrays result;
  result.corners.reserve(slots.size());
  result.neighbours.reserve(slots.size());
  for (const Index slot : slots) {
    Tetrahedron corners = delaunay.corners()[slot];
    std::array<Index, 4> neighbours = delaunay.neighbours()[slot];
    for (Index& u : neighbours) u = u == kNone ? kNone : number[u];
    least_first(corners, neighbours);
    result.corners.push_back(corners);
    result.neighbours.push_back(neighbours);
  }
  return result;
}

}  // namespace

TetrahedronArrays delaunay_tetrahedra(const std::vector<Vec3>& points,
                                      const std::vector<Index>& hull) {
  IncrementalDelaunay delaunay(points, tetrahedra_of_hull(points, hull));
  std::vector<char> is_in(points.size(), 0);
  for (const Index i : hull) is_in[i] = 1;
  std::size_t repeated = 0;
  for (const Index i : insertion_order(points.size())) {
    if (is_in[i] == 0 && !delaunay.insert(i)) ++repeated;
  }
  if (repeated != 0) {
    throw InputError(
        "duplicate_vertices",
        "Points of the surface at the place of another one: " + std::to_string(repeated) +
            ". Merge them with 'Remove Duplicate Vertices'. If the mesh has none, it is so far "
            "from the origin that no digits are left for points between its vertices: centre it "
            "with 'Transform: Translate, Center, set Origin'.");
  }
  return in_order_of_corners(delaunay, points.size());
}

}  // namespace mgf
