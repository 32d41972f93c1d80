// SPDX-License-Identifier: GPL-3.0-or-later
// Small surfaces with known geodesics, and ways to ask for many pairs.
#pragma once

#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"

namespace mgf::test {

/// Collects triangles over points that are equal to 1e-12, so that patches join up.
class SurfaceBuilder {
 public:
  Index point(const Vec3& p) {
    const std::array<long long, 3> key{std::llround(p.x() * 1e9), std::llround(p.y() * 1e9),
                                       std::llround(p.z() * 1e9)};
    const auto [it, is_new] = index_.emplace(key, to_index(surface_.points.size()));
    if (is_new) surface_.points.push_back(p);
    return it->second;
  }
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    surface_.triangles.push_back({point(a), point(b), point(c)});
  }
  /// The parallelogram at `origin` with sides `u`, `v` as m x n cells, normal along u x v.
  void grid(const Vec3& origin, const Vec3& u, const Vec3& v, int m, int n) {
    const auto at = [&](int i, int j) -> Vec3 { return origin + u * i / m + v * j / n; };
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < n; ++j) {
        triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  const TriangleSurface& surface() const { return surface_; }

 private:
  TriangleSurface surface_;
  std::map<std::array<long long, 3>, Index> index_;
};

/// The box [0,x] x [0,y] x [0,z], each side as l, m, n cells.
inline TriangleSurface gridded_box(const Vec3& size, int l, int m, int n) {
  const Vec3 x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  SurfaceBuilder builder;
  builder.grid(Vec3::Zero(), y, x, m, l);
  builder.grid(z, x, y, l, m);
  builder.grid(Vec3::Zero(), x, z, l, n);
  builder.grid(y, z, x, n, l);
  builder.grid(Vec3::Zero(), z, y, n, m);
  builder.grid(x, y, z, m, n);
  return builder.surface();
}

/// The cylinder of given radius along z from 0 to `height`: an n-gonal prism with `rings` bands,
/// closed by fans.
inline TriangleSurface prism(double radius, double height, int n, int rings) {
  SurfaceBuilder builder;
  const auto at = [&](int i, int k) -> Vec3 {
    const double angle = 2.0 * kPi * (i % n) / n;
    return {radius * std::cos(angle), radius * std::sin(angle), height * k / rings};
  };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < rings; ++k) {
      builder.triangle(at(i, k), at(i + 1, k), at(i + 1, k + 1));
      builder.triangle(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    }
    builder.triangle(Vec3(0, 0, 0), at(i + 1, 0), at(i, 0));
    builder.triangle(Vec3(0, 0, height), at(i, rings), at(i + 1, rings));
  }
  return builder.surface();
}

/// Each triangle as four, by the midpoints of its sides: flat vertices on straight creases.
inline TriangleSurface midpoint_subdivided(const TriangleSurface& coarse) {
  TriangleSurface fine;
  fine.points = coarse.points;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [it, is_new] = middles.emplace(std::minmax(a, b), to_index(fine.points.size()));
    if (is_new) fine.points.emplace_back((coarse.points[a] + coarse.points[b]) / 2.0);
    return it->second;
  };
  for (const Triangle& t : coarse.triangles) {
    const Index ab = middle(t[0], t[1]);
    const Index bc = middle(t[1], t[2]);
    const Index ca = middle(t[2], t[0]);
    fine.triangles.insert(fine.triangles.end(),
                          {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
  }
  return fine;
}

/// A sphere of radius 1 from an octahedron split `levels` times, its points then moved in and out
/// by up to `roughness`: saddles everywhere.
inline TriangleSurface bumpy_sphere(int levels, double roughness, unsigned seed) {
  TriangleSurface sphere;
  sphere.points = {Vec3(1, 0, 0),  Vec3(0, 1, 0),  Vec3(0, 0, 1),
                   Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)};
  sphere.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                      {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  for (int i = 0; i < levels; ++i) {
    sphere = midpoint_subdivided(sphere);
    for (Vec3& p : sphere.points) p.normalize();
  }
  std::mt19937 random(seed);
  for (Vec3& p : sphere.points) {
    p *= 1.0 + roughness * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0);
  }
  return sphere;
}

/// `count` distinct pairs of vertices, at random.
inline std::vector<VertexPair> random_pairs(const TriangleSurface& surface, std::size_t count,
                                            unsigned seed) {
  std::mt19937 random(seed);
  std::set<std::pair<Index, Index>> chosen;
  const auto n = surface.points.size();
  count = std::min(count, n * (n - 1) / 2);
  while (chosen.size() < count) {
    const Index a = to_index(random() % n);
    const Index b = to_index(random() % n);
    if (a != b) chosen.insert(std::minmax(a, b));
  }
  std::vector<VertexPair> pairs;
  for (const auto& [a, b] : chosen) pairs.push_back({a, b});
  return pairs;
}

/// `count` distinct pairs at most `radius` mean edges apart in space.
inline std::vector<VertexPair> near_pairs(const TriangleSurface& surface, double radius,
                                          std::size_t count, unsigned seed) {
  const double reach = radius * make_halfedge_mesh(surface).mean_edge;
  std::mt19937 random(seed);
  std::set<std::pair<Index, Index>> chosen;
  const auto n = surface.points.size();
  while (chosen.size() < count) {
    const Index a = to_index(random() % n);
    std::vector<Index> near;
    for (Index b = 0; b < n; ++b) {
      if (b != a && (surface.points[a] - surface.points[b]).norm() <= reach) near.push_back(b);
    }
    for (int k = 0; k < 12 && !near.empty() && chosen.size() < count; ++k) {
      chosen.insert(std::minmax(a, near[random() % near.size()]));
    }
  }
  std::vector<VertexPair> pairs;
  for (const auto& [a, b] : chosen) pairs.push_back({a, b});
  return pairs;
}

/// A shared model, or an empty surface where the file isn't there.
inline TriangleSurface shared_model(const std::string& name) {
  TriangleSurface surface;
  std::ifstream file(std::string(MGF_SHARED_MODELS) + "/" + name + ".off");
  std::string magic;
  std::size_t points = 0, triangles = 0, edges = 0;
  if (!(file >> magic >> points >> triangles >> edges)) return surface;
  surface.points.resize(points);
  for (Vec3& p : surface.points) file >> p.x() >> p.y() >> p.z();
  surface.triangles.resize(triangles);
  int corners = 0;
  for (Triangle& t : surface.triangles) file >> corners >> t[0] >> t[1] >> t[2];
  return surface;
}

}  // namespace mgf::test
