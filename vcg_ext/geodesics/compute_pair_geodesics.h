// SPDX-License-Identifier: GPL-3.0-or-later
// Exact shortest paths between many near pairs of vertices: guess paths, then prove or repair them.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/coherent_paths.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/pair_paths.h"
#include "vcg_ext/geodesics/path_certificate.h"
#include "vcg_ext/geodesics/search_surface.h"
#include "vcg_ext/geodesics/spatial_numbering.h"

namespace mgf {

/// A surface made ready for geodesics.
struct GeodesicSurface {
  /// As `make_halfedge_mesh`.
  explicit GeodesicSurface(const TriangleSurface& surface)
      : numbering(surface), mesh(make_halfedge_mesh(numbering.surface())) {}

  SpatialNumbering numbering;
  HalfedgeMesh mesh;  ///< of the surface in that numbering
};

namespace detail {

/// The answer, in the caller's numbers, from the paths.
inline PairGeodesics finish_geodesics(const GeodesicSurface& surface, const PairNumbering& question,
                                      unsigned threads, PairPaths paths) {
  const std::size_t count = paths.length.size();
  PairGeodesics result;
  result.length.resize(count);
  result.certification.resize(count);
  result.tangent_a.assign(count, Vec3::Zero());
  result.tangent_b.assign(count, Vec3::Zero());
  parallel_for(count, thread_count(threads), 1024, [&](std::size_t i, unsigned) {
    const Index pair = question.pair_number(to_index(i));
    result.length[i] = paths.length[pair];
    result.certification[i] = paths.certification[pair];
    if (!paths.has(pair)) return;
    std::vector<Index>& corridor = paths.corridor[pair];
    result.tangent_a[i] = paths.tangents[pair][0];
    result.tangent_b[i] = paths.tangents[pair][1];
    if (question.is_turned(to_index(i))) {
      std::swap(result.tangent_a[i], result.tangent_b[i]);
      corridor = reversed_corridor(surface.mesh, corridor);
    }
    for (Index& h : corridor) h = surface.numbering.original_halfedge(h);
  });
  for (Index i = 0; i < count; ++i) {
    const std::vector<Index>& corridor = paths.corridor[question.pair_number(i)];
    result.corridor.items.insert(result.corridor.items.end(), corridor.begin(), corridor.end());
    result.corridor.close_row();
  }
  return result;
}

}  // namespace detail

/// Shortest paths on `surface` between the two vertices of each of `pairs`.
///
/// surface: closed, oriented, edge- and vertex-manifold; several shells are fine.
/// pairs: distinct, a < b, of vertices with faces. A pair on two shells gets infinite length.
/// links: triples of pairs that are the sides (u,v), (v,w), (u,w) of a triangle of vertices (kNone
/// for a side that is no pair), along which paths are carried on; only speed depends on them.
/// Throws `InputError` if the surface isn't as required, `Cancelled` if the user stops.
/// The result does not depend on the number of threads.
inline PairGeodesics compute_pair_geodesics(const GeodesicSurface& surface,
                                            const std::vector<VertexPair>& pairs,
                                            const std::vector<std::array<Index, 3>>& links,
                                            const GeodesicOptions& options,
                                            const Progress& progress = {}) {
  const PairNumbering question(surface.numbering, pairs, links);
  const HalfedgeMesh& mesh = surface.mesh;
  PairPaths paths(pairs.size());
  const bool is_proving = options.wanted != Certification::kUnproven;
  // What is to be proven needs but a bound before: a quarter of an edge too long costs nothing.
  CoherentPaths carrier(mesh, question.pairs(), question.links(),
                        is_proving ? ShorteningEffort::kRough : ShorteningEffort::kFull,
                        options.threads, paths);
  std::optional<SearchSurface> search;
  parallel_beside(
      options.threads, [&] { carrier.run(progress.slice(0.0, 0.3)); },
      [&] {
        if (is_proving) search.emplace(surface.numbering.surface(), mesh);
      });
  if (is_proving) {
    CertificateOptions certificate_options;
    if (options.wanted == Certification::kWithin) certificate_options.epsilon = options.epsilon;
    PathCertificate certificate(mesh, *std::move(search), question.pairs(), options.threads,
                                certificate_options, paths);
    // What a sample of the searches repairs is carried on first: paths of a wrong class come in
    // islands, and each makes its search dear.
    constexpr std::size_t kSample = 32;
    const std::vector<Index> improved = certificate.run(kSample, progress.slice(0.3, 0.35));
    carrier.carry_on(improved, progress.slice(0.35, 0.4));
    certificate.use_landmarks(progress.slice(0.4, 0.45));
    certificate.run(1, progress.slice(0.45, 0.95));
  }
  progress.report(0.95, "Measuring geodesics");
  return detail::finish_geodesics(surface, question, options.threads, std::move(paths));
}

inline PairGeodesics compute_pair_geodesics(const TriangleSurface& surface,
                                            const std::vector<VertexPair>& pairs,
                                            const std::vector<std::array<Index, 3>>& links,
                                            const GeodesicOptions& options,
                                            const Progress& progress = {}) {
  return compute_pair_geodesics(GeodesicSurface(surface), pairs, links, options, progress);
}

}  // namespace mgf
