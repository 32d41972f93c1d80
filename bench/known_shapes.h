// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes whose centreline is known, for a study of how near the skeleton comes to it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/implicit_fixtures.h"
#include "tests/lofted_fixtures.h"
#include "vcg_ext/core/types.h"

namespace mgf::bench {

/// A straight piece of a centreline, and the radius of the tube round it.
struct CentrePiece {
  Vec3 from;
  Vec3 to;
  double radius = 1.0;
};

/// A surface with what its skeleton should be. `junctions` counts those nearer than a radius once.
struct KnownShape {
  std::string name;
  TriangleSurface surface;
  std::vector<CentrePiece> centreline;
  Index cycles = 0;
  Index leaves = 0;
  Index junctions = 0;
};

using Curve = std::function<Vec3(double)>;  ///< of a parameter in [0, 1]

/// How a tube is meshed: `rings` of `sides` vertices, shaken by a share of their distances.
struct TubeMesh {
  Index rings = 200;
  Index sides = 24;
  double shake = 0.2;
};

namespace detail {

/// A frame carried along a curve without turning round it.
struct Frame {
  Vec3 tangent;
  Vec3 normal;

  void move_to(const Vec3& next) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(tangent, next);
    normal = (turn * normal).normalized();
    tangent = next;
  }
  Vec3 around(double angle) const {
    return std::cos(angle) * normal + std::sin(angle) * tangent.cross(normal);
  }
};

inline Vec3 tangent_at(const Curve& curve, double t) {
  constexpr double kStep = 1e-5;
  return (curve(t + kStep) - curve(t - kStep)).normalized();
}

inline Frame first_frame(const Vec3& tangent) {
  Eigen::Index axis = 0;
  tangent.cwiseAbs().minCoeff(&axis);
  return {tangent, tangent.cross(Vec3(Vec3::Unit(axis))).normalized()};
}

/// Joins two rings of vertices given by their first numbers, the second turned on by `offset`.
inline void join_rings(Index first, Index second, Index sides, Index offset,
                       TriangleSurface& surface) {
  for (Index j = 0; j < sides; ++j) {
    const Index a = first + j;
    const Index b = first + (j + 1) % sides;
    const Index c = second + (j + offset) % sides;
    const Index d = second + (j + 1 + offset) % sides;
    surface.triangles.push_back({a, b, c});
    surface.triangles.push_back({c, b, d});
  }
}

inline void close_ring(Index ring, const Vec3& pole, Index sides, bool at_end,
                       TriangleSurface& surface) {
  const Index centre = to_index(surface.points.size());
  surface.points.push_back(pole);
  for (Index j = 0; j < sides; ++j) {
    const Index a = ring + j;
    const Index b = ring + (j + 1) % sides;
    surface.triangles.push_back(at_end ? Triangle{a, b, centre} : Triangle{b, a, centre});
  }
}

/// Which step of the last ring goes on to the first vertex of the first: where a closed curve's
/// frame has turned to.
inline Index turned_by(const Frame& last, const Frame& first, Index sides) {
  const double angle =
      std::atan2(last.tangent.cross(last.normal).dot(first.normal), last.normal.dot(first.normal));
  const double steps = std::round(angle / (2 * M_PI) * sides);
  return static_cast<Index>(static_cast<long>(sides - steps) % sides);
}

}  // namespace detail

