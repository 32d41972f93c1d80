// SPDX-License-Identifier: GPL-3.0-or-later
// From paths that are locally shortest to paths that are proven shortest.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/landmark_search.h"
#include "vcg_ext/geodesics/landmarks.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/pair_paths.h"
#include "vcg_ext/geodesics/path_lookup.h"
#include "vcg_ext/geodesics/path_shortening.h"
#include "vcg_ext/geodesics/search_surface.h"
#include "vcg_ext/geodesics/vertex_cover.h"
#include "vcg_ext/geodesics/window_propagation.h"

namespace mgf {

/// Shortcuts of the certificate; the answer is the same with any of them.
struct CertificateOptions {
  PropagationPruning pruning;
  double epsilon = 0.0;  ///< if more than 0, only paths shorter than those known by more
                         ///< than the factor 1 + epsilon are searched for
};

namespace detail {

/// What one thread needs to certify.
class Certifier {
 public:
  /// `landmarks` are on the search surface; all but the options must outlive the certifier.
  Certifier(const HalfedgeMesh& mesh, const SearchSurface& search, const Landmarks& landmarks,
            const CertificateOptions& options)
      : mesh_(mesh),
        search_(search),
        allowance_(1.0 + options.epsilon),
        proving_(search.mesh(), options.pruning, &landmarks),
        lookup_(mesh, search, options.pruning),
        shortener_(mesh) {}

  /// Proves or repairs the paths of `served`, all of which have `start` at one end.
  void certify(Index start, Row<Index> served, const std::vector<VertexPair>& pairs,
               PairPaths& paths) {
    const auto end_of = [&](Index id) { return pairs[id].a == start ? pairs[id].b : pairs[id].a; };
    proving_targets_.clear();
    for (const Index id : served) {
      const double known = paths.length[id];
      proving_targets_.push_back({search_.place(end_of(id)), known, known / allowance_});
    }
    const bool is_complete = proving_.run(search_.place(start), proving_targets_);
    windows_ += proving_.window_count();
    for (std::size_t slot = 0; slot < served.size(); ++slot) {
      settle(start, slot, served[slot], pairs[served[slot]], is_complete, paths);
    }
  }

  /// How many windows its searches have made so far.
  std::size_t windows() const { return windows_; }

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

  /// Gives a pair the path that the last search found, in certain knowledge if the search was
  /// complete.
  void settle(Index start, std::size_t slot, Index id, const VertexPair& pair, bool is_complete,
              PairPaths& paths) {
    const double found = proving_.distance(slot);
    const double known = paths.length[id];
    // Beyond the limit the search has left out paths: what it found there proves nothing.
    const double limit = proving_targets_[slot].limit;
    const bool is_shortest = is_complete && (found <= limit || PathLookup::agree(found, limit));
    constexpr double kSame = 1e-13;  // relative; shortening gains no more
    if (is_shortest && std::abs(found - known) <= kSame * known) {
      paths.certification[id] = verdict();
      return;
    }
    if (search_.is_fine() && found < known) {
      paths.corridor[id] = corridor_from(start, pair, proving_.pieces(slot));
    }
    double length = shortener_.shorten(pair.a, pair.b, paths.corridor[id]);
    paths.tangents[id] = shortener_.tangents(pair.a, pair.b, paths.corridor[id]);
    const Index end = pair.a == start ? pair.b : pair.a;
    if (!PathLookup::agree(found, length) && found < length &&
        lookup_.run(start, end, found, proving_.pieces(slot))) {
      std::vector<Index> corridor = corridor_from(start, pair, lookup_.pieces());
      const double shorter = shortener_.shorten(pair.a, pair.b, corridor);
      if (shorter < length) {
        length = shorter;
        paths.tangents[id] = shortener_.tangents(pair.a, pair.b, corridor);
        paths.corridor[id] = std::move(corridor);
      }
    }
    paths.length[id] = length;
    if (is_shortest && PathLookup::agree(found, length)) paths.certification[id] = verdict();
    if (is_complete && !is_shortest) paths.certification[id] = verdict_beyond_limit();
    if (length < known - 0.5 * mesh_.mean_edge) improved_.push_back(id);
  }

  /// The corridor of a path found from `start`, from the pair's first end.
  std::vector<Index> corridor_from(Index start, const VertexPair& pair,
                                   const std::vector<PathPiece>& pieces) const {
    std::vector<Index> corridor = corridor_of_pieces(mesh_, pieces);
    return start == pair.a ? corridor : reversed_corridor(mesh_, corridor);
  }

  const HalfedgeMesh& mesh_;
  const SearchSurface& search_;
  double allowance_;           ///< 1 + epsilon
  WindowPropagation proving_;  ///< on the search surface
  PathLookup lookup_;
  PathShortener shortener_;
  std::vector<PropagationTarget> proving_targets_;
  std::vector<Index> improved_;
  std::size_t windows_ = 0;
};

}  // namespace detail

/// Replaces paths that aren't shortest by ones that are, and marks as proven what an exhaustive
/// search has confirmed. A pair whose search had to be given up for its size keeps its path and its
/// mark. The result is independent of the number of threads.
class PathCertificate {
 public:
  /// Searches run on `search`, which is made from `mesh`; all arguments but that must outlive the
  /// certificate.
  PathCertificate(const HalfedgeMesh& mesh, SearchSurface search,
                  const std::vector<VertexPair>& pairs, unsigned threads,
                  const CertificateOptions& options, PairPaths& paths)
      : mesh_(mesh),
        pairs_(pairs),
        options_(options),
        paths_(paths),
        search_(std::move(search)),
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

  /// Places landmarks if by the searches done so far they will save more than they take: with a
  /// fifth of the windows that those still to be done would make. Returns how many there are.
  std::size_t use_landmarks(const Progress& progress) {
    constexpr double kShare = 0.2;
    const auto done = static_cast<double>(std::count(done_.begin(), done_.end(), char{1}));
    if (done == 0.0) return 0;
    std::size_t windows = 0;
    for (const auto& certifier : certifiers_) windows += certifier ? certifier->windows() : 0;
    const double to_do = static_cast<double>(done_.size()) - done;
    return use_landmarks(
        static_cast<std::size_t>(kShare * static_cast<double>(windows) / done * to_do), progress);
  }

  /// Places the landmarks that `most_windows` windows suffice for. Returns how many there are.
  std::size_t use_landmarks(std::size_t most_windows, const Progress& progress) {
    landmarks_ =
        place_landmarks(search_.mesh(), most_windows, to_index(certifiers_.size()), progress);
    return landmarks_.distance.size();
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
    parallel_for(
        chosen.size(), to_index(certifiers_.size()), 4, [&](std::size_t i, unsigned worker) {
          if (worker == 0 && i >= next_report) {
            progress.report(static_cast<double>(i) / static_cast<double>(chosen.size()),
                            "Proving geodesics");
            next_report = i + step;
          }
          auto& certifier = certifiers_[worker];
          if (!certifier) {
            certifier = std::make_unique<detail::Certifier>(mesh_, search_, landmarks_, options_);
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
  SearchSurface search_;
  Landmarks landmarks_;
  SearchPlan plan_;
  std::vector<char> done_;                                      ///< one per search
  std::vector<std::unique_ptr<detail::Certifier>> certifiers_;  ///< one per thread
};

}  // namespace mgf
