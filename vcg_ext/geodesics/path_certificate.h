// SPDX-License-Identifier: GPL-3.0-or-later
// From paths that are locally shortest to paths that are proven shortest.
#pragma once

#include <algorithm>
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
#include "vcg_ext/geodesics/path_shortening.h"
#include "vcg_ext/geodesics/surface_place.h"
#include "vcg_ext/geodesics/vertex_cover.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf {

/// Shortcuts of the certificate; the answer is the same with any of them.
struct CertificateOptions {
  PropagationPruning pruning;
  bool skip_flat_vertices = true;  ///< search on a triangulation without them
  double epsilon = 0.0;            ///< if more than 0, only paths shorter than those known by more
                                   ///< than the factor 1 + epsilon are searched for
};

namespace detail {

/// The surface that searches run on, with each vertex of the fine surface located on it.
struct SearchSurface {
  HalfedgeMesh mesh;
  bool is_fine = true;               ///< `mesh` is the fine surface itself
  std::vector<SurfacePlace> places;  ///< one per vertex of the fine surface
  std::vector<Index> fine_vertex;    ///< one per vertex of `mesh`: its number on the fine surface
  Rows<Index> parts;                 ///< one row per triangle of `mesh`: fine triangles in it
};

inline SearchSurface make_search_surface(const TriangleSurface& fine, const HalfedgeMesh& mesh,
                                         bool skip_flat_vertices) {
  SearchSurface search;
  const CoarseSurface coarse = skip_flat_vertices ? without_flat_vertices(fine) : CoarseSurface{};
  constexpr double kWorthIt = 0.9;  // paths on a coarse surface have to be found again on the fine
  if (skip_flat_vertices && static_cast<double>(coarse.surface.points.size()) <
                                kWorthIt * static_cast<double>(fine.points.size())) {
    search.is_fine = false;
    search.mesh = make_halfedge_mesh(coarse.surface);
    search.places = places_on_coarse(fine, coarse, search.mesh);
    search.fine_vertex.resize(coarse.surface.points.size());
    for (Index v = 0; v < fine.points.size(); ++v) {
      if (coarse.vertex_of[v] != kNone) search.fine_vertex[coarse.vertex_of[v]] = v;
    }
    search.parts = group_by_key(coarse.parent, coarse.surface.triangles.size());
    return search;
  }
  search.mesh = mesh;
  for (Index v = 0; v < fine.points.size(); ++v) {
    search.places.push_back(place_of_vertex(search.mesh, v));
    search.fine_vertex.push_back(v);
  }
  for (Index t = 0; t < fine.triangles.size(); ++t) {
    search.parts.items.push_back(t);
    search.parts.close_row();
  }
  return search;
}

/// What one thread needs to certify.
class Certifier {
 public:
  Certifier(const HalfedgeMesh& mesh, const SearchSurface& search,
            const CertificateOptions& options)
      : mesh_(mesh),
        search_(search),
        allowance_(1.0 + options.epsilon),
        proving_(search.mesh, options.pruning),
        searching_(mesh, options.pruning),
        shortener_(mesh),
        allowed_(mesh.triangle_count(), 0) {}

  /// Proves or repairs the paths of `served`, all of which have `start` at one end.
  void certify(Index start, Row<Index> served, const std::vector<VertexPair>& pairs,
               PairPaths& paths) {
    const auto end_of = [&](Index id) { return pairs[id].a == start ? pairs[id].b : pairs[id].a; };
    proving_targets_.clear();
    for (const Index id : served) {
      const double known = paths.length[id];
      proving_targets_.push_back({search_.places[end_of(id)], known, known / allowance_});
    }
    proving_start_ = search_.places[start];
    const bool is_complete = proving_.run(proving_start_, proving_targets_);
    for (std::size_t slot = 0; slot < served.size(); ++slot) {
      settle(start, slot, served[slot], pairs[served[slot]], is_complete, paths);
    }
  }

  /// The pairs whose paths were replaced so far.
  std::vector<Index>& improved() { return improved_; }