/// The tube of a curve: closed on itself, or open with a half ball at each end.
inline TriangleSurface swept_tube(const Curve& curve, double radius, bool closed,
                                  const TubeMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shaken(-mesh.shake, mesh.shake);
  TriangleSurface surface;
  const detail::Frame first = detail::first_frame(detail::tangent_at(curve, 0.0));
  detail::Frame frame = first;
  const auto add_ring = [&](double t, double along, double scale) {
    frame.move_to(detail::tangent_at(curve, t));
    for (Index j = 0; j < mesh.sides; ++j) {
      const double angle = 2 * M_PI * (j + shaken(random)) / mesh.sides;
      surface.points.push_back(curve(t) +
                               radius * (along * frame.tangent + scale * frame.around(angle)));
    }
  };
  const Index cap = mesh.sides / 4;  // rings of a half ball
  const auto latitude = [&](Index i) { return 0.5 * M_PI * i / cap; };
  if (!closed) {
    for (Index i = 1; i < cap; ++i) {
      add_ring(0.0, -std::cos(latitude(i)), std::sin(latitude(i)));
    }
  }
  const Index bodies = closed ? mesh.rings : mesh.rings + 1;
  for (Index i = 0; i < bodies; ++i) {
    const bool at_end = !closed && (i == 0 || i == mesh.rings);
    const double shift = at_end ? 0.0 : shaken(random);
    add_ring((i + shift) / mesh.rings, 0.0, 1.0);
  }
  if (!closed) {
    for (Index i = cap - 1; i >= 1; --i) {
      add_ring(1.0, std::cos(latitude(i)), std::sin(latitude(i)));
    }
  }
  const Index rings = to_index(surface.points.size()) / mesh.sides;
  for (Index i = 0; i + 1 < rings; ++i) {
    detail::join_rings(i * mesh.sides, (i + 1) * mesh.sides, mesh.sides, 0, surface);
  }
  const Index last = (rings - 1) * mesh.sides;
  if (closed) {
    frame.move_to(first.tangent);
    detail::join_rings(last, 0, mesh.sides, detail::turned_by(frame, first, mesh.sides), surface);
  } else {
    const Vec3 start = curve(0.0) - radius * detail::tangent_at(curve, 0.0);
    const Vec3 end = curve(1.0) + radius * detail::tangent_at(curve, 1.0);
    detail::close_ring(0, start, mesh.sides, false, surface);
    detail::close_ring(last, end, mesh.sides, true, surface);
  }
  return surface;
}

inline std::vector<CentrePiece> pieces_of(const Curve& curve, double radius) {
  constexpr int kPieces = 4000;
  std::vector<CentrePiece> pieces;
  for (int i = 0; i < kPieces; ++i) {
    pieces.push_back({curve(1.0 * i / kPieces), curve((i + 1.0) / kPieces), radius});
  }
  return pieces;
}

/// The trefoil knot, about 6 across.
inline KnownShape trefoil(double radius, const TubeMesh& mesh, unsigned seed) {
  const Curve curve = [](double t) {
    const double a = 2 * M_PI * t;
    return Vec3(std::sin(a) + 2 * std::sin(2 * a), std::cos(a) - 2 * std::cos(2 * a),
                -std::sin(3 * a));
  };
  return {"trefoil", swept_tube(curve, radius, true, mesh, seed), pieces_of(curve, radius), 1, 0,
          0};
}

/// Three turns of radius 2.
inline KnownShape helix(double radius, const TubeMesh& mesh, unsigned seed) {
  const Curve curve = [](double t) {
    return Vec3(2 * std::cos(6 * M_PI * t), 2 * std::sin(6 * M_PI * t), 6 * t);
  };
  return {"helix", swept_tube(curve, radius, false, mesh, seed), pieces_of(curve, radius), 0, 2, 0};
}

/// The union of the tubes of straight pieces, by marching tetrahedra.
inline TriangleSurface union_of_tubes(const std::vector<CentrePiece>& pieces, double step) {
  std::vector<test::SignedDistance> parts;
  Vec3 low = pieces.front().from;
  Vec3 high = low;
  double margin = 0.0;
  for (const CentrePiece& piece : pieces) {
    parts.push_back(test::capsule(piece.from, piece.to, piece.radius));
    low = low.cwiseMin(piece.from).cwiseMin(piece.to);
    high = high.cwiseMax(piece.from).cwiseMax(piece.to);
    margin = std::max(margin, piece.radius + 2 * step);
  }
  const Vec3 around = Vec3::Constant(margin) + 0.37 * Vec3::Constant(step);  // off the grid
  return test::polygonise(test::united(parts), low - around, high + around, step);
}

/// Three limbs of length 4 in space.
inline KnownShape y_shape(double radius, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> tilt(-0.4, 0.4);
  KnownShape shape{"Y", {}, {}, 0, 3, 1};
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3 + tilt(random);
    const Vec3 tip(4 * std::cos(angle), 4 * std::sin(angle), 4 * tilt(random));
    shape.centreline.push_back({Vec3::Zero(), tip, radius});
  }
  shape.surface = union_of_tubes(shape.centreline, step);
  return shape;
}

