// SPDX-License-Identifier: GPL-3.0-or-later
// New points on a surface and in the tetrahedral mesh at once, where flips can't make the two
// agree.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/channel.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/simplex_split.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Inserts points where a missing edge or face of the surface crosses the mesh. A point goes in
/// only if all tetrahedra that it makes are positive.
class SurfaceSplitter {
 public:
  SurfaceSplitter(TetrahedralMesh& mesh, ConstrainedSurface& surface)
      : mesh_(mesh), surface_(surface) {}

  /// Halves the edge of `segment`, as near its middle as can be. Returns the faces of the surface
  /// that changed or are new; none if no place will do.
  std::vector<Index> split_edge(const SegmentObstacle& segment, const Channel& channel) {
    const std::vector<Crossing> crossings = crossings_of(segment, channel);
    std::vector<Crossing> places = crossings;
    std::stable_sort(places.begin(), places.end(), [](const Crossing& c, const Crossing& d) {
      return std::abs(c.parameter - 0.5) < std::abs(d.parameter - 0.5);
    });
    for (const Crossing& place : places) {
      const std::optional<Index> m = insert(place.tetrahedron, place.simplex, place.size,
                                            on_segment(segment, place.parameter));
      if (m) return finish(surface_.split_edge(segment.a, segment.b, *m));
    }
    return split_edge_inside(segment, channel, crossings);
  }

  /// Cuts the face of `triangle` in three where an edge of the mesh goes through it.
  std::vector<Index> split_face(const TriangleObstacle& triangle, const Channel& channel) {
    for (const ListedEdge& edge : channel.edges) {
      const double x = volume(triangle.a, triangle.b, triangle.c, edge.x);
      const double y = volume(triangle.a, triangle.b, triangle.c, edge.y);
      const SegmentObstacle segment{edge.x, edge.y};
      const std::optional<Index> m = insert(edge.tetrahedron, {edge.x, edge.y, kNone, kNone}, 2,
                                            on_segment(segment, ratio(x, y)));
      if (m) return finish(surface_.split_face(triangle.a, triangle.b, triangle.c, *m));
    }
    return {};
  }

  Index points_added() const { return points_added_; }

 private:
  // Where a segment meets the mesh: a face or an edge of a tetrahedron.
  struct Crossing {
    double parameter;  // along the segment, in [0, 1]
    Index tetrahedron;
    std::array<Index, 4> simplex;  // its first `size` entries
    unsigned size;
  };

  double volume(Index a, Index b, Index c, Index d) const {
    const Vec3& p = mesh_.point(a);
    return (mesh_.point(b) - p).cross(mesh_.point(c) - p).dot(mesh_.point(d) - p);
  }

  // Where a function with values x and y at the ends is zero.
  static double ratio(double x, double y) {
    const double s = x / (x - y);
    return s > 0.0 && s < 1.0 ? s : 0.5;
  }

  Vec3 on_segment(const SegmentObstacle& segment, double s) const {
    return (1.0 - s) * mesh_.point(segment.a) + s * mesh_.point(segment.b);
  }

  // Ascending.
  std::vector<Crossing> crossings_of(const SegmentObstacle& segment, const Channel& channel) const {
    std::vector<Crossing> result;
    for (const ListedFace& face : channel.faces) {
      const auto [x, y, z] = face.corners;
      Crossing crossing{ratio(volume(x, y, z, segment.a), volume(x, y, z, segment.b)),
                        face.tetrahedron,
                        {x, y, z, kNone},
                        3};
      for (unsigned i = 0; i < 3; ++i) {
        const Index p = face.corners[i];
        const Index q = face.corners[(i + 1) % 3];
        if (mesh_.orientation(segment.a, segment.b, p, q) != 0) continue;
        crossing.simplex = {p, q, kNone, kNone};
        crossing.size = 2;
      }
      result.push_back(crossing);
    }
    std::stable_sort(result.begin(), result.end(), [](const Crossing& c, const Crossing& d) {
      return c.parameter < d.parameter;
    });
    return result;
  }

  // Puts the point inside a tetrahedron between two crossings.
  std::vector<Index> split_edge_inside(const SegmentObstacle& segment, const Channel& channel,
                                       const std::vector<Crossing>& crossings) {
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      const Vec3 p =
          on_segment(segment, 0.5 * (crossings[i].parameter + crossings[i + 1].parameter));
      for (const Index t : channel.tetrahedra) {
        const std::optional<Index> m = insert(t, mesh_.corners(t), 4, p);
        if (m) return finish(surface_.split_edge(segment.a, segment.b, *m));
      }
    }
    return {};
  }

  // Splits a simplex of tetrahedron t, given by its corners, at p; a face or edge of the surface
  // there is split too.
  std::optional<Index> insert(Index t, const std::array<Index, 4>& simplex, unsigned size,
                              const Vec3& p) {
    const std::vector<Index> old = tetrahedra_round(mesh_, t, simplex, size);
    if (old.empty()) return std::nullopt;
    const Index m = mesh_.add_point(p);
    if (!split_simplex(mesh_, old, simplex, size, m)) {
      mesh_.drop_last_point();
      return std::nullopt;
    }
    surface_.add_vertex();
    ++points_added_;
    if (size == 2 && surface_.has_edge(simplex[0], simplex[1])) {
      changed_ = surface_.split_edge(simplex[0], simplex[1], m);
    } else if (size == 3 && surface_.has_face(simplex[0], simplex[1], simplex[2])) {
      changed_ = surface_.split_face(simplex[0], simplex[1], simplex[2], m);
    }
    return m;
  }

  std::vector<Index> finish(std::vector<Index> faces) {
    faces.insert(faces.end(), changed_.begin(), changed_.end());
    changed_.clear();
    return faces;
  }

  TetrahedralMesh& mesh_;
  ConstrainedSurface& surface_;
  std::vector<Index> changed_;  // faces split besides the one asked for
  Index points_added_ = 0;
};

}  // namespace mgf
