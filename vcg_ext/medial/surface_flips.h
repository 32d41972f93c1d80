// SPDX-License-Identifier: GPL-3.0-or-later
// From T to T': edge flips that bring the input surface nearer to the Delaunay tetrahedralisation.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/constrained_surface.h"
#include "vcg_ext/medial/face_lookup.h"
#include "vcg_ext/medial/isotopy_guard.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// Flips edges of a closed manifold surface, each by an isotopy. The surface's topology stays: a
/// flip never doubles an edge.
class SurfaceFlipper {
 public:
  SurfaceFlipper(const std::vector<Vec3>& points, ConstrainedSurface& surface)
      : points_(points),
        surface_(surface),
        guard_(points, surface),
        queued_(surface.faces().size(), 0) {}

  /// Flips edges between coplanar faces until they're Delaunay within their plane, which keeps T as
  /// a set. Returns the number of flips.
  Index flip_coplanar() {
    for (Index f = 0; f < surface_.faces().size(); ++f) enqueue(f);
    return run(
        1, [&](const EdgePair& e, unsigned) { return is_flat(e) && is_not_delaunay(e); },
        [](const EdgePair&) {});
  }

  /// Flips edges so that more of the surface's faces and edges are in `delaunay`, a mesh of the
  /// same points. No normal turns by more than 30 degrees. Returns the number of flips.
  Index flip_towards(const TetrahedralMesh& delaunay, unsigned threads = 1) {
    parent_normal_.clear();
    for (const Triangle& face : surface_.faces()) parent_normal_.push_back(normal(face));
    is_present_.assign(surface_.faces().size(), 1);
    for (const Index f : missing_faces(delaunay, surface_.faces(), threads)) {
      is_present_[f] = 0;
      enqueue(f);
    }
    std::vector<MeshWalk> walks(threads);
    const auto is_wanted = [&](EdgePair& e, unsigned worker) {  // the quickest question first
      return lacks_face(e) && is_gentle(e) && gains(delaunay, walks[worker], e);
    };
    return run(threads, is_wanted, [&](const EdgePair& e) {
      is_present_[e.f] = e.has_cad;
      is_present_[e.g] = e.has_dbc;
    });
  }

  /// After `flip_towards`, the faces that the mesh still doesn't have, ascending.
  std::vector<Index> missing() const {
    std::vector<Index> result;
    for (Index f = 0; f < is_present_.size(); ++f) {
      if (is_present_[f] == 0) result.push_back(f);
    }
    return result;
  }

 private:
  static constexpr double kFlatSine = 5e-4;          // two faces within 0.03 degrees are coplanar
  static constexpr double kGuardCosine = 0.8660254;  // normals may differ by 30 degrees
  static constexpr int kSweeps = 6;

  // The two faces at an edge ab: f = abc, g = bad.
  struct EdgePair {
    Index f, g, a, b, c, d;
    char has_cad = 0;  // whether the mesh has the faces that a flip would make; by `gains`
    char has_dbc = 0;

    bool is_still(const EdgePair& o) const {
      return f == o.f && g == o.g && a == o.a && b == o.b && c == o.c && d == o.d;
    }
  };

  Vec3 normal(Index a, Index b, Index c) const {
    return (points_[b] - points_[a]).cross(points_[c] - points_[a]);
  }
  Vec3 normal(const Triangle& t) const { return normal(t[0], t[1], t[2]); }

  void enqueue(Index f) {
    if (queued_[f] != 0) return;
    queued_[f] = 1;
    queue_.push_back(f);
  }

  // Offers the edges of queued faces to `wanted` and flips those it accepts, sweep by sweep, the
  // longest first: flips compete, and lengths don't change when the shape is turned. Calls
  // `flipped` for each. `wanted` may be asked by `threads` workers at once.
  template <class Wanted, class Flipped>
  Index run(unsigned threads, const Wanted& wanted, const Flipped& flipped) {
    Index flips = 0;
    for (int sweep = 0; sweep < kSweeps && !queue_.empty(); ++sweep) {
      for (const Candidate& candidate : candidates(threads, wanted)) {
        EdgePair e{};
        if (!pair_at(candidate.pair.f, candidate.pair.a, candidate.pair.b, e)) continue;
        if (e.is_still(candidate.pair)) {
          e = candidate.pair;
        } else if (!wanted(e, 0)) {
          continue;
        }
        if (surface_.has_edge(e.c, e.d)) continue;
        if (!guard_.allows(e.f, e.g, e.a, e.b, e.c, e.d)) continue;
        flip(e);
        flipped(e);
        ++flips;
      }
    }
    for (const Index f : queue_) queued_[f] = 0;
    queue_.clear();
    return flips;
  }

  // To be flipped.
  struct Candidate {
    double squared_length;  // of the edge
    EdgePair pair;
  };

  // The wanted edges of the queued faces in the order of flipping; empties the queue.
  template <class Wanted>
  std::vector<Candidate> candidates(unsigned threads, const Wanted& wanted) {
    constexpr std::size_t kChunk = 64;
    std::vector<std::vector<Candidate>> found(threads);  // by each worker
    parallel_for(queue_.size(), threads, kChunk, [&](std::size_t i, unsigned worker) {
      const Index f = queue_[i];
      const Triangle& face = surface_.face(f);
      for (unsigned side = 0; side < 3; ++side) {
        EdgePair e{};
        if (!pair_at(f, face[side], face[(side + 1) % 3], e)) continue;
        const bool is_others = queued_[e.g] != 0 && e.g < f;
        if (is_others || !wanted(e, worker)) continue;
        found[worker].push_back({(points_[e.b] - points_[e.a]).squaredNorm(), e});
      }
    });
    for (const Index f : queue_) queued_[f] = 0;
    queue_.clear();
    std::vector<Candidate> result;
    for (const auto& some : found) result.insert(result.end(), some.begin(), some.end());
    std::sort(result.begin(), result.end(), [](const Candidate& x, const Candidate& y) {
      return std::tuple(-x.squared_length, x.pair.f, x.pair.a) <
             std::tuple(-y.squared_length, y.pair.f, y.pair.a);
    });
    return result;
  }

