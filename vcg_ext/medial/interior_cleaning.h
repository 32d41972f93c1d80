// SPDX-License-Identifier: GPL-3.0-or-later
// Tidying an interior that isn't the solid the surface promised, as of a self-intersecting one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/betti.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Marks as inside what is outside but cut off from the hull: the pockets between crossing sheets.
inline void fill_pockets(const TetrahedralMesh& mesh, std::vector<char>& inside) {
  std::vector<char> outside(inside.size(), 0);
  std::vector<Index> queue;
  std::vector<char> reached(mesh.points().size(),
                            0);  // vertices: a pocket open at one is no pocket
  for (Index t = 0; t < inside.size(); ++t) {
    if (!mesh.alive(t) || inside[t] != 0) continue;
    bool hull = false;
    for (unsigned i = 0; i < 4; ++i) hull = hull || mesh.neighbour(t, i) == kNone;
    if (!hull) continue;
    outside[t] = 1;
    queue.push_back(t);
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const Index v : mesh.corners(queue[next])) {
      if (reached[v] != 0) continue;
      reached[v] = 1;
      for (const Index u : mesh.star(v)) {
        if (inside[u] != 0 || outside[u] != 0) continue;
        outside[u] = 1;
        queue.push_back(u);
      }
    }
  }
  for (Index t = 0; t < inside.size(); ++t) {
    if (mesh.alive(t) && outside[t] == 0) inside[t] = 1;
  }
}

/// Keeps the tetrahedra t with `keep[t]`; what was glued to others is boundary now.
inline void restrict_to(InteriorTetrahedra& interior, const std::vector<char>& keep) {
  std::vector<Index> number(interior.tetrahedra.size(), kNone);
  Index count = 0;
  for (Index t = 0; t < number.size(); ++t) {
    if (keep[t] != 0) number[t] = count++;
  }
  for (Index t = 0; t < number.size(); ++t) {
    if (keep[t] == 0) continue;
    interior.tetrahedra[number[t]] = interior.tetrahedra[t];
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = interior.neighbours[t][i];
      interior.neighbours[number[t]][i] = u == kNone ? kNone : number[u];
    }
  }
  interior.tetrahedra.resize(count);
  interior.neighbours.resize(count);
}

/// Keeps the `count` components with the most tetrahedra.
inline void keep_largest_components(InteriorTetrahedra& interior, std::size_t count) {
  const std::size_t size = interior.tetrahedra.size();
  DisjointSets sets(size);
  for (Index t = 0; t < size; ++t) {
    for (const Index u : interior.neighbours[t]) {
      if (u != kNone) sets.join(t, u);
    }
  }
  std::vector<Index> population(size, 0);
  std::vector<Index> roots;
  for (Index t = 0; t < size; ++t) {
    if (population[sets.find(t)]++ == 0) roots.push_back(sets.find(t));
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [&](Index a, Index b) { return population[a] > population[b]; });
  roots.resize(std::min(roots.size(), count));
  std::vector<char> keep(size, 0);
  for (Index t = 0; t < size; ++t) {
    keep[t] = std::find(roots.begin(), roots.end(), sets.find(t)) != roots.end() ? 1 : 0;
  }
  restrict_to(interior, keep);
}

/// Brings buried vertices to the boundary where that is a collapse: removes tetrahedra with exactly
/// one boundary face and the buried vertex opposite, which keeps the homotopy type.
inline void carve_buried_vertices(InteriorTetrahedra& interior) {
  const std::size_t size = interior.tetrahedra.size();
  auto& neighbours = interior.neighbours;
  // Corners glued through faces: one class is one vertex of the glued complex.
  DisjointSets corners(4 * size);
  for (Index t = 0; t < size; ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = neighbours[t][i];
      if (u == kNone || u < t) continue;
      for (unsigned k = 0; k < 4; ++k) {
        if (k == i) continue;
        corners.join(4 * t + k,
                     4 * u + corner_index(interior.tetrahedra[u], interior.tetrahedra[t][k]));
      }
    }
  }
  std::vector<char> exposed(4 * size, 0);
  std::vector<Index> queue;
  for (Index t = 0; t < size; ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      if (neighbours[t][i] != kNone) continue;
      queue.push_back(t);
      for (unsigned k = 0; k < 4; ++k) {
        if (k != i) exposed[corners.find(4 * t + k)] = 1;
      }
    }
  }
  std::vector<char> keep(size, 1);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const Index t = queue[next];
    const auto open = std::count(neighbours[t].begin(), neighbours[t].end(), kNone);
    if (keep[t] == 0 || open != 1) continue;
    const auto i = static_cast<Index>(std::find(neighbours[t].begin(), neighbours[t].end(), kNone) -
                                      neighbours[t].begin());
    if (exposed[corners.find(4 * t + i)] != 0) continue;
    exposed[corners.find(4 * t + i)] = 1;
    keep[t] = 0;
    for (const Index u : neighbours[t]) {
      if (u == kNone) continue;
      *std::find(neighbours[u].begin(), neighbours[u].end(), t) = kNone;
      queue.push_back(u);
    }
  }
  restrict_to(interior, keep);
}

}  // namespace mgf
