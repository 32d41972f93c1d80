// SPDX-License-Identifier: GPL-3.0-or-later
// Where a solid overlaps itself, two copies of the overlap, each glued to the part it belongs to:
// the solid that the surface is the boundary of, immersed in space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"
#include "vcg_ext/medial/winding_flood.h"

namespace mgf {

/// Which of the two copies of an overlap ends at each of its walls.
struct OverlapColours {
  std::vector<char> lifted;                  ///< per slot: 1 if the tetrahedron has two copies
  std::vector<std::array<char, 4>> ends_at;  ///< per wall of a lifted one: the copy that ends there
  Index regions = 0;                         ///< overlaps that were lifted
  Index fused = 0;                           ///< overlaps that can't be told apart
};

namespace lifting_detail {

constexpr char kUncoloured = 2;

class OverlapColouring {
 public:
  OverlapColouring(const TetrahedralMesh& mesh, const ConstrainedSurface& surface,
                   const WindingNumbers& winding)
      : mesh_(mesh), surface_(surface), winding_(winding) {}

  OverlapColours run() {
    colours_.lifted.assign(mesh_.slot_count(), 0);
    colours_.ends_at.assign(mesh_.slot_count(),
                            {kUncoloured, kUncoloured, kUncoloured, kUncoloured});
    std::vector<char> seen(mesh_.slot_count(), 0);
    for (Index t = 0; t < mesh_.slot_count(); ++t) {
      if (!mesh_.alive(t) || winding_.winding[t] != 2 || seen[t] != 0) continue;
      const std::vector<Index> region = collect_region(t, seen);
      if (colour(region)) {
        ++colours_.regions;
        for (const Index r : region) colours_.lifted[r] = 1;
      } else {
        ++colours_.fused;
      }
    }
    return colours_;
  }

 private:
  struct Wall {
    Index tetrahedron;
    unsigned face;
  };

  bool is_wall(Index t, unsigned i) const { return winding_.walls[t][i] != 0; }

  std::vector<Index> collect_region(Index first, std::vector<char>& seen) const {
    std::vector<Index> region{first};
    seen[first] = 1;
    for (std::size_t next = 0; next < region.size(); ++next) {
      const Index t = region[next];
      for (unsigned i = 0; i < 4; ++i) {
        const Index u = mesh_.neighbour(t, i);
        if (u == kNone || is_wall(t, i) || seen[u] != 0) continue;
        seen[u] = 1;
        region.push_back(u);
      }
    }
    return region;
  }

  // Two-colours the walls of a region: alike across an edge of two faces, unlike across a seam of
  // four. False if the region has a wall to somewhere not once covered, a knot of more sheets, a
  // boundary in several pieces, or no consistent colouring.
  bool colour(const std::vector<Index>& region) {
    std::size_t walls = 0;
    std::vector<Wall> queue;
    for (const Index t : region) {
      for (unsigned i = 0; i < 4; ++i) {
        if (!is_wall(t, i)) continue;
        ++walls;
        if (winding_.winding[mesh_.neighbour(t, i)] != 1) return false;
        if (queue.empty()) queue.push_back({t, i});
      }
    }
    colours_.ends_at[queue.front().tetrahedron][queue.front().face] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      if (!colour_neighbours(queue[next], queue)) return false;
    }
    return queue.size() == walls;
  }

  bool colour_neighbours(Wall wall, std::vector<Wall>& queue) {
    const char own = colours_.ends_at[wall.tetrahedron][wall.face];
    const Triangle face = face_of(mesh_.corners(wall.tetrahedron), wall.face);
    for (unsigned k = 0; k < 3; ++k) {
      const Index x = face[k];
      const Index y = face[(k + 1) % 3];
      const std::size_t sheets = surface_.faces_at_edge(x, y).size();
      if (sheets != 2 && sheets != 4) return false;
      const Wall other = next_wall(wall, x, y);
      const char wanted = sheets == 2 ? own : static_cast<char>(1 - own);
      char& colour = colours_.ends_at[other.tetrahedron][other.face];
      if (colour == kUncoloured) {
        colour = wanted;
        queue.push_back(other);
      } else if (colour != wanted) {
        return false;
      }
    }
    return true;
  }

