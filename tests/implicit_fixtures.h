// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces of implicit shapes by marching tetrahedra: generic meshes of any topology.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf::test {

/// Negative inside.
using SignedDistance = std::function<double(const Vec3&)>;

/// Distance to a segment less a radius: a capsule.
inline SignedDistance capsule(const Vec3& a, const Vec3& b, double radius) {
  return [=](const Vec3& p) {
    const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
    return (p - (a + std::min(1.0, std::max(0.0, t)) * (b - a))).norm() - radius;
  };
}

inline SignedDistance united(std::vector<SignedDistance> parts) {
  return [parts = std::move(parts)](const Vec3& p) {
    double least = parts.front()(p);
    for (const SignedDistance& part : parts) least = std::min(least, part(p));
    return least;
  };
}

/// The surface shape = 0 on a cubic grid of the given step, outward oriented. The box must hold the
/// whole shape. Each cube is cut into six tetrahedra along its main diagonal, so the result is a
/// closed manifold; grid values are kept off zero.
inline TriangleSurface polygonise(const SignedDistance& shape, const Vec3& low, const Vec3& high,
                                  double step) {
  using Node = std::array<int, 3>;
  TriangleSurface surface;
  std::map<std::pair<Node, Node>, Index> vertex_on;
  std::map<Node, double> values;
  const auto place = [&](const Node& n) { return Vec3(low + step * Vec3(n[0], n[1], n[2])); };
  const auto value = [&](const Node& n) {
    const auto [entry, is_new] = values.try_emplace(n, 0.0);
    if (is_new) {
      const double d = shape(place(n));
      const double least = 0.05 * step;  // no slivers: crossings stay off the grid's nodes
      entry->second = std::abs(d) < least ? std::copysign(least, d) : d;
    }
    return entry->second;
  };
  const auto crossing = [&](const Node& a, const Node& b) {
    const auto [entry, is_new] =
        vertex_on.try_emplace(std::minmax(a, b), to_index(surface.points.size()));
    if (is_new) {
      const auto& [p, q] = entry->first;
      const double t = value(p) / (value(p) - value(q));
      surface.points.push_back((1 - t) * place(p) + t * place(q));
    }
    return entry->second;
  };
  const auto add = [&](Index a, Index b, Index c, const Vec3& outward) {
    const auto& p = surface.points;
    const bool turned = (p[b] - p[a]).cross(p[c] - p[a]).dot(outward) < 0.0;
    surface.triangles.push_back(turned ? Triangle{a, c, b} : Triangle{a, b, c});
  };
  const auto march = [&](const std::array<Node, 4>& corners) {
    std::vector<Node> inside;
    std::vector<Node> outside;
    for (const Node& n : corners) (value(n) < 0.0 ? inside : outside).push_back(n);
    if (inside.empty() || outside.empty()) return;
    Vec3 outward = Vec3::Zero();
    for (const Node& n : outside) outward += place(n) / static_cast<double>(outside.size());
    for (const Node& n : inside) outward -= place(n) / static_cast<double>(inside.size());
    if (inside.size() == 2) {
      const Index a = crossing(inside[0], outside[0]);
      const Index b = crossing(inside[0], outside[1]);
      const Index c = crossing(inside[1], outside[1]);
      const Index d = crossing(inside[1], outside[0]);
      add(a, b, c, outward);
      add(a, c, d, outward);
    } else {
      const Node& apex = inside.size() == 1 ? inside[0] : outside[0];
      const std::vector<Node>& base = inside.size() == 1 ? outside : inside;
      add(crossing(apex, base[0]), crossing(apex, base[1]), crossing(apex, base[2]), outward);
    }
  };

  const Vec3 cells = ((high - low) / step).array().ceil();
  constexpr std::array<std::array<std::size_t, 3>, 6> kAxes = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int i = 0; i < cells.x(); ++i) {
    for (int j = 0; j < cells.y(); ++j) {
      for (int k = 0; k < cells.z(); ++k) {
        for (const auto& axes : kAxes) {
          std::array<Node, 4> corners{};
          corners[0] = {i, j, k};
          for (std::size_t s = 0; s < 3; ++s) {
            corners[s + 1] = corners[s];
            ++corners[s + 1][axes[s]];
          }
          march(corners);
        }
      }
    }
  }
  return surface;
}

}  // namespace mgf::test
