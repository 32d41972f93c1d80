// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces lofted along x whose cross-sections are known: rods, bars, a paddle. Vertices lie
// exactly on the shape and are shaken along it, so that no five of them lie on one sphere.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf::test {

/// The point of a cross-section at `x`, at share `u` in [0, 1) of its way round: (y, z).
using Section = std::function<std::array<double, 2>(double x, double u)>;

/// A circle of the given radius.
inline std::array<double, 2> circle_section(double radius, double u) {
  return {radius * std::cos(2 * M_PI * u), radius * std::sin(2 * M_PI * u)};
}

/// A rectangle of the given width (y) and height (z), walked at even speed from (width / 2, 0).
inline std::array<double, 2> rectangle_section(double width, double height, double u) {
  const double y = 0.5 * width;
  const double z = 0.5 * height;
  const std::array<std::array<double, 2>, 6> corners = {
      {{y, 0}, {y, z}, {-y, z}, {-y, -z}, {y, -z}, {y, 0}}};
  double walk = u * 2 * (width + height);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double dy = corners[i + 1][0] - corners[i][0];
    const double dz = corners[i + 1][1] - corners[i][1];
    const double side = std::hypot(dy, dz);
    if (walk <= side) {
      return {corners[i][0] + dy * walk / side, corners[i][1] + dz * walk / side};
    }
    walk -= side;
  }
  return corners[0];
}

/// The surface with that cross-section for x in [0, length]: `rings` + 1 rings of `sides` vertices,
/// closed by flat ends of concentric rings. Requires rings, sides >= 3.
inline TriangleSurface lofted(double length, Index rings, Index sides, const Section& section) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shake(-0.2, 0.2);
  TriangleSurface surface;
  const auto add_ring = [&](double x, double x_step, double scale, double phase) {
    for (Index j = 0; j < sides; ++j) {
      const double at = x + x_step * shake(random);
      double u = (j + phase + shake(random)) / sides;
      u -= std::floor(u);
      const std::array<double, 2> yz = section(at, u);
      surface.points.emplace_back(at, scale * yz[0], scale * yz[1]);
    }
  };
  const Index cap_rings = sides / 6;
  const auto cap_scale = [&](Index i) { return static_cast<double>(i) / cap_rings; };
  std::vector<double> phases;
  const auto next_phase = [&] {
    phases.push_back(phases.size() % 2 == 0 ? 0.0 : 0.5);
    return phases.back();
  };
  for (Index i = 1; i < cap_rings; ++i) add_ring(0.0, 0.0, cap_scale(i), next_phase());
  for (Index i = 0; i <= rings; ++i) {
    const bool at_end = i == 0 || i == rings;
    add_ring(length * i / rings, at_end ? 0.0 : length / rings, 1.0, next_phase());
  }
  for (Index i = cap_rings - 1; i >= 1; --i) add_ring(length, 0.0, cap_scale(i), next_phase());

  for (Index i = 0; i + 1 < phases.size(); ++i) {
    for (Index j = 0; j < sides; ++j) {
      const Index next = (j + 1) % sides;
      const Index a = i * sides + j;
      const Index b = i * sides + next;
      const Index c = (i + 1) * sides + j;
      const Index d = (i + 1) * sides + next;
      // Vertex j of a ring with phase 1/2 lies between vertices j and j + 1 of its neighbours.
      if (phases[i] == 0.0) {
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({c, b, d});
      } else {
        surface.triangles.push_back({a, b, d});
        surface.triangles.push_back({a, d, c});
      }
    }
  }
  const Index last_ring = to_index(surface.points.size()) - sides;
  for (const Index ring : {Index{0}, last_ring}) {
    const Index centre = to_index(surface.points.size());
    surface.points.emplace_back(ring == 0 ? 0.0 : length, 0.0, 0.0);
    for (Index j = 0; j < sides; ++j) {
      const Index a = ring + j;
      const Index b = ring + (j + 1) % sides;
      surface.triangles.push_back(ring == 0 ? Triangle{centre, b, a} : Triangle{centre, a, b});
    }
  }
  return surface;
}

/// A round rod of diameter 1 for x < 5 that widens to a blade of 4 by 0.4 for x > 5.5, 11 long.
/// Edges are about 0.12 long, or that times `coarser`.
inline TriangleSurface paddle(double coarser = 1.0) {
  const auto rings = static_cast<Index>(130 / coarser);
  const auto sides = static_cast<Index>(72 / coarser);
  return lofted(11.0, rings, sides, [](double x, double u) {
    const std::array<double, 2> rod = circle_section(0.5, u);
    const std::array<double, 2> blade = rectangle_section(4.0, 0.4, u);
    const double t = std::clamp((x - 5.0) / 0.5, 0.0, 1.0);
    return std::array<double, 2>{(1 - t) * rod[0] + t * blade[0], (1 - t) * rod[1] + t * blade[1]};
  });
}

}  // namespace mgf::test
