// SPDX-License-Identifier: GPL-3.0-or-later
// From paths that are locally shortest to paths that are proven shortest.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/flat_vertices.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/pair_paths.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/vertex_cover.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf {

/// Shortcuts of the certificate; the answer is the same with any of them.
struct CertificateOptions {
  PropagationPruning pruning;
  bool skip_flat_vertices = true;  ///< search on a triangulation without them
};

namespace detail {

/// The surface that searches run on, with each vertex of the fine surface located on it.
struct SearchSurface {
  HalfedgeMesh mesh;
  std::vector<SurfacePlace> places;
};

inline SearchSurface make_search_surface(const TriangleSurface& fine, bool skip_flat_vertices) {
  SearchSurface search;
  if (skip_flat_vertices) {
    const CoarseSurface coarse = without_flat_vertices(fine);
    search.mesh = make_halfedge_mesh(coarse.surface);
    search.places = places_on_coarse(fine, coarse, search.mesh);
    return search;
  }
  search.mesh = make_halfedge_mesh(fine);
  for (Index v = 0; v < fine.points.size(); ++v) {
    search.places.push_back(place_of_vertex(search.mesh, v));
  }
  return search;
}

/// What one thread needs to certify.
class Certifier {
 public:
  Certifier(const HalfedgeMesh& mesh, const SearchSurface& search,
            const PropagationPruning& pruning)
      : mesh_(mesh),
        search_(search),
        proving_(search.mesh, pruning),
        repairing_(mesh, pruning),
        funnel_(mesh),
        slack_(1e-9 * mesh.mean_edge) {}

  /// Proves or repairs the paths of `served`, all of which have `start` at one end.
  void certify(Index start, Row<Index> served, const std::vector<VertexPair>& pairs,
               PairPaths& paths) {
    const auto end_of = [&](Index id) { return pairs[id].a == start ? pairs[id].b : pairs[id].a; };
    targets_.clear();
    for (const Index id : served) {
      targets_.push_back({search_.places[end_of(id)], paths.length[id]});
    }
    if (!proving_.run(search_.places[start], targets_)) return;
    targets_.clear();
    shorter_.clear();
    for (std::size_t slot = 0; slot < served.size(); ++slot) {
      const Index id = served[slot];
      const double found = proving_.distance(slot);
      if (agree(found, paths.length[id])) {
        paths.certification[id] = Certification::kProven;
      } else if (found < paths.length[id]) {
        targets_.push_back({place_of_vertex(mesh_, end_of(id)), found + slack_});
        shorter_.push_back(id);
      }
    }
    if (!shorter_.empty()) repair(start, pairs, paths);
  }

 private:
  bool agree(double found, double length) const {
    return std::abs(found - length) <= slack_ + 1e-12 * length;
  }

  /// Searches again on the surface itself, now with a close bound, for the paths known to exist.
  void repair(Index start, const std::vector<VertexPair>& pairs, PairPaths& paths) {
    if (!repairing_.run(place_of_vertex(mesh_, start), targets_)) return;
    for (std::size_t slot = 0; slot < shorter_.size(); ++slot) {
      const Index id = shorter_[slot];
      if (!(repairing_.distance(slot) < paths.length[id])) continue;
      std::vector<Index> corridor = corridor_of_pieces(mesh_, repairing_.pieces(slot));
      if (start != pairs[id].a) corridor = reversed_corridor(mesh_, corridor);
      paths.length[id] = funnel_.straighten(pairs[id].a, pairs[id].b, corridor);
      paths.corridor[id] = std::move(corridor);
      if (agree(repairing_.distance(slot), paths.length[id])) {
        paths.certification[id] = Certification::kProven;
      }
    }
  }

  const HalfedgeMesh& mesh_;
  const SearchSurface& search_;
  WindowPropagation proving_;    ///< on the search surface
  WindowPropagation repairing_;  ///< on the surface itself
  Funnel funnel_;
  double slack_;
  std::vector<PropagationTarget> targets_;
  std::vector<Index> shorter_;  ///< pairs that have a shorter path than the one known
};

}  // namespace detail

/// Replaces each path that isn't shortest by one that is, and marks as proven what an exhaustive
/// search has confirmed. A pair whose search had to be given up for its size keeps its path and its
/// mark. `mesh` is that of `surface`. Result independent of the number of threads.
inline void certify_paths(const TriangleSurface& surface, const HalfedgeMesh& mesh,
                          const std::vector<VertexPair>& pairs, unsigned threads,
                          const CertificateOptions& options, const Progress& progress,
                          PairPaths& paths) {
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
  const detail::SearchSurface search =
      detail::make_search_surface(surface, options.skip_flat_vertices);

  threads = thread_count(threads);
  std::vector<std::unique_ptr<detail::Certifier>> certifiers(threads);
  constexpr std::size_t kSteps = 64;  // of progress
  for (std::size_t step = 0; step < kSteps; ++step) {
    progress.report(static_cast<double>(step) / kSteps, "Proving geodesics");
    const std::size_t first = plan.starts.size() * step / kSteps;
    const std::size_t last = plan.starts.size() * (step + 1) / kSteps;
    parallel_for(last - first, threads, 4, [&](std::size_t i, unsigned worker) {
      auto& certifier = certifiers[worker];
      if (!certifier) {
        certifier = std::make_unique<detail::Certifier>(mesh, search, options.pruning);
      }
      certifier->certify(plan.starts[first + i], plan.pairs[first + i], pairs, paths);
    });
  }
}

}  // namespace mgf
