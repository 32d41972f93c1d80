// SPDX-License-Identifier: GPL-3.0-or-later
// From paths that are locally shortest to paths that are proven shortest.
#pragma once

#include <memory>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/vertex_cover.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf {

/// A path for each pair, and what is known of it.
struct PairPaths {
  std::vector<double> length;                ///< of the shortest path in the corridor; infinity if
                                             ///< the ends are on different shells
  std::vector<std::vector<Index>> corridor;  ///< from a to b, see corridor.h
  std::vector<Certification> certification;
};

namespace detail {

/// What one thread needs to certify.
struct CertificateWorkspace {
  CertificateWorkspace(const HalfedgeMesh& mesh, PropagationPruning pruning)
      : windows(mesh, pruning), funnel(mesh) {}
  WindowPropagation windows;
  Funnel funnel;
  std::vector<PropagationTarget> targets;
};

/// Takes over what a finished search from `start` found for one pair.
inline void settle_pair(const HalfedgeMesh& mesh, const VertexPair& pair, Index id, Index start,
                        std::size_t slot, CertificateWorkspace& work, PairPaths& paths) {
  const double found = work.windows.distance(slot);
  const double slack = 1e-9 * mesh.mean_edge + 1e-12 * found;
  if (found < paths.length[id] - slack) {
    std::vector<Index> corridor = corridor_of_pieces(mesh, work.windows.pieces(slot));
    if (start != pair.a) corridor = reversed_corridor(mesh, corridor);
    paths.length[id] = work.funnel.straighten(pair.a, pair.b, corridor);
    paths.corridor[id] = std::move(corridor);
  }
  // The search must have met a path as short as the one that bounded it.
  if (found <= paths.length[id] + slack && paths.length[id] <= found + slack) {
    paths.certification[id] = Certification::kProven;
  }
}

}  // namespace detail

/// Replaces each path that isn't shortest by one that is, and marks as proven what an exhaustive
/// search has confirmed. A pair whose search had to be given up for its size keeps its path and its
/// mark. Result independent of the number of threads.
inline void certify_paths(const HalfedgeMesh& mesh, const std::vector<VertexPair>& pairs,
                          unsigned threads, const PropagationPruning& pruning,
                          const Progress& progress, PairPaths& paths) {
  std::vector<double> weight(pairs.size(), 0.0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double straight = (mesh.points[pairs[i].a] - mesh.points[pairs[i].b]).norm();
    if (!(paths.length[i] < std::numeric_limits<double>::infinity())) continue;
    if (paths.length[i] <= straight * (1.0 + 1e-12)) {
      paths.certification[i] = Certification::kProven;
    } else {
      weight[i] = paths.length[i] * paths.length[i];
    }
  }
  const SearchPlan plan = plan_searches(pairs, weight, mesh.vertex_count());

  threads = thread_count(threads);
  std::vector<std::unique_ptr<detail::CertificateWorkspace>> workspaces(threads);
  const std::size_t steps = 64;
  for (std::size_t step = 0; step < steps; ++step) {
    progress.report(static_cast<double>(step) / static_cast<double>(steps), "Proving geodesics");
    const std::size_t first = plan.starts.size() * step / steps;
    const std::size_t last = plan.starts.size() * (step + 1) / steps;
    parallel_for(last - first, threads, 4, [&](std::size_t i, unsigned worker) {
      auto& work = workspaces[worker];
      if (!work) work = std::make_unique<detail::CertificateWorkspace>(mesh, pruning);
      const Index start = plan.starts[first + i];
      const Row<Index> served = plan.pairs[first + i];
      work->targets.clear();
      for (const Index id : served) {
        work->targets.push_back(
            {pairs[id].a == start ? pairs[id].b : pairs[id].a, paths.length[id]});
      }
      if (!work->windows.run(start, work->targets)) return;
      for (std::size_t slot = 0; slot < served.size(); ++slot) {
        detail::settle_pair(mesh, pairs[served[slot]], served[slot], start, slot, *work, paths);
      }
    });
  }
}

}  // namespace mgf
