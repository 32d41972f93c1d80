// SPDX-License-Identifier: GPL-3.0-or-later
// Locally shortest paths for all pairs, each carried over from a neighbour's path.
//
// Pairs are neighbours if they share an end and their other ends are near each other: the path of
// one, led on to the other's end and shortened, is a good path for the other. Starting from pairs
// that are close on the surface, paths spread in the order of their length, and again from each
// pair whose path got shorter. This carries the class of the path (which way round it goes) along
// the medial axis at the cost of a corridor's length a trial.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/geodesics/corridor.h"
#include "vcg_ext/geodesics/edge_paths.h"
#include "vcg_ext/geodesics/halfedge_mesh.h"
#include "vcg_ext/geodesics/pair_geodesics.h"
#include "vcg_ext/geodesics/pair_paths.h"
#include "vcg_ext/geodesics/path_shortening.h"

namespace mgf {

/// Finds for each pair a locally shortest path, nearly always a shortest one (see
/// compute_pair_geodesics for `links`). Pairs on different shells keep an infinite length. Rounds
/// are double-buffered: a trial reads only what was there when the round began and writes only its
/// own pair, so the threads' number and order change nothing.
class CoherentPaths {
 public:
  CoherentPaths(const HalfedgeMesh& mesh, const std::vector<VertexPair>& pairs,
                const std::vector<std::array<Index, 3>>& links, ShorteningEffort effort,
                unsigned threads, PairPaths& paths)
      : mesh_(mesh),
        pairs_(pairs),
        links_(links),
        effort_(effort),
        least_excess_(effort == ShorteningEffort::kFull ? -1.2 : 0.5),
        threads_(thread_count(threads)),
        paths_(paths),
        changed_in_(pairs.size(), kNone),
        asked_in_(pairs.size(), kNone),
        workspaces_(threads_) {
    link_pairs();
  }

  /// Finds a path for each pair that has one.
  void run(const Progress& progress) {
    start_from_close_pairs();
    do {
      spread(progress);
    } while (start_from_far_pairs());
  }

  /// Lets paths that have been replaced by shorter ones spread, to pairs not yet proven.
  void carry_on(const std::vector<Index>& improved, const Progress& progress) {
    for (const Index pair : improved) queue(pair, 0);
    spread(progress);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// The path of pair `from`, whose end is to be led from `moved` on to `end`.
  struct Trial {
    double estimate = 0.0;  ///< of the length to expect, at most
    double step = 0.0;      ///< from `moved` to `end`, straight
    Index from = kNone;
    Index shared = kNone;
    Index moved = kNone;
    Index end = kNone;
    Index third = kNone;  ///< the pair of `moved` and `end`, if it is one
    bool operator<(const Trial& o) const {
      return estimate < o.estimate || (estimate == o.estimate && from < o.from);
    }
  };
  struct Workspace {
    Workspace(const HalfedgeMesh& mesh, ShorteningEffort effort)
        : search(mesh), shortener(mesh, effort) {}
    EdgeSearch search;
    PathShortener shortener;
    std::vector<Trial> trials;
    std::vector<Index> corridor;  ///< the one tried
  };
  /// A path found for a pair in this round.
  struct Candidate {
    double length = kInfinity;
    std::vector<Index> corridor;
    std::array<Vec3, 2> tangents;
  };

  Workspace& workspace(unsigned worker) {
    if (!workspaces_[worker]) workspaces_[worker] = std::make_unique<Workspace>(mesh_, effort_);
    return *workspaces_[worker];
  }

  void link_pairs() {
    std::vector<Index> owner;
    for (const std::array<Index, 3>& link : links_) {
      for (const Index pair : link) owner.push_back(pair);
    }
    pair_links_ = group_by_key(owner, pairs_.size());
    for (Index& item : pair_links_.items) item /= 3;
  }

  // ---- first paths ----

  /// Pairs joined by an edge, or by two edges.
  void start_from_close_pairs() {
    candidates_.assign(pairs_.size(), {});
    parallel_for(pairs_.size(), threads_, 256, [&](std::size_t i, unsigned worker) {
      const auto [a, b] = pairs_[i];
      if (mesh_.outgoing[a] == kNone || mesh_.outgoing[b] == kNone) return;
      Workspace& work = workspace(worker);
      CorridorBuilder builder(mesh_, work.corridor);
      if (follow_short_way(a, b, builder))
        try_corridor(pairs_[i], to_index(i), work, candidates_[i]);
    });
    std::vector<Index> all(pairs_.size());
    std::iota(all.begin(), all.end(), 0U);
    accept(all);
  }

  /// Follows at most two edges from a to b, the shortest way; false if there is none.
  bool follow_short_way(Index a, Index b, CorridorBuilder& builder) const {
    const Index edge = find_halfedge(mesh_, a, b);
    if (edge != kNone) {
      builder.follow_edge(edge);
      return true;
    }
    std::array<Index, 2> best{kNone, kNone};
    double best_length = kInfinity;
    Index h = mesh_.outgoing[a];
    do {
      const Index on = find_halfedge(mesh_, mesh_.head(h), b);
      if (on != kNone) {
        const double length = mesh_.halfedges[h].length + mesh_.halfedges[on].length;
        if (length < best_length) best = {h, on};
        best_length = std::min(best_length, length);
      }
      h = mesh_.rotated(h);
    } while (h != mesh_.outgoing[a]);
    if (best[0] == kNone) return false;
    for (const Index on : best) builder.follow_edge(on);
    return true;
  }

  /// Searches along edges for the nearest of the pairs that nothing has reached. False if all have
  /// been tried.
  bool start_from_far_pairs() {
    std::vector<std::pair<double, Index>> waiting;
    for (Index i = 0; i < pairs_.size(); ++i) {
      if (!paths_.has(i) && asked_in_[i] != kSearched) {
        waiting.emplace_back((mesh_.points[pairs_[i].a] - mesh_.points[pairs_[i].b]).norm(), i);
      }
    }
    leave_out_parted(waiting);
    if (waiting.empty()) return false;
    std::sort(waiting.begin(), waiting.end());
    waiting.resize(
        std::max<std::size_t>(std::min<std::size_t>(waiting.size(), 64), waiting.size() / 8));
    std::vector<Index> chosen;
    chosen.reserve(waiting.size());
    for (const auto& [distance, pair] : waiting) chosen.push_back(pair);
    candidates_.assign(chosen.size(), {});
    parallel_for(chosen.size(), threads_, 8, [&](std::size_t i, unsigned worker) {
      const VertexPair& pair = pairs_[chosen[i]];
      Workspace& work = workspace(worker);
      const std::vector<Index> vertices = work.search.run(pair.a, pair.b);
      if (vertices.empty()) return;
      CorridorBuilder builder(mesh_, work.corridor);
      follow_vertices(vertices, builder);
      try_corridor(pair, chosen[i], work, candidates_[i]);
    });
    for (const Index pair : chosen) asked_in_[pair] = kSearched;
    accept(chosen);
    return true;
  }

  /// Takes out the pairs whose ends lie on two shells: no search would find a path.
  void leave_out_parted(std::vector<std::pair<double, Index>>& waiting) const {
    if (waiting.empty()) return;
    DisjointSets shells(mesh_.vertex_count());
    for (Index h = 0; h < mesh_.halfedges.size(); ++h) shells.join(mesh_.tail(h), mesh_.head(h));
    waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                                 [&](const std::pair<double, Index>& candidate) {
                                   const auto [a, b] = pairs_[candidate.second];
                                   return shells.find(a) != shells.find(b);
                                 }),
                  waiting.end());
  }

