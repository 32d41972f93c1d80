// SPDX-License-Identifier: GPL-3.0-or-later
// Exact shortest paths between many near pairs of vertices: guess paths, then prove or repair them.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/edge_paths.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/path_certificate.h"

namespace mgf {

namespace detail {

/// The shortest edge path of each pair, straightened within its corridor.
inline PairPaths guess_paths(const HalfedgeMesh& mesh, const std::vector<VertexPair>& pairs,
                             unsigned threads) {
  PairPaths paths;
  paths.length.assign(pairs.size(), std::numeric_limits<double>::infinity());
  paths.corridor.resize(pairs.size());
  paths.certification.assign(pairs.size(), Certification::kUnproven);
  struct Workspace {
    explicit Workspace(const HalfedgeMesh& mesh) : search(mesh), funnel(mesh) {}
    EdgeSearch search;
    Funnel funnel;
  };
  threads = thread_count(threads);
  std::vector<std::unique_ptr<Workspace>> workspaces(threads);
  parallel_for(pairs.size(), threads, 64, [&](std::size_t i, unsigned worker) {
    auto& work = workspaces[worker];
    if (!work) work = std::make_unique<Workspace>(mesh);
    const auto [a, b] = pairs[i];
    const std::vector<Index> vertices = work->search.run(a, b);
    if (vertices.empty()) return;
    paths.corridor[i] = corridor_of_vertices(mesh, vertices);
    paths.length[i] = work->funnel.straighten(a, b, paths.corridor[i]);
  });
  return paths;
}

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
  (void)links;
  const HalfedgeMesh mesh = make_halfedge_mesh(surface);
  progress.report(0.0, "Finding geodesics");
  PairPaths paths = detail::guess_paths(mesh, pairs, options.threads);
  if (options.wanted != Certification::kUnproven) {
    certify_paths(mesh, pairs, options.threads, PropagationPruning{}, progress.slice(0.3, 0.95),
                  paths);
  }
  progress.report(0.95, "Finding geodesics");
  return detail::finish_geodesics(mesh, pairs, std::move(paths));
}

}  // namespace mgf
