// SPDX-License-Identifier: GPL-3.0-or-later
// The proof, checked: finished arrays against the hypotheses of the topology theorem.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/exact/predicates.h"
#include "vcg_ext/medial/betti.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/tetrahedral_mesh.h"

namespace mgf {

/// The same oriented triangle, smallest corner first.
inline Triangle canonical(const Triangle& t) {
  const auto lowest = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  return {t[lowest], t[(lowest + 1) % 3], t[(lowest + 2) % 3]};
}

inline std::vector<Triangle> canonical_sorted(const std::vector<Triangle>& faces) {
  std::vector<Triangle> turned;
  std::vector<std::uint64_t> keys;  // the first two corners; nearly always that tells faces apart
  turned.reserve(faces.size());
  keys.reserve(faces.size());
  for (const Triangle& face : faces) {
    turned.push_back(canonical(face));
    keys.push_back(std::uint64_t{turned.back()[0]} << 32U | turned.back()[1]);
  }
  std::vector<Triangle> sorted;
  sorted.reserve(faces.size());
  for (const Index f : sorted_by_key(keys)) {
    sorted.push_back(turned[f]);
    for (std::size_t i = sorted.size() - 1; i > 0 && sorted[i] < sorted[i - 1]; --i) {
      std::swap(sorted[i], sorted[i - 1]);
    }
  }
  return sorted;
}

/// Fills `interior.boundary` with the faces glued to nothing, outward.
inline void collect_boundary(InteriorTetrahedra& interior) {
  interior.boundary.clear();
  for (Index t = 0; t < interior.tetrahedra.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      if (interior.neighbours[t][i] != kNone) continue;
      interior.boundary.push_back(face_of(interior.tetrahedra[t], i));
    }
  }
}

namespace certificate_detail {

// Faces where t names u as its neighbour but the two don't share that face with each other.
inline Index asymmetries(const InteriorTetrahedra& interior) {
  Index count = 0;
  for (Index t = 0; t < interior.tetrahedra.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = interior.neighbours[t][i];
      if (u == kNone) continue;
      bool answered = false;
      for (unsigned j = 0; j < 4 && u < interior.tetrahedra.size(); ++j) {
        answered = answered || (interior.neighbours[u][j] == t &&
                                is_glued(interior.tetrahedra[t], i, interior.tetrahedra[u], j));
      }
      count += answered ? 0 : 1;
    }
  }
  return count;
}

inline Index not_positive(const InteriorTetrahedra& interior) {
  const std::vector<Vec3>& p = interior.points;
  Index count = 0;
  for (const Tetrahedron& t : interior.tetrahedra) {
    count += orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) <= 0 ? 1 : 0;
  }
  return count;
}

// The members of `these` that `those` hasn't; both ascending.
inline Index count_difference(const std::vector<Triangle>& these,
                              const std::vector<Triangle>& those) {
  std::vector<Triangle> difference;
  std::set_difference(these.begin(), these.end(), those.begin(), those.end(),
                      std::back_inserter(difference));
  return to_index(difference.size());
}

// Whether the arrows from first to second entry make one closed cycle through distinct places.
inline bool is_one_cycle(const std::vector<std::array<Index, 2>>& arrows) {
  std::size_t length = 0;
  Index at = arrows.front()[0];
  do {
    Index next = kNone;
    for (const auto& [from, to] : arrows) {
      if (from != at) continue;
      if (next != kNone) return false;
      next = to;
    }
    at = next;
    ++length;
  } while (at != kNone && at != arrows.front()[0] && length < arrows.size());
  return at == arrows.front()[0] && length == arrows.size();
}