  // The wall met first when turning from `wall` round its edge xy through the region.
  Wall next_wall(const Wall& wall, Index x, Index y) const {
    Index t = wall.tetrahedron;
    unsigned from = wall.face;
    for (;;) {
      unsigned to = 0;
      while (to == from || mesh_.corners(t)[to] == x || mesh_.corners(t)[to] == y) ++to;
      if (is_wall(t, to)) return {t, to};
      // The corner shared with the next tetrahedron besides x and y is the one opposite `from`.
      const Index kept = mesh_.corners(t)[from];
      t = mesh_.neighbour(t, to);
      from = other_corner(t, x, y, kept);
    }
  }

  unsigned other_corner(Index t, Index x, Index y, Index kept) const {
    unsigned i = 0;
    while (mesh_.corners(t)[i] == x || mesh_.corners(t)[i] == y || mesh_.corners(t)[i] == kept) ++i;
    return i;
  }

  const TetrahedralMesh& mesh_;
  const ConstrainedSurface& surface_;
  const WindingNumbers& winding_;
  OverlapColours colours_;
};

}  // namespace lifting_detail

/// Finds the overlaps, connected pieces of winding number 2, that are two sheets crossing, and
/// tells the sheets apart. Linear time.
inline OverlapColours colour_overlaps(const TetrahedralMesh& mesh,
                                      const ConstrainedSurface& surface,
                                      const WindingNumbers& winding) {
  return lifting_detail::OverlapColouring(mesh, surface, winding).run();
}

/// The tetrahedra marked `inside`, glued as in the mesh but for lifted ones, which come twice: at a
/// wall, one copy ends and the other goes on into what lies behind.
inline InteriorTetrahedra extract_lifted(const TetrahedralMesh& mesh,
                                         const std::vector<char>& inside,
                                         const OverlapColours& colours) {
  InteriorTetrahedra result;
  result.points = mesh.points();
  std::vector<std::array<Index, 2>> number(mesh.slot_count(), {kNone, kNone});
  for (Index t = 0; t < mesh.slot_count(); ++t) {
    if (inside[t] == 0) continue;
    for (std::size_t copy = 0; copy <= (colours.lifted[t] != 0 ? 1U : 0U); ++copy) {
      number[t][copy] = to_index(result.tetrahedra.size());
      result.tetrahedra.push_back(mesh.corners(t));
    }
  }
  result.neighbours.assign(result.tetrahedra.size(), {kNone, kNone, kNone, kNone});
  const auto glue = [&](Index t, std::size_t copy, unsigned i) {
    const Index u = mesh.neighbour(t, i);
    if (u == kNone || inside[u] == 0) return kNone;
    if (colours.lifted[t] == 0 && colours.lifted[u] == 0) return number[u][0];
    if (colours.lifted[t] != 0 && colours.lifted[u] != 0) return number[u][copy];
    if (colours.lifted[t] != 0) {
      return colours.ends_at[t][i] == static_cast<char>(copy) ? kNone : number[u][0];
    }
    unsigned j = 0;
    while (mesh.neighbour(u, j) != t) ++j;
    return number[u][static_cast<std::size_t>(1 - colours.ends_at[u][j])];
  };
  for (Index t = 0; t < mesh.slot_count(); ++t) {
    for (std::size_t copy = 0; copy < 2 && number[t][copy] != kNone; ++copy) {
      for (unsigned i = 0; i < 4; ++i) result.neighbours[number[t][copy]][i] = glue(t, copy, i);
    }
  }
  return result;
}

}  // namespace mgf
