// SPDX-License-Identifier: GPL-3.0-or-later
// Tubes whose skeleton and geodesic circles are known by construction: rings of faces, one circle a
// ring. For tests of what is done with circles, without the stages that find them.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tests/graph_fixtures.h"
#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/surface/face_flood.h"
#include "vcg_ext/surface/geodesic_circles.h"

namespace mgf::test {

/// A surface, its skeleton, and for each skeleton edge the triangles that its circle runs through.
struct CircledShape {
  TriangleSurface surface;
  CurveSkeleton skeleton;
  GeodesicCircles circles;
};

/// Sets the circles to the given faces; polylines stay empty.
inline void set_circles(const std::vector<std::vector<Index>>& faces, CircledShape& shape) {
  shape.circles.faces = {};
  for (const std::vector<Index>& row : faces) {
    shape.circles.faces.items.insert(shape.circles.faces.items.end(), row.begin(), row.end());
    shape.circles.faces.close_row();
  }
  shape.circles.eccentricity = shape.skeleton.eccentricity;
}

/// Length of the edges between faces whose labels differ.
template <class Label>
double border_length(const FaceGraph& faces, const std::vector<Label>& label) {
  double length = 0.0;
  for (Index f = 0; f < label.size(); ++f) {
    for (Index i = 0; i < 3; ++i) {
      const Index g = faces.neighbour[f][i];
      if (g != kNone && g > f && label[g] != label[f]) length += faces.edge_length[f][i];
    }
  }
  return length;
}

/// A closed tube along x of the given length: `rings` rings of 2 · `sides` faces, and two caps
/// without circles.
inline CircledShape circled_tube(double length, double radius, Index rings, Index sides) {
  CircledShape shape;
  shape.skeleton = line_skeleton(length, static_cast<int>(rings), radius);
  for (Index i = 0; i <= rings; ++i) {
    for (Index j = 0; j < sides; ++j) {
      const double angle = 2 * M_PI * j / sides;
      shape.surface.points.emplace_back(length * i / rings, radius * std::cos(angle),
                                        radius * std::sin(angle));
    }
  }
  const auto vertex = [&](Index i, Index j) { return i * sides + j % sides; };
  std::vector<std::vector<Index>> circles(rings);
  for (Index i = 0; i < rings; ++i) {
    for (Index j = 0; j < sides; ++j) {
      for (const Triangle& t :
           {Triangle{vertex(i, j), vertex(i, j + 1), vertex(i + 1, j)},
            Triangle{vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)}}) {
        circles[i].push_back(to_index(shape.surface.triangles.size()));
        shape.surface.triangles.push_back({t[0], t[2], t[1]});
      }
    }
  }
  for (const Index end : {Index{0}, rings}) {
    const Index centre = to_index(shape.surface.points.size());
    shape.surface.points.emplace_back(length * end / rings, 0, 0);
    for (Index j = 0; j < sides; ++j) {
      const Index from = vertex(end, end == 0 ? j : j + 1);
      const Index to = vertex(end, end == 0 ? j + 1 : j);
      shape.surface.triangles.push_back({centre, from, to});
    }
  }
  set_circles(circles, shape);
  return shape;
}

/// Three bars of unit cubes that meet in the cube at the origin: along +x, -x and +y, each of
/// `cubes` cubes beyond the middle one, whose faces have `fine` x `fine` squares. One circle for
/// each slice of faces round an arm; none on the middle cube or on the ends.
class CircledTee {
 public:
  CircledTee(int cubes, int fine) : cubes_(cubes), fine_(fine) {
    static constexpr std::array<std::array<int, 2>, 3> kArms = {{{1, 0}, {-1, 0}, {0, 1}}};
    std::vector<Vec3> nodes{Vec3::Zero()};
    std::vector<std::array<Index, 2>> edges;
    for (const auto& arm : kArms) {
      const Vec3 along(arm[0], arm[1], 0);
      const double reach = cubes + 0.5;
      const int segments = (2 * cubes + 1) * fine / 2;
      add_polyline(nodes, edges, 0, kNone, segments,
                   [&](double t) { return Vec3(t * reach * along); });
    }
    shape.skeleton = tube_skeleton(nodes, edges, 0.5);
    add_boundary();
    std::vector<std::vector<Index>> circles(edges.size());
    for (Index f = 0; f < shape.surface.triangles.size(); ++f) circle_face(f, circles);
    set_circles(circles, shape);
  }

