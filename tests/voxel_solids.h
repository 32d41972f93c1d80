// SPDX-License-Identifier: GPL-3.0-or-later
// Solids of unit cubes as tetrahedra, for tests of the medial complex and its erosion without the
// stages before them. Each cube is cut into six tetrahedra along its main diagonal.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf::test {

using Cell = std::array<int, 3>;

/// Fills in the adjacency of tetrahedra from their corners.
inline InteriorTetrahedra from_tetrahedra(std::vector<Vec3> points,
                                          std::vector<Tetrahedron> tetrahedra) {
  InteriorTetrahedra interior;
  interior.points = std::move(points);
  interior.input_points = to_index(interior.points.size());
  interior.tetrahedra = std::move(tetrahedra);
  interior.neighbours.assign(interior.tetrahedra.size(), {kNone, kNone, kNone, kNone});
  std::map<Triangle, std::pair<Index, std::size_t>> open;
  for (Index t = 0; t < interior.tetrahedra.size(); ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Tetrahedron& corners = interior.tetrahedra[t];
      Triangle face{corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]};
      std::sort(face.begin(), face.end());
      const auto found = open.find(face);
      if (found == open.end()) {
        open[face] = {t, i};
        continue;
      }
      const auto [u, j] = found->second;
      interior.neighbours[t][i] = u;
      interior.neighbours[u][j] = t;
      open.erase(found);
    }
  }
  std::vector<char> on_boundary(interior.points.size(), 0);
  for (const auto& [face, side] : open) {
    for (const Index corner : face) on_boundary[corner] = 1;
  }
  interior.certificate.interior_vertices =
      to_index(static_cast<std::size_t>(std::count(on_boundary.begin(), on_boundary.end(), 0)));
  return interior;
}

/// The union of unit cubes with the given lowest corners, its points shaken by up to `shake` so
/// that circumcentres differ. Keep `shake` below 0.1 or tetrahedra turn over.
inline InteriorTetrahedra solid_of_cubes(const std::vector<Cell>& cubes, double shake = 0.05) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-shake, shake);
  std::map<Cell, Index> number;
  std::vector<Vec3> points;
  std::vector<Tetrahedron> tetrahedra;
  const auto corner = [&](const Cell& at) {
    const auto [entry, is_new] = number.try_emplace(at, to_index(points.size()));
    if (is_new) {
      points.emplace_back(at[0] + offset(random), at[1] + offset(random), at[2] + offset(random));
    }
    return entry->second;
  };
  constexpr std::array<std::array<std::size_t, 3>, 6> kAxes = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (const Cell& cube : cubes) {
    for (std::size_t path = 0; path < kAxes.size(); ++path) {
      Cell at = cube;
      Tetrahedron corners{};
      corners[0] = corner(at);
      for (std::size_t step = 0; step < 3; ++step) {
        ++at[kAxes[path][step]];
        corners[step + 1] = corner(at);
      }
      if (path >= 3) std::swap(corners[2], corners[3]);  // odd orders of the axes
      tetrahedra.push_back(corners);
    }
  }
  return from_tetrahedra(std::move(points), std::move(tetrahedra));
}

/// A flat square ring of cubes, n a side: one loop.
inline std::vector<Cell> ring_of_cubes(int n) {
  std::vector<Cell> cubes;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (i == 0 || j == 0 || i == n - 1 || j == n - 1) cubes.push_back({i, j, 0});
    }
  }
  return cubes;
}

/// A plate of one layer.
inline std::vector<Cell> plate_of_cubes(int width, int height) {
  std::vector<Cell> cubes;
  for (int i = 0; i < width; ++i) {
    for (int j = 0; j < height; ++j) cubes.push_back({i, j, 0});
  }
  return cubes;
}

/// The six walls of a box, n a side: a closed surface, thickened.
inline std::vector<Cell> hollow_box_of_cubes(int n) {
  std::vector<Cell> cubes;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const bool wall = i == 0 || j == 0 || k == 0 || i == n - 1 || j == n - 1 || k == n - 1;
        if (wall) cubes.push_back({i, j, k});
      }
    }
  }
  return cubes;
}

/// A house with two rooms (paper, section 7; Hatcher's example): contractible, each room reached
/// only through a tunnel that crosses the other. Its walls are a cube thick.
inline std::vector<Cell> house_with_two_rooms() {
  std::vector<Cell> cubes;
  for (int x = 0; x <= 10; ++x) {
    for (int y = 0; y <= 6; ++y) {
      for (int z = 0; z <= 8; ++z) {
        const bool shell = x == 0 || x == 10 || y == 0 || y == 6 || z == 0 || z == 4 || z == 8;
        const bool upper = z >= 5 && z <= 7;
        const bool lower = z >= 1 && z <= 3;
        const bool chimney = upper && std::abs(x - 3) <= 1 && std::abs(y - 3) <= 1;
        const bool shaft = lower && std::abs(x - 7) <= 1 && std::abs(y - 3) <= 1;
        const bool panel = y == 5 && ((upper && x == 3) || (lower && x == 7));
        const bool hollow = y == 3 && ((x == 3 && z >= 4) || (x == 7 && z <= 4));
        if ((shell || chimney || shaft || panel) && !hollow) cubes.push_back({x, y, z});
      }
    }
  }
  return cubes;
}

/// The boundary of a union of unit cubes, outward oriented, its points numbered as they come.
inline TriangleSurface surface_of_cubes(const std::vector<Cell>& cubes) {
  const std::set<Cell> filled(cubes.begin(), cubes.end());
  std::map<Cell, Index> number;
  TriangleSurface surface;
  const auto corner = [&](const Cell& at) {
    const auto [entry, is_new] = number.try_emplace(at, to_index(surface.points.size()));
    if (is_new) surface.points.emplace_back(at[0], at[1], at[2]);
    return entry->second;
  };
  for (const Cell& cube : cubes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell beyond = cube;
        beyond[axis] += side == 1 ? 1 : -1;
        if (filled.count(beyond) != 0) continue;
        std::array<Cell, 4> quad;
        quad.fill(cube);
        for (Cell& at : quad) at[axis] += side;
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        ++quad[1][u];
        ++quad[2][u];
        ++quad[2][v];
        ++quad[3][v];
        if (side == 0) std::swap(quad[1], quad[3]);
        const Index a = corner(quad[0]);
        const Index b = corner(quad[1]);
        const Index c = corner(quad[2]);
        const Index d = corner(quad[3]);
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({a, c, d});
      }
    }
  }
  return surface;
}

}  // namespace mgf::test
