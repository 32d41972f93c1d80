// SPDX-License-Identifier: GPL-3.0-or-later
// The surface as geodesics see it: directed edges, lengths, angles, and each triangle laid flat.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/constants.h"
#include "vcg_ext/core/errors.h"
#include "vcg_ext/core/types.h"

namespace mgf {

/// A point or vector in the plane of an unfolding.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;
};
inline Vec2 operator-(Vec2 p, Vec2 q) {
  return {p.x - q.x, p.y - q.y};
}
inline Vec2 operator-(Vec2 p) {
  return {-p.x, -p.y};
}
inline double cross(Vec2 p, Vec2 q) {
  return p.x * q.y - p.y * q.x;
}
inline double dot(Vec2 p, Vec2 q) {
  return p.x * q.x + p.y * q.y;
}
inline double norm(Vec2 p) {
  return std::sqrt(dot(p, p));
}
/// The point at `share` of the way from p to q.
inline Vec2 point_between(Vec2 p, Vec2 q, double share) {
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
}
/// The point that lies `along` and `across` (to the left) the segment from tail to head, in units
/// of its length.
inline Vec2 place_beside(Vec2 tail, Vec2 head, double along, double across) {
  const Vec2 edge = head - tail;
  return {tail.x + along * edge.x - across * edge.y, tail.y + along * edge.y + across * edge.x};
}

/// Directed edge 3t + i runs from corner i to corner i + 1 of triangle t. Its frame has the tail at
/// the origin and the head at (length, 0); the triangle lies above, with its apex at `apex`.
struct Halfedge {
  double length = 0.0;
  Vec2 apex;
  Index opposite = kNone;
  Index tail = kNone;
};