  CircledShape shape;
  /// The arm (0: +x, 1: -x, 2: +y) that a face lies on; kNone for the middle cube.
  Index arm_of_face(Index f) const { return arm_at(centroid(f)); }

 private:
  Vec3 centroid(Index f) const {
    const Triangle& t = shape.surface.triangles[f];
    const auto& points = shape.surface.points;
    return (points[t[0]] + points[t[1]] + points[t[2]]) / 3.0;
  }
  static Index arm_at(const Vec3& p) {
    if (p.x() > 0.5 + 1e-9) return 0;
    if (p.x() < -0.5 - 1e-9) return 1;
    return p.y() > 0.5 + 1e-9 ? 2 : kNone;
  }
  bool solid(const std::array<int, 3>& cube) const {
    if (cube[2] != 0) return false;
    if (cube[1] == 0) return std::abs(cube[0]) <= cubes_;
    return cube[0] == 0 && cube[1] > 0 && cube[1] <= cubes_;
  }
  Index vertex_at(const Vec3& p) {
    const std::array<long, 3> key = {std::lround(p.x() * 2 * fine_), std::lround(p.y() * 2 * fine_),
                                     std::lround(p.z() * 2 * fine_)};
    const auto [entry, is_new] = number_.try_emplace(key, to_index(shape.surface.points.size()));
    if (is_new) shape.surface.points.push_back(p);
    return entry->second;
  }
  void add_boundary() {
    for (int x = -cubes_; x <= cubes_; ++x) {
      for (int y = 0; y <= cubes_; ++y) {
        if (!solid({x, y, 0})) continue;
        for (int axis = 0; axis < 3; ++axis) {
          for (const int side : {-1, 1}) {
            std::array<int, 3> beside = {x, y, 0};
            beside[static_cast<std::size_t>(axis)] += side;
            if (!solid(beside)) add_square(Vec3(x, y, 0), axis, side);
          }
        }
      }
    }
  }
  void add_square(const Vec3& cube, int axis, int side) {
    const Vec3 normal = side * Vec3::Unit(axis);
    const Vec3 u = Vec3::Unit((axis + 1) % 3);
    const Vec3 v = side * Vec3::Unit((axis + 2) % 3);
    const Vec3 corner = cube + 0.5 * (normal - u - v);
    for (int i = 0; i < fine_; ++i) {
      for (int j = 0; j < fine_; ++j) {
        const auto at = [&](int di, int dj) {
          return vertex_at(corner + u * (i + di) / fine_ + v * (j + dj) / fine_);
        };
        shape.surface.triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
        shape.surface.triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
    }
  }
  /// Adds a face on the side of an arm to the circle of the skeleton edge beside it.
  void circle_face(Index f, std::vector<std::vector<Index>>& circles) const {
    const Vec3 c = centroid(f);
    const Index arm = arm_at(c);
    if (arm == kNone) return;
    const double along = arm == 2 ? c.y() : std::abs(c.x());
    const std::size_t per_arm = circles.size() / 3;
    const double reach = cubes_ + 0.5;
    if (along > reach - 1e-9) return;
    const auto slice = static_cast<std::size_t>(along / reach * static_cast<double>(per_arm));
    circles[arm * per_arm + slice].push_back(f);
  }

  int cubes_;
  int fine_;
  std::map<std::array<long, 3>, Index> number_;
};

/// Pieces of a surface of the same label: counted per label, over edges between faces.
inline std::map<Index, int> count_pieces(const TriangleSurface& surface,
                                         const std::vector<Index>& label) {
  std::map<std::array<Index, 2>, Index> first_face;
  DisjointSets sets(label.size());
  for (Index f = 0; f < label.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Index, 2> side = {t[i], t[(i + 1) % 3]};
      if (side[0] > side[1]) std::swap(side[0], side[1]);
      const auto [entry, is_new] = first_face.try_emplace(side, f);
      if (!is_new && label[entry->second] == label[f]) sets.join(entry->second, f);
    }
  }
  std::map<Index, int> pieces;
  for (Index f = 0; f < label.size(); ++f) {
    if (sets.find(f) == f) ++pieces[label[f]];
  }
  return pieces;
}

}  // namespace mgf::test
