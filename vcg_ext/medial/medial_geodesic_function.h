// SPDX-License-Identifier: GPL-3.0-or-later
// The medial geodesic function and its gradient, one value per Voronoi facet (paper, section 5.2).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/radix_sort.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/compute_pair_geodesics.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/medial/medial_complex.h"

namespace mgf {

/// Vertex pairs in ascending order of (a, b), each once, with look-up by its ends.
class PairTable {
 public:
  PairTable() = default;
  /// Takes pairs a < b in any order, repeated or not. Linear time.
  explicit PairTable(const std::vector<VertexPair>& pairs) {
    std::vector<std::uint64_t> keys;
    keys.reserve(pairs.size());
    Index vertices = 0;
    for (const VertexPair& pair : pairs) {
      keys.push_back(std::uint64_t{pair.a} << 32U | pair.b);
      vertices = std::max(vertices, pair.b + 1);
    }
    pairs_.reserve(pairs.size());
    begin_.assign(std::size_t{vertices} + 1, 0);
    for (const Index i : sorted_by_key(keys)) {
      const VertexPair& pair = pairs[i];
      if (!pairs_.empty() && pairs_.back().a == pair.a && pairs_.back().b == pair.b) continue;
      pairs_.push_back(pair);
      ++begin_[std::size_t{pair.a} + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) begin_[v + 1] += begin_[v];
  }

  const std::vector<VertexPair>& pairs() const { return pairs_; }

  /// The number of the pair {u, v}, or kNone. Logarithmic in the vertex's number of pairs.
  Index find(Index u, Index v) const {
    const Index a = std::min(u, v);
    const Index b = std::max(u, v);
    if (std::size_t{a} + 1 >= begin_.size()) return kNone;
    const auto first = pairs_.begin() + begin_[a];
    const auto last = pairs_.begin() + begin_[std::size_t{a} + 1];
    const auto found = std::lower_bound(
        first, last, b, [](const VertexPair& pair, Index end) { return pair.b < end; });
    if (found == last || found->b != b) return kNone;
    return to_index(static_cast<std::size_t>(found - pairs_.begin()));
  }

 private:
  std::vector<VertexPair> pairs_;
  std::vector<Index> begin_{0};  // of each first end, and the end of the last one's
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
  return PairTable(edges);
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
  return PairTable(pairs);
}

/// The number of each facet's pair in `table`.
inline std::vector<Index> pairs_of_facets(const MedialComplex& complex, const PairTable& table) {
  std::vector<Index> pairs;
  pairs.reserve(complex.facet_count());
  for (const VertexPair& contacts : complex.facet_contacts) {
    pairs.push_back(table.find(contacts.a, contacts.b));
  }
  return pairs;
}

/// The triples of pairs along which paths are carried on: the sides of the dual triangles. The same
/// for any number of `threads`.
inline std::vector<std::array<Index, 3>> links_of_complex(const MedialComplex& complex,
                                                          const PairTable& table,
                                                          unsigned threads = 1) {
  constexpr std::size_t kChunk = 4096;
  const std::vector<Index> pair_of_facet = pairs_of_facets(complex, table);
  std::vector<std::array<Index, 3>> links(complex.edge_count());
  parallel_for(links.size(), threads, kChunk, [&](std::size_t e, unsigned) {
    const auto [a, b, c] = complex.edge_contacts[e];
    const auto [bc, ca, ab] = complex.edge_facets[e];
    const auto pair = [&](Index facet, Index u, Index v) {
      return facet != kNone ? pair_of_facet[facet] : table.find(u, v);
    };
    links[e] = {pair(ab, a, b), pair(bc, b, c), pair(ca, a, c)};
  });
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
  const unsigned threads = thread_count(options.threads);
  std::vector<std::array<Index, 3>> links;
  std::optional<GeodesicSurface> ready;
  parallel_beside(
      threads,
      [&] {
        field.table = detail::pairs_of_complex(complex, surface);
        links = detail::links_of_complex(complex, field.table, threads);
      },
      [&] { ready.emplace(surface); });
  field.geodesics = compute_pair_geodesics(*ready, field.table.pairs(), links, options, progress);

  constexpr std::size_t kChunk = 4096;
  field.mgf.resize(complex.facet_count());
  field.gradient.resize(complex.facet_count());
  parallel_for(complex.facet_count(), threads, kChunk, [&](std::size_t facet, unsigned) {
    const VertexPair& contacts = complex.facet_contacts[facet];
    const Index pair = field.table.find(contacts.a, contacts.b);
    field.mgf[facet] = field.geodesics.length[pair];
    field.gradient[facet] =
        detail::mgf_gradient(surface.points[contacts.b] - surface.points[contacts.a],
                             field.geodesics.tangent_a[pair], field.geodesics.tangent_b[pair]);
  });
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
