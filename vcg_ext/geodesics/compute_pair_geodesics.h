// SPDX-License-Identifier: GPL-3.0-or-later
// Exact shortest paths between many near pairs of vertices: guess paths, then prove or repair them.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/coherent_paths.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/funnel.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/pair_paths.h"
#include "vcg_ext/geodesics/path_certificate.h"

namespace mgf {

namespace detail {

/// The answer from the paths: tangents from each path's first and last piece.
inline PairGeodesics finish_geodesics(const HalfedgeMesh& mesh,
                                      const std::vector<VertexPair>& pairs, PairPaths paths) {
  PairGeodesics result;
  result.tangent_a.assign(pairs.size(), Vec3::Zero());
  result.tangent_b.assign(pairs.size(), Vec3::Zero());
  Funnel funnel(mesh);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (paths.length[i] < std::numeric_limits<double>::infinity()) {
      const std::vector<Index>& corridor = paths.corridor[i];
      funnel.straighten(pairs[i].a, pairs[i].b, corridor);
      result.tangent_a[i] = funnel.tangent_at_start(pairs[i].a, pairs[i].b, corridor);
      result.tangent_b[i] = funnel.tangent_at_end(pairs[i].a, pairs[i].b, corridor);
      result.corridor.items.insert(result.corridor.items.end(), corridor.begin(), corridor.end());
    }
    result.corridor.close_row();
  }
  result.length = std::move(paths.length);
  result.certification = std::move(paths.certification);
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
inline PairGeodesics compute_pair_geodesics(const TriangleSurface& surface,
                                            const std::vector<VertexPair>& pairs,
                                            const std::vector<std::array<Index, 3>>& links,
                                            const GeodesicOptions& options,
                                            const Progress& progress = {}) {
  const HalfedgeMesh mesh = make_halfedge_mesh(surface);
  PairPaths paths(pairs.size());
  CoherentPaths carrier(mesh, pairs, links, options.threads, paths);
  carrier.run(progress.slice(0.0, 0.3));
  if (options.wanted != Certification::kUnproven) {
    PathCertificate certificate(surface, mesh, pairs, options.threads, CertificateOptions{}, paths);
    // What a sample of the searches repairs is carried on first: paths of a wrong class come in
    // islands, and each makes its search dear.
    constexpr std::size_t kSample = 32;
    const std::vector<Index> improved = certificate.run(kSample, progress.slice(0.3, 0.35));
    carrier.carry_on(improved, progress.slice(0.35, 0.4));
    certificate.run(1, progress.slice(0.4, 0.95));
  }
  progress.report(0.95, "Measuring geodesics");
  return detail::finish_geodesics(mesh, pairs, std::move(paths));
}

}  // namespace mgf
