// SPDX-License-Identifier: GPL-3.0-or-later
// A path that was found on the search surface, found again on the surface itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/search_surface.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf {

/// Looks up one path after the other; one per thread.
class PathLookup {
 public:
  /// Both arguments must outlive the object; `mesh` is that of the surface itself.
  PathLookup(const HalfedgeMesh& mesh, const SearchSurface& coarse, PropagationPruning pruning)
      : mesh_(mesh), coarse_(coarse), search_(mesh, pruning), allowed_(mesh.triangle_count(), 0) {}

  /// Lengths that differ by no more than rounding of long unfoldings does.
  static bool agree(double found, double length) {
    constexpr double kRounding = 1e-10;  // relative; 1e-13 unless triangles are thin
    return std::abs(found - length) <= kRounding * length;
  }

  /// Looks for the path from vertex `start` to vertex `end` that has `length` and, on the search
  /// surface, these pieces: first in the triangles that it runs through, then in what touches
  /// these, too, at last anywhere. Returns whether it is there.
  bool run(Index start, Index end, double length, const std::vector<PathPiece>& pieces) {
    targets_.assign(1, {place_of_vertex(mesh_, end), length * (1.0 + 1e-9)});
    allow_path(coarse_.place(start), coarse_.place(end), pieces);
    search_.keep_to(&allowed_);
    bool is_found = search_from(start, length);
    if (!is_found) {
      allow_neighbours();
      is_found = search_from(start, length);
    }
    for (const Index t : opened_) allowed_[t] = 0;
    opened_.clear();
    search_.keep_to(nullptr);
    return is_found || search_from(start, length);
  }

  /// The pieces of the path found by the last run.
  std::vector<PathPiece> pieces() const { return search_.pieces(0); }

 private:
  static constexpr double kSlack = 1e-6;  ///< of the mean edge: what counts as touching a path

  bool search_from(Index start, double length) {
    return search_.run(place_of_vertex(mesh_, start), targets_) &&
           agree(search_.distance(0), length);
  }

  /// Allows the triangles that a path on the search surface runs through or touches.
  void allow_path(const SurfacePlace& start, const SurfacePlace& end,
                  const std::vector<PathPiece>& pieces) {
    for (const PathPiece& piece : pieces) {
      Vec3 from = position_of(piece.from, start);
      const Vec3 to = position_of(piece.to, end);
      for (std::size_t i = 0; i < piece.crossed.size(); ++i) {
        allow_strip(triangle_of(coarse_.mesh().opposite(piece.crossed[i])), from, piece.points[i]);
        from = piece.points[i];
      }
      if (!piece.crossed.empty()) {
        allow_strip(triangle_of(piece.crossed.back()), from, to);
      } else if (piece.from == kNone || piece.to == kNone) {
        allow_strip(piece.from == kNone ? start.triangle : end.triangle, from, to);
      } else {
        const Index edge = find_halfedge(coarse_.mesh(), piece.from, piece.to);
        allow_strip(triangle_of(edge), from, to);
        allow_strip(triangle_of(coarse_.mesh().opposite(edge)), from, to);
      }
    }
  }

  /// The position of a vertex of the search surface, or of the path's end if there is none.
  Vec3 position_of(Index vertex, const SurfacePlace& end) const {
    return vertex != kNone ? coarse_.mesh().points[vertex] : end.position;
  }

  /// Allows the surface's triangles in a triangle of the search surface that the line through two
  /// of its points meets.
  void allow_strip(Index triangle, const Vec3& from, const Vec3& to) {
    const Index side = 3 * triangle;
    const HalfedgeMesh& coarse = coarse_.mesh();
    const Vec3& corner = coarse.points[coarse.tail(side)];
    const Vec3 normal = (coarse.points[coarse.head(side)] - corner)
                            .cross(coarse.points[coarse.apex(side)] - corner);
    const Vec3 across = normal.cross(to - from).normalized();
    const double slack = kSlack * mesh_.mean_edge;
    coarse_.visit_parts(triangle, [&](Index t) {
      double least = std::numeric_limits<double>::infinity();
      double most = -least;
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const double offset = across.dot(mesh_.points[mesh_.tail(h)] - from);
        least = std::min(least, offset);
        most = std::max(most, offset);
      }
      if (least <= slack && most >= -slack) allow(t);
    });
  }

  /// Allows what touches the triangles allowed.
  void allow_neighbours() {
    const std::size_t count = opened_.size();
    for (std::size_t i = 0; i < count; ++i) {
      for (Index h = 3 * opened_[i]; h < 3 * opened_[i] + 3; ++h) {
        const Index first = mesh_.outgoing[mesh_.tail(h)];
        Index turn = first;
        do {
          allow(triangle_of(turn));
          turn = mesh_.rotated(turn);
        } while (turn != first);
      }
    }
  }

  void allow(Index t) {
    if (allowed_[t] != 0) return;
    allowed_[t] = 1;
    opened_.push_back(t);
  }

  const HalfedgeMesh& mesh_;
  const SearchSurface& coarse_;
  WindowPropagation search_;
  std::vector<PropagationTarget> targets_;  ///< the one of the last run
  std::vector<char> allowed_;               ///< one per triangle: whether the search may use it
  std::vector<Index> opened_;               ///< the triangles allowed
};

}  // namespace mgf