namespace detail {

/// Distance of two segments, by samples: enough to keep limbs apart.
inline double limb_distance(const CentrePiece& p, const CentrePiece& q) {
  constexpr int kSamples = 20;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      const Vec3 a = p.from + (p.to - p.from) * i / kSamples;
      const Vec3 b = q.from + (q.to - q.from) * j / kSamples;
      least = std::min(least, (a - b).norm());
    }
  }
  return least;
}

}  // namespace detail

/// A tree of `limbs` straight limbs that fork in two, or go on from a tip, and keep apart.
inline KnownShape random_tree(Index limbs, double radius, double step, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::uniform_real_distribution<double> length(7.0, 12.0);  // in radii
  KnownShape shape{"tree", {}, {{Vec3(0, 0, -8 * radius), Vec3::Zero(), radius}}, 0, 0, 0};
  std::vector<Index> children(1, 0);
  std::vector<CentrePiece>& pieces = shape.centreline;
  while (pieces.size() < limbs) {
    const Index parent = static_cast<Index>(random() % pieces.size());
    const Vec3 start = pieces[parent].to;
    Vec3 direction = (pieces[parent].to - pieces[parent].from).normalized();
    direction += 1.2 * Vec3(normal(random), normal(random), normal(random)).normalized();
    const CentrePiece limb{start, start + length(random) * radius * direction.normalized(), radius};
    bool apart = children[parent] < 2;
    for (const CentrePiece& other : pieces) {
      // Limbs that share an end are looked at from four radii on.
      const bool adjacent = other.to == start || other.from == start;
      const Vec3 along = (limb.to - limb.from).normalized();
      const CentrePiece rest{adjacent ? Vec3(limb.from + 4 * radius * along) : limb.from, limb.to,
                             radius};
      if (detail::limb_distance(rest, other) < 3.2 * radius) apart = false;
    }
    if (!apart) continue;
    ++children[parent];
    pieces.push_back(limb);
    children.push_back(0);
  }
  shape.leaves = 1;  // the root
  for (const Index count : children) {
    shape.leaves += count == 0 ? 1 : 0;
    shape.junctions += count == 2 ? 1 : 0;
  }
  shape.surface = union_of_tubes(pieces, step);
  return shape;
}

/// `n` x `n` meshes of tubes in a plane, knots 3 apart.
inline KnownShape grid_of_tubes(int n, double radius, double step) {
  KnownShape shape{
      "grid", {}, {}, static_cast<Index>(n * n), 0, static_cast<Index>((n + 1) * (n + 1) - 4)};
  constexpr double kApart = 3.0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const Vec3 knot(kApart * i, kApart * j, 0.0);
      if (i < n) shape.centreline.push_back({knot, knot + Vec3(kApart, 0, 0), radius});
      if (j < n) shape.centreline.push_back({knot, knot + Vec3(0, kApart, 0), radius});
    }
  }
  shape.surface = union_of_tubes(shape.centreline, step);
  return shape;
}

/// A rod that widens to a blade (see `test::paddle`); radius is that of the rod or half the blade's
/// thickness.
inline KnownShape paddle(double coarser) {
  return {"paddle",
          test::paddle(coarser),
          {{Vec3(0.5, 0, 0), Vec3(5.0, 0, 0), 0.5}, {Vec3(5.0, 0, 0), Vec3(10.8, 0, 0), 0.2}},
          0,
          2,
          0};
}

/// A bar of the given width and height, 6 long, with edges of about `step`.
inline KnownShape block(double width, double height, double step) {
  const Index sides = static_cast<Index>(2 * (width + height) / step);
  return {"block",
          test::lofted(6.0, static_cast<Index>(6.0 / step), sides,
                       [=](double, double u) { return test::rectangle_section(width, height, u); }),
          {{Vec3(height / 2, 0, 0), Vec3(6 - height / 2, 0, 0), height / 2}},
          0,
          2,
          0};
}

/// Half axes 3 > b >= c.
inline KnownShape ellipsoid(double b, double c, double step) {
  const test::SignedDistance shape = [=](const Vec3& p) {
    const double k = Vec3(p.x() / 3, p.y() / b, p.z() / c).norm();
    return (k - 1) * c;
  };
  const Vec3 corner(3.3, 1.1 * b + step, 1.1 * c + step);
  return {"ellipsoid",
          test::polygonise(shape, -corner, corner, step),
          {{Vec3(-3 + c * c / 3, 0, 0), Vec3(3 - c * c / 3, 0, 0), c}},
          0,
          2,
          0};
}

}  // namespace mgf::bench
