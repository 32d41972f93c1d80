// SPDX-License-Identifier: GPL-3.0-or-later
// Placement of Voronoi vertices inside the shape. A circumcentre may lie outside; which cells there
// are does not depend on it, so it may be moved without touching the topology.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf {

namespace detail {

/// The share of the way from inside tetrahedron t at `from` to `to` that is behind one when the
/// surface is met; infinite if `to` lies before that. Walks from tetrahedron to tetrahedron;
/// `step_limit` bounds the walk where rounding in slivers could make it wander, and then the share
/// reached so far is given.
inline double visible_share(const InteriorTetrahedra& interior, Index t, const Vec3& from,
                            const Vec3& to, std::size_t step_limit) {
  constexpr double kBeyond = 1.0 + 1e-9;  // nearer than that, `to` lies on the surface
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const Vec3 direction = to - from;
  Index previous = kNone;
  double reached = 0.0;
  for (std::size_t step = 0; step < step_limit; ++step) {
    const Tetrahedron& corners = interior.tetrahedra[t];
    double exit_share = kNever;
    std::size_t exit_face = 4;
    for (std::size_t i = 0; i < 4; ++i) {
      if (interior.neighbours[t][i] == previous && previous != kNone) continue;
      const Vec3& p = interior.points[corners[(i + 1) % 4]];
      const Vec3 normal = (interior.points[corners[(i + 2) % 4]] - p)
                              .cross(interior.points[corners[(i + 3) % 4]] - p);
      const double outward = normal.dot(p - interior.points[corners[i]]) > 0.0 ? 1.0 : -1.0;
      const double speed = outward * normal.dot(direction);
      if (speed <= 0.0) continue;
      const double share = outward * normal.dot(p - from) / speed;
      if (share < exit_share) {
        exit_share = share;
        exit_face = i;
      }
    }
    if (exit_share >= kBeyond) return kNever;
    reached = std::max(reached, exit_share);
    const Index next = interior.neighbours[t][exit_face];
    if (next == kNone) return reached;
    previous = t;
    t = next;
  }
  return reached;
}

}  // namespace detail

/// Centroid of a tetrahedron.
inline Vec3 tetrahedron_centroid(const InteriorTetrahedra& interior, Index t) {
  const Tetrahedron& corners = interior.tetrahedra[t];
  return 0.25 * (interior.points[corners[0]] + interior.points[corners[1]] +
                 interior.points[corners[2]] + interior.points[corners[3]]);
}

namespace detail {

/// Whether rounding leaves little of a tetrahedron's circumcentre: its corners are coplanar but for
/// a few units in the last place (cocircular contacts, as on any surface of revolution).
inline bool is_flat(const InteriorTetrahedra& interior, Index t) {
  constexpr double kLeastVolume = 1e-11;  // of the cube of the longest edge: five digits are left
  const Tetrahedron& corners = interior.tetrahedra[t];
  const Vec3& p = interior.points[corners[0]];
  const Vec3 a = interior.points[corners[1]] - p;
  const Vec3 b = interior.points[corners[2]] - p;
  const Vec3 c = interior.points[corners[3]] - p;
  const double longest =
      std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm(), (b - a).squaredNorm(),
                          (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return !(std::abs(a.dot(b.cross(c))) > kLeastVolume * longest * longest * longest);
}

/// Puts the Voronoi vertices of flat tetrahedra between those of their neighbours, where exact
/// arithmetic would have them, in rounds outward; at the centroid if no neighbour has a place.
inline void place_flat_tetrahedra(const InteriorTetrahedra& interior, unsigned threads,
                                  MedialComplex& complex) {
  constexpr std::size_t kChunk = 4096;
  std::vector<char> placed(complex.vertex_count(), 1);
  parallel_for(placed.size(), threads, kChunk, [&](std::size_t t, unsigned) {
    placed[t] = is_flat(interior, to_index(t)) ? 0 : 1;
  });
  std::vector<Index> open;
  for (Index t = 0; t < complex.vertex_count(); ++t) {
    if (placed[t] == 0) open.push_back(t);
  }
  while (!open.empty()) {
    std::vector<Index> settled;
    std::vector<Index> still_open;
    for (const Index t : open) {
      Vec3 sum = Vec3::Zero();
      int count = 0;
      for (const Index neighbour : interior.neighbours[t]) {
        if (neighbour == kNone || placed[neighbour] == 0) continue;
        sum += complex.position[neighbour];
        ++count;
      }
      if (count > 0) complex.position[t] = sum / count;
      (count > 0 ? settled : still_open).push_back(t);
    }
    for (const Index t : settled) placed[t] = 1;
    if (settled.empty()) {
      for (const Index t : still_open) complex.position[t] = tetrahedron_centroid(interior, t);
      still_open.clear();
    }
    open = std::move(still_open);
  }
}

/// Distance from a Voronoi vertex to the nearest of its four contacts.
inline double contact_distance(const InteriorTetrahedra& interior, const MedialComplex& complex,
                               Index t) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Index corner : interior.tetrahedra[t]) {
    nearest = std::min(nearest, (interior.points[corner] - complex.position[t]).norm());
  }
  return nearest;
}

}  // namespace detail

/// Moves each Voronoi vertex that its tetrahedron's centroid can't see inside the shape, as it lies
/// outside or on the surface, back along the line of sight, to nine tenths of what can be seen, and
/// marks it as displaced. Afterwards every vertex is finite and inside T'. Cost: one short walk a
/// vertex. The same for any number of `threads` (0: all).
inline void place_voronoi_vertices(const InteriorTetrahedra& interior, MedialComplex& complex,
                                   unsigned threads = 0) {
  constexpr double kKeptShare = 0.9;
  constexpr std::size_t kStepLimit = 1000;
  constexpr std::size_t kChunk = 1024;
  threads = thread_count(threads);
  detail::place_flat_tetrahedra(interior, threads, complex);
  const double far_away = 2.0 * bounding_box_diagonal(interior.points);
  parallel_for(complex.vertex_count(), threads, kChunk, [&](std::size_t i, unsigned) {
    const Index t = to_index(i);
    const Vec3 centroid = tetrahedron_centroid(interior, t);
    Vec3& position = complex.position[t];
    const double distance = (position - centroid).norm();
    double share = 0.0;          // of the way there that can be seen
    if (distance <= far_away) {  // false for a circumcentre that is not finite
      share = detail::visible_share(interior, t, centroid, position, kStepLimit);
    }
    if (std::isfinite(share)) {
      position =
          share > 0.0 ? Vec3(centroid + kKeptShare * share * (position - centroid)) : centroid;
      complex.displaced[t] = 1;
    }
    complex.radius[t] = detail::contact_distance(interior, complex, t);
  });
}

}  // namespace mgf