  // ---- rounds ----

  /// Lets all changed paths spread, the shorter ones first, until nothing gets shorter.
  void spread(const Progress& progress) {
    for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
      progress.report(static_cast<double>(bucket) / static_cast<double>(buckets_.size()),
                      "Carrying geodesics on");
      while (!buckets_[bucket].empty()) {
        active_ = std::move(buckets_[bucket]);
        buckets_[bucket].clear();
        ++round_;
        for (const Index pair : active_) changed_in_[pair] = round_;
        const std::vector<Index> asked = neighbours_of_active();
        candidates_.assign(asked.size(), {});
        parallel_for(asked.size(), threads_, 16, [&](std::size_t i, unsigned worker) {
          try_neighbours(asked[i], workspace(worker), candidates_[i]);
        });
        accept(asked, bucket);
      }
    }
    buckets_.clear();
  }

  std::vector<Index> neighbours_of_active() {
    std::vector<Index> asked;
    for (const Index pair : active_) {
      for (const Index link : pair_links_[pair]) {
        for (const Index other : links_[link]) {
          if (other == kNone || other == pair || asked_in_[other] == round_) continue;
          if (paths_.certification[other] == Certification::kProven) continue;
          asked_in_[other] = round_;
          asked.push_back(other);
        }
      }
    }
    return asked;
  }

  /// Tries the paths of the neighbours that have changed, the most promising first.
  void try_neighbours(Index pair, Workspace& work, Candidate& best) const {
    work.trials.clear();
    for (const Index link : pair_links_[pair]) {
      for (const Index from : links_[link]) {
        if (from == kNone || from == pair || changed_in_[from] != round_) continue;
        work.trials.push_back(make_trial(pair, from, link));
      }
    }
    std::sort(work.trials.begin(), work.trials.end());
    for (const Trial& trial : work.trials) {
      if (is_worth_it(pair, trial, best)) try_neighbour(pair, trial, work, best);
    }
  }

  Trial make_trial(Index pair, Index from, Index link) const {
    const VertexPair& goal = pairs_[pair];
    const VertexPair& known = pairs_[from];
    Trial trial;
    trial.from = from;
    trial.shared = goal.a == known.a || goal.a == known.b ? goal.a : goal.b;
    trial.moved = known.a == trial.shared ? known.b : known.a;
    trial.end = goal.a == trial.shared ? goal.b : goal.a;
    for (const Index other : links_[link]) {
      if (other != pair && other != from) trial.third = other;
    }
    trial.step = (mesh_.points[trial.moved] - mesh_.points[trial.end]).norm();
    trial.estimate = paths_.length[from] + trial.step;
    return trial;
  }

  /// Not if the neighbour's path is too long to help (to help much, if rough paths are wanted), nor
  /// if it leaves the common end so much like the pair's own path that the two are of one class.
  bool is_worth_it(Index pair, const Trial& trial, const Candidate& best) const {
    const bool is_new = best.length < paths_.length[pair];
    const double value = is_new ? best.length : paths_.length[pair];
    if (!(value < kInfinity)) return true;
    const double length = paths_.length[trial.from];
    if (length + least_excess_ * trial.step >= value) return false;
    const std::array<Vec3, 2>& tangents = is_new ? best.tangents : paths_.tangents[pair];
    const Vec3& mine = tangents[pairs_[pair].a == trial.shared ? 0 : 1];
    const Vec3& other = paths_.tangents[trial.from][pairs_[trial.from].a == trial.shared ? 0 : 1];
    const double sine = std::max(0.05, 1.1 * trial.step / length);
    return mine.dot(other) <= 0.0 || mine.cross(other).norm() > sine;
  }

  /// Leads the neighbour's path on to the pair's own end. The path is shortened from the end that
  /// the two share: what changes is mostly at the other.
  void try_neighbour(Index pair, const Trial& trial, Workspace& work, Candidate& best) const {
    CorridorBuilder builder(mesh_, work.corridor);
    follow_path(trial.from, trial.shared, builder);
    if (trial.third != kNone && paths_.has(trial.third)) {
      follow_path(trial.third, trial.moved, builder);
    } else if (!follow_short_way(trial.moved, trial.end, builder)) {
      return;  // there will be a way when the third pair has a path
    }
    try_corridor({trial.shared, trial.end}, pair, work, best);
  }

  /// The path of `pair` from its end `start` to the other.
  void follow_path(Index pair, Index start, CorridorBuilder& builder) const {
    const auto [a, b] = pairs_[pair];
    const std::vector<Index>& path = paths_.corridor[pair];
    if (path.empty()) {
      builder.follow_edge(find_halfedge(mesh_, start, start == a ? b : a));
    } else if (start == a) {
      builder.cross(path.data(), path.data() + path.size());
    } else {
      builder.cross_back(path.data(), path.data() + path.size());
    }
  }

  void follow_vertices(const std::vector<Index>& vertices, CorridorBuilder& builder) const {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      builder.follow_edge(find_halfedge(mesh_, vertices[i], vertices[i + 1]));
    }
  }

  /// Shortens the corridor in `work`, which leads from `way.a` to `way.b`, the ends of `pair` in
  /// either order, and keeps it if it is the best for the pair.
  void try_corridor(const VertexPair& way, Index pair, Workspace& work, Candidate& best) const {
    const double length = work.shortener.shorten(way.a, way.b, work.corridor);
    if (!(length < best.length)) return;
    best.length = length;
    best.tangents = work.shortener.tangents(way.a, way.b, work.corridor);
    if (way.a == pairs_[pair].a) {
      best.corridor = work.corridor;
    } else {
      std::swap(best.tangents[0], best.tangents[1]);
      best.corridor = reversed_corridor(mesh_, work.corridor);
    }
  }

  /// Takes over the candidates that are shorter, and queues their pairs, at `least` or later.
  void accept(const std::vector<Index>& asked, std::size_t least = 0) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const Index pair = asked[i];
      Candidate& found = candidates_[i];
      if (!(found.length < paths_.length[pair] * (1.0 - 1e-9))) continue;
      paths_.length[pair] = found.length;
      paths_.corridor[pair] = std::move(found.corridor);
      paths_.tangents[pair] = found.tangents;
      queue(pair, least);
    }
  }

  /// Puts a changed pair in the bucket of its length, `least` at least.
  void queue(Index pair, std::size_t least) {
    const double position = std::min(paths_.length[pair] / mesh_.mean_edge, 1e6);
    const std::size_t bucket = std::max(least, static_cast<std::size_t>(position));
    if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
    buckets_[bucket].push_back(pair);
  }

  static constexpr Index kSearched = kNone - 1;

  const HalfedgeMesh& mesh_;
  const std::vector<VertexPair>& pairs_;
  const std::vector<std::array<Index, 3>>& links_;
  ShorteningEffort effort_;
  double least_excess_;  ///< of a pair's path over a neighbour's, in steps, for a trial
  unsigned threads_;
  Rows<Index> pair_links_;  ///< one row per pair: the links that it is in
  PairPaths& paths_;
  std::vector<Index> changed_in_;  ///< one per pair: last round that it was active in
  std::vector<Index> asked_in_;    ///< one per pair: last round that it was tried in
  Index round_ = 0;
  std::vector<std::vector<Index>> buckets_;  ///< changed pairs by length
  std::vector<Index> active_;
  std::vector<Candidate> candidates_;
  std::vector<std::unique_ptr<Workspace>> workspaces_;
};

}  // namespace mgf