  // The flippable pair at the side of f from a to b; false if f hasn't it or the pair is none.
  bool pair_at(Index f, Index a, Index b, EdgePair& e) const {
    const Triangle& face = surface_.face(f);
    std::size_t i = 0;
    while (i < 3 && (face[i] != a || face[(i + 1) % 3] != b)) ++i;
    if (i == 3) return false;
    e = {f, kNone, a, b, face[(i + 2) % 3], kNone};
    for (const Index g : surface_.faces_at(a)) {
      if (g == f || !ConstrainedSurface::has_corner(surface_.face(g), b)) continue;
      if (e.g != kNone) return false;
      e.g = g;
    }
    if (e.g == kNone) return false;
    e.d = ConstrainedSurface::third_corner(surface_.face(e.g), a, b);
    return e.c != e.d;
  }

  void flip(const EdgePair& e) {
    surface_.flip_edge(e.f, e.g, e.a, e.b);
    guard_.flipped(e.f, e.g);
    for (const Index f : {e.f, e.g}) {
      enqueue(f);
      const Triangle face = surface_.face(f);
      for (unsigned i = 0; i < 3; ++i) {
        for (const Index g : surface_.faces_at_edge(face[i], face[(i + 1) % 3])) enqueue(g);
      }
    }
  }

  bool is_flat(const EdgePair& e) const {
    const Vec3 m = normal(e.a, e.b, e.c);
    const Vec3 n = normal(e.b, e.a, e.d);
    const double scale = m.norm() * n.norm();
    return m.dot(n) > 0.0 && m.cross(n).norm() <= kFlatSine * scale;
  }

  // The angles opposite the edge sum to more than pi, the flip keeps both faces' side, and the edge
  // is new.
  bool is_not_delaunay(const EdgePair& e) const {
    const double excess = cotangent(e.c, e.a, e.b) + cotangent(e.d, e.a, e.b);
    if (!(excess < -1e-9)) return false;
    const Vec3 m = normal(e.a, e.b, e.c) + normal(e.b, e.a, e.d);
    return normal(e.c, e.a, e.d).dot(m) > 0.0 && normal(e.d, e.b, e.c).dot(m) > 0.0 &&
           !surface_.has_edge(e.c, e.d);
  }

  double cotangent(Index corner, Index a, Index b) const {
    const Vec3 u = points_[a] - points_[corner];
    const Vec3 v = points_[b] - points_[corner];
    return u.dot(v) / u.cross(v).norm();
  }

  bool lacks_face(const EdgePair& e) const {
    return is_present_[e.f] == 0 || is_present_[e.g] == 0;
  }

  bool gains(const TetrahedralMesh& mesh, MeshWalk& walk, EdgePair& e) const {
    const int before = is_present_[e.f] + is_present_[e.g];
    if (surface_.has_edge(e.c, e.d)) return false;
    bool has_edge = false;
    e.has_cad = 0;
    e.has_dbc = 0;
    mesh.visit_star(e.c, walk, [&](const Tetrahedron& t) {
      if (corner_index(t, e.d) == 4) return;
      has_edge = true;
      if (corner_index(t, e.a) < 4) e.has_cad = 1;
      if (corner_index(t, e.b) < 4) e.has_dbc = 1;
    });
    if (!has_edge) return false;
    const int after = e.has_cad + e.has_dbc;
    return after > before || (after == 0 && before == 0 && mesh.find_edge(e.a, e.b, walk) == kNone);
  }

  // Old, new and original normals all within the guard angle of each other.
  bool is_gentle(const EdgePair& e) const {
    const Vec3 normals[6] = {normal(e.a, e.b, e.c), normal(e.b, e.a, e.d), normal(e.c, e.a, e.d),
                             normal(e.d, e.b, e.c), parent_normal_[e.f],   parent_normal_[e.g]};
    double lengths[6];
    for (int i = 0; i < 6; ++i) {
      lengths[i] = normals[i].norm();
      for (int j = 0; j < i; ++j) {
        if (normals[i].dot(normals[j]) < kGuardCosine * lengths[i] * lengths[j]) {
          return false;
        }
      }
    }
    return true;
  }

  const std::vector<Vec3>& points_;
  ConstrainedSurface& surface_;
  IsotopyGuard guard_;
  std::vector<Vec3> parent_normal_;  // of the face that each face was before `flip_towards`
  std::vector<char> is_present_;     // of each face, whether the mesh has it; `flip_towards`
  std::vector<char> queued_;
  std::vector<Index> queue_;
};

/// A surface with flat edges flipped.
struct FlatFlipped {
  ConstrainedSurface surface;
  Index flips = 0;
};

/// `faces`, with corners numbered as `points`, after `SurfaceFlipper::flip_coplanar`.
inline FlatFlipped flip_flat_edges(const std::vector<Vec3>& points,
                                   const std::vector<Triangle>& faces) {
  FlatFlipped result{ConstrainedSurface(points.size(), faces)};
  result.flips = SurfaceFlipper(points, result.surface).flip_coplanar();
  return result;
}

}  // namespace mgf