 private:
  /// What the last search, if complete, says of a path as long as what it found.
  Certification verdict() const {
    return proving_.met_thin_triangle() ? Certification::kPractical : Certification::kProven;
  }
  /// What it says if nothing is as short as the limit. Rounding at thin triangles may exceed
  /// epsilon.
  Certification verdict_beyond_limit() const {
    const bool has_said = allowance_ > 1.0 && !proving_.met_thin_triangle();
    return has_said ? Certification::kWithin : Certification::kUnproven;
  }

  static constexpr double kRounding = 1e-10;  // of long unfoldings; 1e-13 unless triangles are thin
  static bool agree(double found, double length) {
    return std::abs(found - length) <= kRounding * length;
  }

  /// Gives a pair the path that the last search found, in certain knowledge if the search was
  /// complete.
  void settle(Index start, std::size_t slot, Index id, const VertexPair& pair, bool is_complete,
              PairPaths& paths) {
    const double found = proving_.distance(slot);
    const double known = paths.length[id];
    // Beyond the limit the search has left out paths: what it found there proves nothing.
    const bool is_shortest =
        is_complete && found <= proving_targets_[slot].limit * (1.0 + kRounding);
    constexpr double kSame = 1e-13;  // relative; shortening gains no more
    if (is_shortest && std::abs(found - known) <= kSame * known) {
      paths.certification[id] = verdict();
      return;
    }
    if (search_.is_fine && found < known) take(start, pair, proving_, slot, paths.corridor[id]);
    double length = shortener_.shorten(pair.a, pair.b, paths.corridor[id]);
    if (!agree(found, length) && found < length && look_up(start, slot, pair)) {
      std::vector<Index> corridor;
      take(start, pair, searching_, 0, corridor);
      const double shorter = shortener_.shorten(pair.a, pair.b, corridor);
      if (shorter < length) {
        length = shorter;
        paths.corridor[id] = std::move(corridor);
      }
    }
    paths.length[id] = length;
    if (is_shortest && agree(found, length)) paths.certification[id] = verdict();
    if (is_complete && !is_shortest) paths.certification[id] = verdict_beyond_limit();
    if (length < known - 0.5 * mesh_.mean_edge) improved_.push_back(id);
  }

  /// The corridor of the path that a search on the surface itself found, from the pair's first end.
  void take(Index start, const VertexPair& pair, const WindowPropagation& search, std::size_t slot,
            std::vector<Index>& corridor) const {
    corridor = corridor_of_pieces(mesh_, search.pieces(slot));
    if (start != pair.a) corridor = reversed_corridor(mesh_, corridor);
  }

  /// Looks on the surface itself for the path that the last search proved to exist: first in the
  /// triangles about its corridor, then, should that fail, anywhere.
  bool look_up(Index start, std::size_t slot, const VertexPair& pair) {
    const double found = proving_.distance(slot);
    const Index end = pair.a == start ? pair.b : pair.a;
    targets_.assign(1, {place_of_vertex(mesh_, end), found * (1.0 + 1e-9)});
    allow_corridor(slot);
    searching_.keep_to(&allowed_);
    const bool is_found = search_for(start, found);
    for (const Index t : opened_) allowed_[t] = 0;
    searching_.keep_to(nullptr);
    return is_found || search_for(start, found);
  }

  bool search_for(Index start, double length) {
    return searching_.run(place_of_vertex(mesh_, start), targets_) &&
           agree(searching_.distance(0), length);
  }

  /// Allows the triangles in the corridor of the path found to a target, and those that touch them.
  void allow_corridor(std::size_t slot) {
    opened_.clear();
    for (const PathPiece& piece : proving_.pieces(slot)) {
      for (const Index h : piece.crossed) {
        allow_part(triangle_of(h));
        allow_part(triangle_of(search_.mesh.opposite(h)));
      }
      for (const Index end : {piece.from, piece.to}) {
        if (end != kNone) allow_about(search_.fine_vertex[end]);
      }
    }
    for (const SurfacePlace& place : {proving_start_, proving_targets_[slot].place}) {
      if (place.triangle != kNone) allow_part(place.triangle);
    }
  }

  /// Allows the surface's triangles in a triangle of the search surface.
  void allow_part(Index triangle) {
    for (const Index t : search_.parts[triangle]) {
      for (Index h = 3 * t; h < 3 * t + 3; ++h) allow_about(mesh_.tail(h));
    }
  }