inline Index triangle_of(Index h) {
  return h / 3;
}
inline Index next_in_triangle(Index h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
inline Index previous_in_triangle(Index h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

enum Side { kLeft = 0, kRight = 1 };  ///< of a path

/// What a straight path meets that enters a triangle through a directed edge of it: all that a
/// search needs there, in half a cache line.
struct alignas(32) Crossing {
  double along = 0.0;   ///< where the apex lies: along the edge from its tail, over its length,
  double across = 0.0;  ///< and across it
  Index apex = kNone;   ///< the vertex
  /// The other edges, each in the triangle beyond it: on the left that between tail and apex, on
  /// the right that between apex and head.
  std::array<Index, 2> beyond = {kNone, kNone};
  bool apex_is_saddle = false;
  bool is_thin = false;  ///< of the triangle; see HalfedgeMesh::is_thin
};

/// The closed oriented surface. Distances depend on `halfedges` alone; `points` serve bounds and
/// tangents.
struct HalfedgeMesh {
  std::vector<Vec3> points;
  std::vector<Halfedge> halfedges;
  std::vector<double> direction;    ///< one per halfedge: its angle about the tail, anticlockwise
                                    ///< from the tail's `outgoing`, on the surface
  std::vector<double> total_angle;  ///< one per vertex
  std::vector<double> half_angle_cosine;  ///< one per vertex, of half its total angle, at most pi
  std::vector<Index> outgoing;            ///< one per vertex: a halfedge that leaves it, or kNone
  std::vector<char> is_thin;        ///< one per triangle: so thin (kThin) that angles are uncertain
  std::vector<Crossing> crossings;  ///< one per halfedge
  Rows<Index> fans;  ///< one row per vertex: the halfedges out of it, anticlockwise from `outgoing`
  double mean_edge = 0.0;

  std::size_t vertex_count() const { return points.size(); }
  std::size_t triangle_count() const { return halfedges.size() / 3; }
  Index tail(Index h) const { return halfedges[h].tail; }
  Index head(Index h) const { return halfedges[next_in_triangle(h)].tail; }
  Index apex(Index h) const { return halfedges[previous_in_triangle(h)].tail; }
  Index opposite(Index h) const { return halfedges[h].opposite; }
  /// The next halfedge out of the same tail, anticlockwise.
  Index rotated(Index h) const { return halfedges[previous_in_triangle(h)].opposite; }
  /// The previous halfedge out of the same tail, that is clockwise.
  Index rotated_back(Index h) const { return next_in_triangle(halfedges[h].opposite); }
  double corner_angle(Index h) const {
    return std::atan2(halfedges[h].apex.y, halfedges[h].apex.x);
  }
  /// More than a full turn, so that a shortest path may pass through the vertex and bend.
  bool is_saddle(Index v) const { return total_angle[v] > 2.0 * kPi + kFlatAngle; }

  /// Angle defects below this are rounding.
  static constexpr double kFlatAngle = 1e-11;
  /// Height over longest side below which the rounding of angles may show in lengths.
  static constexpr double kThin = 1e-6;
  /// Points nearer than this, in mean edges, are one. Edges count as that long at least: less than
  /// what searches take for the same length (1e-10).
  static constexpr double kHair = 1e-11;
};

namespace detail {

inline std::string place_text(const Vec3& p) {
  std::ostringstream text;
  text << '(' << p.x() << ", " << p.y() << ", " << p.z() << ')';
  return text.str();
}

/// Pairs each directed edge with its opposite. Throws `InputError` where that is not one to one.
inline void match_opposites(HalfedgeMesh& mesh) {
  struct Side {
    Index high, halfedge;
    bool operator<(const Side& o) const {
      return std::tie(high, halfedge) < std::tie(o.high, o.halfedge);
    }
  };
  std::vector<Index> low(mesh.halfedges.size());
  for (Index h = 0; h < low.size(); ++h) low[h] = std::min(mesh.tail(h), mesh.head(h));
  const Rows<Index> at_low = group_by_key(low, mesh.points.size());
  std::vector<Side> sides;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    sides.clear();
    for (const Index h : at_low[v]) sides.push_back({std::max(mesh.tail(h), mesh.head(h)), h});
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size(); i += 2) {
      const bool paired = i + 1 < sides.size() && sides[i].high == sides[i + 1].high &&
                          mesh.tail(sides[i].halfedge) != mesh.tail(sides[i + 1].halfedge);
      const bool tripled = i + 2 < sides.size() && sides[i].high == sides[i + 2].high;
      if (!paired || tripled) {
        throw InputError("surface_not_closed",
                         "The edge from " + place_text(mesh.points[v]) + " to " +
                             place_text(mesh.points[sides[i].high]) +
                             " does not have exactly two faces with opposite directions.");
      }
      mesh.halfedges[sides[i].halfedge].opposite = sides[i + 1].halfedge;
      mesh.halfedges[sides[i + 1].halfedge].opposite = sides[i].halfedge;
    }
  }
}

/// The height of a triangle above its side `base`, by Kahan's stable form of Heron's formula.
inline double height_by_lengths(double base, double left, double right) {
  std::array<double, 3> s{base, left, right};
  std::sort(s.begin(), s.end());
  const double excess = s[0] - (s[2] - s[1]);  // of the two shorter sides over the longest
  if (!(excess > 0.0)) return 0.0;
  const double product =
      (s[2] + (s[1] + s[0])) * excess * (s[0] + (s[2] - s[1])) * (s[2] + (s[1] - s[0]));
  return 0.5 * std::sqrt(product) / base;
}

/// Lays triangle t flat above each of its sides, by the places of its corners.
inline void lay_flat_by_places(Index t, double least_height, HalfedgeMesh& mesh) {
  for (Index h = 3 * t; h < 3 * t + 3; ++h) {
    Halfedge& side = mesh.halfedges[h];
    const Vec3 edge = mesh.points[mesh.head(h)] - mesh.points[side.tail];
    const Vec3 arm = mesh.points[mesh.apex(h)] - mesh.points[side.tail];
    side.apex.x = edge.dot(arm) / side.length;
    side.apex.y = std::max(edge.cross(arm).norm() / side.length, least_height);
  }
}

/// The same by the lengths of its sides, where corners have no places of their own.
inline void lay_flat_by_lengths(Index t, double least_height, HalfedgeMesh& mesh) {
  for (Index h = 3 * t; h < 3 * t + 3; ++h) {
    Halfedge& side = mesh.halfedges[h];
    const double base = side.length;
    const double right = mesh.halfedges[next_in_triangle(h)].length;
    const double left = mesh.halfedges[previous_in_triangle(h)].length;
    // From the nearer end, as the other form would lose a short side.
    side.apex.x = left <= right
                      ? 0.5 * ((base - right) * (base + right) + left * left) / base
                      : base - 0.5 * ((base - left) * (base + left) + right * right) / base;
    side.apex.y = std::max(height_by_lengths(base, left, right), least_height);
  }
}

/// Lays all triangles flat. A side without length and a triangle without height get a hair of it,
/// so that directions are defined.
inline void lay_flat(HalfedgeMesh& mesh) {
  constexpr double kLeastHeight = 1e-13;  // of the longest side
  double sum = 0.0;
  for (Index h = 0; h < mesh.halfedges.size(); ++h) {
    mesh.halfedges[h].length = (mesh.points[mesh.head(h)] - mesh.points[mesh.tail(h)]).norm();
    sum += mesh.halfedges[h].length;
  }
  if (!mesh.halfedges.empty()) mesh.mean_edge = sum / static_cast<double>(mesh.halfedges.size());
  const double hair = HalfedgeMesh::kHair * mesh.mean_edge;
  for (Halfedge& side : mesh.halfedges) side.length = std::max(side.length, hair);
  mesh.is_thin.assign(mesh.triangle_count(), 0);
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const std::array<Index, 3> sides = {3 * t, 3 * t + 1, 3 * t + 2};
    const auto [shortest, longest] =
        std::minmax({mesh.halfedges[sides[0]].length, mesh.halfedges[sides[1]].length,
                     mesh.halfedges[sides[2]].length});
    if (shortest > hair) {
      lay_flat_by_places(t, kLeastHeight * longest, mesh);
    } else {
      lay_flat_by_lengths(t, kLeastHeight * longest, mesh);
    }
    for (const Index h : sides) {
      const Halfedge& side = mesh.halfedges[h];
      if (std::min(side.apex.y, side.length) < HalfedgeMesh::kThin * longest) mesh.is_thin[t] = 1;
    }
  }
}

