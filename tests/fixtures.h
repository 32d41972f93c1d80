// SPDX-License-Identifier: GPL-3.0-or-later
// Small surfaces made in code, named for what they are; all closed and oriented outward.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/types.h"

namespace mgf::fixtures {

/// A polygon in the plane z = 0, its triangulation, and the wall up to `height`.
inline TriangleSurface extruded(const std::vector<std::array<double, 2>>& polygon,
                                const std::vector<Triangle>& cap, double height) {
  TriangleSurface s;
  const Index n = to_index(polygon.size());
  for (const double z : {0.0, height}) {
    for (const auto& p : polygon) s.points.emplace_back(p[0], p[1], z);
  }
  for (const Triangle& t : cap) {
    s.triangles.push_back({t[2], t[1], t[0]});
    s.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    s.triangles.push_back({i, j, j + n});
    s.triangles.push_back({i, j + n, i + n});
  }
  return s;
}

/// 8 vertices, a corner in the origin.
inline TriangleSurface box(double x, double y, double z) {
  return extruded({{0, 0}, {x, 0}, {x, y}, {0, y}}, {{0, 1, 2}, {0, 2, 3}}, z);
}

/// 12 vertices: arms of length 2 and width 1.
inline TriangleSurface l_block() {
  return extruded({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 1.0);
}

/// Two rings of `sides` vertices.
inline TriangleSurface coarse_cylinder(Index sides, double radius, double height) {
  std::vector<std::array<double, 2>> ring;
  std::vector<Triangle> cap;
  for (Index i = 0; i < sides; ++i) {
    const double angle = 2.0 * kPi * i / sides;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    if (i >= 2) cap.push_back({0, i - 1, i});
  }
  return extruded(ring, cap, height);
}

/// A NACA 0012 profile of `count` points (even) and chord 1, extruded: needles from end to end.
inline TriangleSurface wing(Index count, double span) {
  const Index half = count / 2;
  std::vector<std::array<double, 2>> ring;  // from the trailing edge along the upper side and back
  for (Index i = 0; i < count; ++i) {
    const double x = 0.5 * (1.0 + std::cos(2.0 * kPi * i / count));
    const double y =
        0.6 * (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * -0.1036))));
    ring.push_back({x, i == 0 ? 0.0 : (i <= half ? y : -y)});
  }
  std::vector<Triangle> cap;
  for (Index i = 0; i < half; ++i) {
    const Index below = (count - i) % count;
    const Index next_below = count - i - 1;
    if (i > 0) cap.push_back({i, i + 1, below});
    if (i + 1 < half) cap.push_back({i + 1, next_below, below});
  }
  return extruded(ring, cap, span);
}

inline TriangleSurface tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// Every face in four, edge midpoints as new vertices.
inline TriangleSurface midpoint_subdivided(const TriangleSurface& surface) {
  TriangleSurface s;
  s.points = surface.points;
  std::map<std::pair<Index, Index>, Index> midpoints;
  const auto midpoint = [&](Index a, Index b) {
    const auto [entry, fresh] = midpoints.try_emplace(std::minmax(a, b), to_index(s.points.size()));
    if (fresh) s.points.emplace_back(0.5 * (surface.points[a] + surface.points[b]));
    return entry->second;
  };
  for (const Triangle& t : surface.triangles) {
    const Index a = midpoint(t[0], t[1]);
    const Index b = midpoint(t[1], t[2]);
    const Index c = midpoint(t[2], t[0]);
    for (const Triangle& part :
         {Triangle{t[0], a, c}, Triangle{a, t[1], b}, Triangle{c, b, t[2]}, Triangle{a, b, c}}) {
      s.triangles.push_back(part);
    }
  }
  return s;
}

/// A subdivided octahedron pushed onto the sphere: 4^(levels + 1) * 2 faces.
inline TriangleSurface sphere(int levels, double radius = 1.0) {
  TriangleSurface s{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) s = midpoint_subdivided(s);
  for (Vec3& p : s.points) p = radius * p.normalized();
  return s;
}

/// A torus round the z axis.
inline TriangleSurface torus(Index around, Index across, double radius, double tube_radius) {
  TriangleSurface s;
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < across; ++j) {
      const double u = 2.0 * kPi * i / around;
      const double v = 2.0 * kPi * j / across;
      const double r = radius + tube_radius * std::cos(v);
      s.points.emplace_back(r * std::cos(u), r * std::sin(u), tube_radius * std::sin(v));
      const Index next_i = (i + 1) % around;
      const Index next_j = (j + 1) % across;
      const Index a = i * across + j;
      const Index b = next_i * across + j;
      const Index c = next_i * across + next_j;
      const Index d = i * across + next_j;
      s.triangles.push_back({a, b, c});
      s.triangles.push_back({a, c, d});
    }
  }
  return s;
}

/// Both surfaces in one; the second one's vertices and faces come last.
inline TriangleSurface joined(TriangleSurface first, const TriangleSurface& second) {
  const Index offset = to_index(first.points.size());
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (const Triangle& t : second.triangles) {
    first.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  return first;
}

inline TriangleSurface moved(TriangleSurface surface, const Vec3& by) {
  for (Vec3& p : surface.points) p += by;
  return surface;
}

inline TriangleSurface scaled(TriangleSurface surface, double factor) {
  for (Vec3& p : surface.points) p *= factor;
  return surface;
}

/// Turned by `angle` radians round `axis`.
inline TriangleSurface rotated(TriangleSurface surface, double angle, const Vec3& axis) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  for (Vec3& p : surface.points) p = turn * p;
  return surface;
}

/// The same surface looking the other way.
inline TriangleSurface reversed(TriangleSurface surface) {
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

/// Every face with three vertices of its own, as an STL file has them.
inline TriangleSurface soup(const TriangleSurface& surface) {
  TriangleSurface s;
  for (const Triangle& t : surface.triangles) {
    const Index first = to_index(s.points.size());
    for (const Index v : t) s.points.push_back(surface.points[v]);
    s.triangles.push_back({first, first + 1, first + 2});
  }
  return s;
}

/// Where a shared model lies; empty if it isn't there.
inline std::string shared_model(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(MGF_SHARED_MODELS) / (name + ".off");
  return std::filesystem::exists(path) ? path.string() : std::string();
}

/// Reads a triangle OFF file without comments.
inline TriangleSurface load_off(const std::string& path) {
  std::ifstream file(path);
  std::string keyword;
  std::size_t vertices = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  file >> keyword >> vertices >> faces >> edges;
  TriangleSurface s;
  s.points.resize(vertices);
  s.triangles.resize(faces);
  for (Vec3& p : s.points) file >> p.x() >> p.y() >> p.z();
  for (Triangle& t : s.triangles) {
    int corners = 0;
    file >> corners >> t[0] >> t[1] >> t[2];
  }
  return s;
}

}  // namespace mgf::fixtures