  void allow_about(Index v) {
    Index h = mesh_.outgoing[v];
    do {
      const Index t = triangle_of(h);
      if (allowed_[t] == 0) opened_.push_back(t);
      allowed_[t] = 1;
      h = mesh_.rotated(h);
    } while (h != mesh_.outgoing[v]);
  }

  const HalfedgeMesh& mesh_;
  const SearchSurface& search_;
  double allowance_;             ///< 1 + epsilon
  WindowPropagation proving_;    ///< on the search surface
  WindowPropagation searching_;  ///< on the surface itself
  PathShortener shortener_;
  SurfacePlace proving_start_;
  std::vector<PropagationTarget> proving_targets_;
  std::vector<PropagationTarget> targets_;  ///< of a repair
  std::vector<char> allowed_;               ///< one per triangle: whether repairs may use it
  std::vector<Index> opened_;               ///< the triangles allowed
  std::vector<Index> improved_;
};

}  // namespace detail

/// Replaces paths that aren't shortest by ones that are, and marks as proven what an exhaustive
/// search has confirmed. A pair whose search had to be given up for its size keeps its path and its
/// mark. The result is independent of the number of threads.
class PathCertificate {
 public:
  /// `mesh` is that of `surface`; all arguments must outlive the certificate.
  PathCertificate(const TriangleSurface& surface, const HalfedgeMesh& mesh,
                  const std::vector<VertexPair>& pairs, unsigned threads,
                  const CertificateOptions& options, PairPaths& paths)
      : mesh_(mesh),
        pairs_(pairs),
        options_(options),
        paths_(paths),
        search_(detail::make_search_surface(surface, mesh, options.skip_flat_vertices)),
        certifiers_(thread_count(threads)) {
    std::vector<double> weight(pairs.size(), 0.0);
    for (Index i = 0; i < pairs.size(); ++i) {
      if (!paths.has(i)) continue;
      const double straight = (mesh.points[pairs[i].a] - mesh.points[pairs[i].b]).norm();
      if (std::abs(paths.length[i] - straight) <= 1e-12 * straight) {
        paths.certification[i] = Certification::kProven;
      } else {
        weight[i] = paths.length[i] * paths.length[i];
      }
    }
    plan_ = plan_searches(pairs, weight, mesh.vertex_count());
    done_.assign(plan_.starts.size(), 0);
  }

  /// Certifies the pairs of every `stride`-th search not yet done; 1 does all that are left.
  /// Returns the pairs whose paths were replaced.
  std::vector<Index> run(std::size_t stride, const Progress& progress) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < done_.size(); i += stride) {
      if (done_[i] == 0) chosen.push_back(i);
      done_[i] = 1;
    }
    // Reported by the caller's own thread, the first of the workers.
    const std::size_t step = chosen.size() / 64 + 1;
    std::size_t next_report = 0;
    parallel_for(chosen.size(), to_index(certifiers_.size()), 4,
                 [&](std::size_t i, unsigned worker) {
                   if (worker == 0 && i >= next_report) {
                     progress.report(static_cast<double>(i) / static_cast<double>(chosen.size()),
                                     "Proving geodesics");
                     next_report = i + step;
                   }
                   auto& certifier = certifiers_[worker];
                   if (!certifier) {
                     certifier = std::make_unique<detail::Certifier>(mesh_, search_, options_);
                   }
                   const std::size_t search = chosen[i];
                   certifier->certify(plan_.starts[search], plan_.pairs[search], pairs_, paths_);
                 });
    return take_improved();
  }

 private:
  std::vector<Index> take_improved() {
    std::vector<Index> improved;
    for (auto& certifier : certifiers_) {
      if (!certifier) continue;
      improved.insert(improved.end(), certifier->improved().begin(), certifier->improved().end());
      certifier->improved().clear();
    }
    std::sort(improved.begin(), improved.end());
    return improved;
  }

  const HalfedgeMesh& mesh_;
  const std::vector<VertexPair>& pairs_;
  CertificateOptions options_;
  PairPaths& paths_;
  detail::SearchSurface search_;
  SearchPlan plan_;
  std::vector<char> done_;                                      ///< one per search
  std::vector<std::unique_ptr<detail::Certifier>> certifiers_;  ///< one per thread
};

}  // namespace mgf
