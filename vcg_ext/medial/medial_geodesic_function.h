// SPDX-License-Identifier: GPL-3.0-or-later
// The medial geodesic function and its gradient, one value per Voronoi facet (paper, section 5.2).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/compute_pair_geodesics.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf {

/// Vertex pairs in ascending order of (a, b), each once, with look-up by its ends.
class PairTable {
 public:
  PairTable() = default;
  /// Takes pairs a < b in any order, repeated or not.
  explicit PairTable(std::vector<VertexPair> pairs) : pairs_(std::move(pairs)) {
    const auto before = [](const VertexPair& p, const VertexPair& q) {
      return p.a != q.a ? p.a < q.a : p.b < q.b;
    };
    const auto same = [](const VertexPair& p, const VertexPair& q) {
      return p.a == q.a && p.b == q.b;
    };
    std::sort(pairs_.begin(), pairs_.end(), before);
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end(), same), pairs_.end());
    std::vector<Index> first_ends;
    first_ends.reserve(pairs_.size());
    Index vertices = 0;
    for (const VertexPair& pair : pairs_) {
      first_ends.push_back(pair.a);
      vertices = std::max(vertices, pair.b + 1);
    }
    by_first_end_ = group_by_key(first_ends, vertices);
  }

  const std::vector<VertexPair>& pairs() const { return pairs_; }

  /// The number of the pair {u, v}, or kNone. Logarithmic in the vertex's number of pairs.
  Index find(Index u, Index v) const {
    const Index a = std::min(u, v);
    const Index b = std::max(u, v);
    if (a >= by_first_end_.size()) return kNone;
    const Row<Index> row = by_first_end_[a];
    const Index* const found = std::lower_bound(
        row.begin(), row.end(), b, [this](Index pair, Index end) { return pairs_[pair].b < end; });
    return found != row.end() && pairs_[*found].b == b ? *found : kNone;
  }

 private:
  std::vector<VertexPair> pairs_;
  Rows<Index> by_first_end_;
};

/// The MGF on the medial complex, and the geodesics it comes from.
struct MedialGeodesicField {
  std::vector<double> mgf;     ///< f(F), one per facet, mesh units
  std::vector<Vec3> gradient;  ///< v(F), one per facet: unit, in the facet's plane, towards larger
                               ///< f; zero where the two tangents cancel

  PairTable table;          ///< all pairs with a geodesic: those of the facets, and the sides of
                            ///< dual triangles that lie on T' but are no edge of the surface
  PairGeodesics geodesics;  ///< one per pair of the table
};

namespace detail {

/// Every edge of the triangles once, as pairs a < b.
inline PairTable surface_edges(const std::vector<Triangle>& triangles) {
  std::vector<VertexPair> edges;
  edges.reserve(triangles.size() * 3 / 2);
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = t[i];
      const Index v = t[(i + 1) % 3];
      if (u < v) edges.push_back({u, v});  // its opposite halfedge has u > v
    }
  }
  return PairTable(std::move(edges));
}

/// All pairs whose geodesic the later stages need.
inline PairTable pairs_of_complex(const MedialComplex& complex, const TriangleSurface& surface) {
  std::vector<VertexPair> pairs = complex.facet_contacts;
  const PairTable straight = surface_edges(surface.triangles);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const Triangle& dual = complex.edge_contacts[e];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = std::min(dual[(i + 1) % 3], dual[(i + 2) % 3]);
      const Index v = std::max(dual[(i + 1) % 3], dual[(i + 2) % 3]);
      if (complex.edge_facets[e][i] == kNone && straight.find(u, v) == kNone) {
        pairs.push_back({u, v});
      }
    }
  }
  return PairTable(std::move(pairs));
}

/// The triples of pairs along which paths are carried on: the sides of the dual triangles.
inline std::vector<std::array<Index, 3>> links_of_complex(const MedialComplex& complex,
                                                          const PairTable& table) {
  std::vector<std::array<Index, 3>> links;
  links.reserve(complex.edge_count());
  for (const Triangle& dual : complex.edge_contacts) {
    links.push_back(
        {table.find(dual[0], dual[1]), table.find(dual[1], dual[2]), table.find(dual[0], dual[2])});
  }
  return links;
}

/// v(F) for contacts a, b at distance vector `ab` with the path's tangents leaving them.
inline Vec3 mgf_gradient(const Vec3& ab, const Vec3& tangent_a, const Vec3& tangent_b) {
  constexpr double kCancelled = 1e-9;  // the tangents are unit vectors
  const Vec3 axis = ab.normalized();
  const Vec3 sum = tangent_a + tangent_b;
  const Vec3 in_facet = sum - axis * axis.dot(sum);
  const double norm = in_facet.norm();
  return norm > kCancelled ? Vec3(-in_facet / norm) : Vec3(Vec3::Zero());
}

}  // namespace detail

/// f and v(F) on every facet of `complex` by exact geodesics on `surface`, whose points are the
/// ones that the complex's contacts number (paper, section 5.2: both ends of the path move away
/// from each other where f grows, so the gradient is minus the projected tangents' sum).
inline MedialGeodesicField evaluate_medial_geodesic_function(const TriangleSurface& surface,
                                                             const MedialComplex& complex,
                                                             const GeodesicOptions& options,
                                                             const Progress& progress) {
  MedialGeodesicField field;
  field.table = detail::pairs_of_complex(complex, surface);
  const std::vector<std::array<Index, 3>> links = detail::links_of_complex(complex, field.table);
  field.geodesics = compute_pair_geodesics(surface, field.table.pairs(), links, options, progress);

  field.mgf.reserve(complex.facet_count());
  field.gradient.reserve(complex.facet_count());
  for (const VertexPair& contacts : complex.facet_contacts) {
    const Index pair = field.table.find(contacts.a, contacts.b);
    field.mgf.push_back(field.geodesics.length[pair]);
    field.gradient.push_back(
        detail::mgf_gradient(surface.points[contacts.b] - surface.points[contacts.a],
                             field.geodesics.tangent_a[pair], field.geodesics.tangent_b[pair]));
  }
  return field;
}

/// The distance on the surface between two corners of a dual triangle: the geodesic where there is
/// one in the table, else the straight edge of the surface between them.
inline double geodesic_distance(const MedialGeodesicField& field, const std::vector<Vec3>& points,
                                Index u, Index v) {
  const Index pair = field.table.find(u, v);
  return pair != kNone ? field.geodesics.length[pair] : (points[u] - points[v]).norm();
}

}  // namespace mgf