/// Measures the angle of each halfedge about its tail. Throws where a vertex has more than one fan.
inline void measure_angles(HalfedgeMesh& mesh) {
  mesh.direction.assign(mesh.halfedges.size(), -1.0);
  mesh.total_angle.assign(mesh.points.size(), 0.0);
  mesh.half_angle_cosine.assign(mesh.points.size(), 1.0);
  mesh.outgoing.assign(mesh.points.size(), kNone);
  for (Index h = 0; h < mesh.halfedges.size(); ++h) {
    const Index v = mesh.tail(h);
    if (mesh.direction[h] >= 0.0) continue;
    if (mesh.outgoing[v] != kNone) {
      throw InputError(
          "vertex_not_manifold",
          "The faces at the vertex " + place_text(mesh.points[v]) + " form more than one fan.");
    }
    mesh.outgoing[v] = h;
    double angle = 0.0;
    Index turn = h;
    do {
      mesh.direction[turn] = angle;
      angle += mesh.corner_angle(turn);
      turn = mesh.rotated(turn);
    } while (turn != h);
    mesh.total_angle[v] = angle;
    mesh.half_angle_cosine[v] = std::cos(std::min(0.5 * angle, kPi));
  }
}

inline void list_fans(HalfedgeMesh& mesh) {
  mesh.fans.items.reserve(mesh.halfedges.size());
  for (const Index first : mesh.outgoing) {
    for (Index h = first; h != kNone;) {
      mesh.fans.items.push_back(h);
      h = mesh.rotated(h);
      if (h == first) break;
    }
    mesh.fans.close_row();
  }
}

inline void list_crossings(HalfedgeMesh& mesh) {
  mesh.crossings.reserve(mesh.halfedges.size());
  for (Index h = 0; h < mesh.halfedges.size(); ++h) {
    const Halfedge& edge = mesh.halfedges[h];
    const Index apex = mesh.apex(h);
    mesh.crossings.push_back(
        {edge.apex.x / edge.length,
         edge.apex.y / edge.length,
         apex,
         {mesh.opposite(previous_in_triangle(h)), mesh.opposite(next_in_triangle(h))},
         mesh.is_saddle(apex),
         mesh.is_thin[triangle_of(h)] != 0});
  }
}

}  // namespace detail

/// The halfedges of `surface`, which must be closed, oriented, edge- and vertex-manifold (several
/// shells are fine, and so are points without a face). Throws `InputError` where it is not. O(n log
/// n).
inline HalfedgeMesh make_halfedge_mesh(const TriangleSurface& surface) {
  HalfedgeMesh mesh;
  mesh.points = surface.points;
  mesh.halfedges.resize(3 * surface.triangles.size());
  for (Index t = 0; t < surface.triangles.size(); ++t) {
    for (Index i = 0; i < 3; ++i) mesh.halfedges[3 * t + i].tail = surface.triangles[t][i];
  }
  detail::match_opposites(mesh);
  detail::lay_flat(mesh);
  detail::measure_angles(mesh);
  detail::list_fans(mesh);
  detail::list_crossings(mesh);
  return mesh;
}

}  // namespace mgf