// Whether each edge of `faces` has two faces that run along it in opposite directions, and the
// faces at each vertex form one fan.
inline bool is_manifold(const std::vector<Triangle>& faces, std::size_t point_count) {
  std::vector<Index> corners;
  corners.reserve(3 * faces.size());
  for (const Triangle& face : faces) corners.insert(corners.end(), face.begin(), face.end());
  const Rows<Index> corners_at = group_by_key(corners, point_count);
  std::vector<std::array<Index, 2>> fan;  // of each face at the vertex, its next corner and last
  for (Index v = 0; v < point_count; ++v) {
    fan.clear();
    for (const Index c : corners_at[v]) {
      const Triangle& face = faces[c / 3];
      fan.push_back({face[(c + 1) % 3], face[(c + 2) % 3]});
    }
    if (!fan.empty() && !is_one_cycle(fan)) return false;
  }
  return true;
}

}  // namespace certificate_detail

/// Fills the checks of `interior.certificate` that can be made on the interior alone, and the
/// verdict. `boundary` is T' as recovery left it; `expected`, `winding_conflicts` and the counts of
/// flips and points must have been filled in, and if there are exact points,
/// `tetrahedra_not_positive`, too. `embedded` says that the interior is part of a
/// triangulation of a box that `is_triangulated_box` accepts.
inline void certify(InteriorTetrahedra& interior, const std::vector<Triangle>& boundary,
                    bool embedded, unsigned threads = 1) {
  TopologyCertificate& certificate = interior.certificate;
  bool glued = false;
  bool manifold = false;
  const auto count_cells = [&] {
    glued = certificate_detail::asymmetries(interior) == 0;
    if (!glued) return;
    const GluedTopology found = glued_topology(interior.tetrahedra, interior.neighbours, threads);
    certificate.betti = found.betti;
    certificate.interior_vertices = found.inner_vertices;
  };
  const auto compare_surfaces = [&] {
    const Index flat = certificate_detail::not_positive(interior);
    (certificate.exact_points == 0 ? certificate.tetrahedra_not_positive
                                   : certificate.tetrahedra_flattened) = flat;
    const std::vector<Triangle> found = canonical_sorted(interior.boundary);
    const std::vector<Triangle> wanted = canonical_sorted(boundary);
    certificate.boundary_faces_missing = certificate_detail::count_difference(wanted, found);
    certificate.boundary_faces_extra = certificate_detail::count_difference(found, wanted);
    manifold = certificate_detail::is_manifold(found, interior.points.size());
  };
  parallel_beside(threads, count_cells, compare_surfaces);
  const bool counted = glued && certificate.betti == certificate.expected;
  const bool proven =
      counted && embedded && certificate.boundary_faces_missing == 0 &&
      certificate.boundary_faces_extra == 0 && certificate.tetrahedra_not_positive == 0 &&
      certificate.winding_conflicts == 0 && certificate.interior_vertices == 0 && manifold;
  certificate.topology = proven    ? TopologyVerdict::kProven
                         : counted ? TopologyVerdict::kCounted
                                   : TopologyVerdict::kFailed;
  // Flips are isotopies by `IsotopyGuard`; points rounded to doubles may leave the surface.
  certificate.isotopic = proven && certificate.points_added == certificate.exact_points;
}

/// Whether `mesh` is a triangulation of the box whose hull faces are `hull` triangles: adjacency
/// symmetric, every tetrahedron positive (exact). Then the map of the abstract complex into space
/// is a homeomorphism onto the box, as a local homeomorphism of degree one.
inline bool is_triangulated_box(const TetrahedralMesh& mesh, std::size_t hull) {
  std::size_t open = 0;
  for (Index t = 0; t < mesh.slot_count(); ++t) {
    if (!mesh.alive(t)) continue;
    const Tetrahedron& c = mesh.corners(t);
    if (mesh.orientation(c[0], c[1], c[2], c[3]) <= 0) return false;
    for (unsigned i = 0; i < 4; ++i) {
      const Index u = mesh.neighbour(t, i);
      if (u == kNone) {
        ++open;
        continue;
      }
      bool answered = false;
      for (unsigned j = 0; j < 4 && mesh.alive(u); ++j) {
        answered = answered || (mesh.neighbour(u, j) == t && is_glued(c, i, mesh.corners(u), j));
      }
      if (!answered) return false;
    }
  }
  return open == hull;
}

}  // namespace mgf
