// SPDX-License-Identifier: GPL-3.0-or-later
// Homotopy-preserving erosion of the medial complex by collapses (paper, section 5.4).
#pragma once

#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/skeleton/erosion_order.h"
#include "vcg_ext/skeleton/marking.h"
#include "vcg_ext/skeleton/rank_queue.h"

namespace mgf {

/// What the erosion left of the medial complex.
struct ErodedComplex {
  std::vector<char> vertex_alive;
  std::vector<char> edge_alive;
  std::vector<char> facet_alive;
  std::vector<double> mark_score;  ///< one per edge: its score if it is marked, else kUnmarkable
  Index residual_facets = 0;       ///< facets that no collapse could reach
  Index pockets_opened = 0;  ///< facets removed without a collapse: each changes b1 or b2 by 1
};

/// Collapses (edge, facet) and (vertex, edge) pairs in the given order until none is left whose
/// cells are unmarked. Three-dimensional cells go first, each with a facet. A pair is collapsible
/// if the second cell is the only live coface of the first, so every step is a deformation
/// retraction.
///
/// If facets are left, the marked edge with the weakest score among those that hold one back is
/// unmarked, and the erosion goes on. What then remains is a closed pocket (paper, section 7: house
/// with two rooms): it is kept, or, with `open_pockets`, opened at its lowest facet.
class Erosion {
 public:
  Erosion(const MedialComplex& complex, const ErosionOrder& order, const std::vector<double>& mgf)
      : complex_(complex), order_(order), mgf_(mgf), queue_(order.cell_at.size()) {}

  /// `marks` ascending by score, as `choose_marks` gives them. n log n.
  ErodedComplex run(const std::vector<Index>& marks, const std::vector<double>& score,
                    bool open_pockets) {
    start(marks, score);
    collapse_cells();
    collapse_all();
    while (live_facets_ > 0 && (unmark_weakest() || (open_pockets && open_lowest_facet()))) {
      collapse_all();
    }
    state_.residual_facets = live_facets_;
    return std::move(state_);
  }

 private:
  void start(const std::vector<Index>& marks, const std::vector<double>& score) {
    state_.vertex_alive.assign(complex_.vertex_count(), 1);
    state_.edge_alive.assign(complex_.edge_count(), 1);
    state_.facet_alive.assign(complex_.facet_count(), 1);
    state_.mark_score.assign(complex_.edge_count(), kUnmarkable);
    live_facets_ = to_index(complex_.facet_count());

    facets_of_edge_.assign(complex_.edge_count(), 0);
    edges_of_vertex_.assign(complex_.vertex_count(), 0);
    marks_of_vertex_.assign(complex_.vertex_count(), 0);
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      for (const Index facet : complex_.edge_facets[e])
        facets_of_edge_[e] += facet != kNone ? 1 : 0;
      for (const Index v : complex_.edge_vertices[e]) ++edges_of_vertex_[v];
    }
    marks_ = marks;
    for (const Index e : marks) {
      state_.mark_score[e] = score[e];
      for (const Index v : complex_.edge_vertices[e]) ++marks_of_vertex_[v];
    }
    for (Index e = 0; e < complex_.edge_count(); ++e) offer_edge(e);
    for (Index v = 0; v < complex_.vertex_count(); ++v) offer_vertex(v);
  }

  bool marked(Index edge) const { return state_.mark_score[edge] != kUnmarkable; }

  /// Whether an edge may collapse with its only live facet.
  bool edge_is_free(Index e) const {
    return state_.edge_alive[e] != 0 && facets_of_edge_[e] == 1 && !marked(e);
  }

  void offer_edge(Index e) {
    if (edge_is_free(e)) queue_.push(order_.edge_rank[e]);
  }

  /// The edge with which a vertex may collapse, or kNone.
  Index free_edge_of(Index v) const {
    if (state_.vertex_alive[v] == 0 || edges_of_vertex_[v] != 1 || marks_of_vertex_[v] != 0) {
      return kNone;
    }
    for (const Index e : complex_.vertex_edges[v]) {
      if (state_.edge_alive[e] != 0) return facets_of_edge_[e] == 0 ? e : kNone;
    }
    return kNone;
  }

  void offer_vertex(Index v) {
    if (free_edge_of(v) != kNone) queue_.push(order_.vertex_rank[v]);
  }

  void collapse_all() {
    const Index edges = to_index(complex_.edge_count());
    while (!queue_.empty()) {
      const Index cell = order_.cell_at[queue_.pop()];
      if (cell < edges) {
        if (edge_is_free(cell)) collapse_edge(cell);
      } else {
        const Index edge = free_edge_of(cell - edges);
        if (edge != kNone) collapse_vertex(cell - edges, edge);
      }
    }
  }

  /// Collapses every 3-cell with its lowest facet that bounds no other live one.
  void collapse_cells() {
    std::vector<std::vector<Index>> facets_of_cell(complex_.cell_count);
    std::vector<Index> cells_of_facet(complex_.facet_count(), 0);
    std::vector<char> cell_alive(complex_.cell_count, 1);
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> free_facets;
    const auto offer = [&](Index facet) {
      if (cells_of_facet[facet] == 1) free_facets.emplace(mgf_[facet], facet);
    };
    for (Index facet = 0; facet < complex_.facet_count(); ++facet) {
      for (const Index cell : complex_.facet_cells[facet]) {
        if (cell == kNone) continue;
        facets_of_cell[cell].push_back(facet);
        ++cells_of_facet[facet];
      }
      offer(facet);
    }
    while (!free_facets.empty()) {
      const Index facet = free_facets.top().second;
      free_facets.pop();
      for (const Index cell : complex_.facet_cells[facet]) {
        if (cell == kNone || cell_alive[cell] == 0 || state_.facet_alive[facet] == 0) continue;
        cell_alive[cell] = 0;
        remove_facet(facet);
        for (const Index other : facets_of_cell[cell]) {
          --cells_of_facet[other];
          if (state_.facet_alive[other] != 0) offer(other);
        }
      }
    }
  }

  void collapse_edge(Index e) {
    for (const Index facet : complex_.edge_facets[e]) {
      if (facet != kNone && state_.facet_alive[facet] != 0) remove_facet(facet);
    }
    remove_edge(e);
  }

  void collapse_vertex(Index v, Index edge) {
    state_.vertex_alive[v] = 0;
    remove_edge(edge);
  }

  void remove_edge(Index e) {
    state_.edge_alive[e] = 0;
    for (const Index v : complex_.edge_vertices[e]) {
      --edges_of_vertex_[v];
      offer_vertex(v);
    }
  }

  void remove_facet(Index facet) {
    state_.facet_alive[facet] = 0;
    --live_facets_;
    for (const Index e : complex_.facet_edges[facet]) {
      --facets_of_edge_[e];
      offer_edge(e);
      if (facets_of_edge_[e] == 0) {
        for (const Index v : complex_.edge_vertices[e]) offer_vertex(v);
      }
    }
  }

  /// Gives up the weakest mark that holds a facet back; false if there is none.
  bool unmark_weakest() {
    for (auto e = marks_.rbegin(); e != marks_.rend(); ++e) {
      if (!marked(*e) || facets_of_edge_[*e] != 1) continue;
      state_.mark_score[*e] = kUnmarkable;
      for (const Index v : complex_.edge_vertices[*e]) --marks_of_vertex_[v];
      offer_edge(*e);
      return true;
    }
    return false;
  }

  bool open_lowest_facet() {
    Index lowest = kNone;
    for (Index facet = 0; facet < complex_.facet_count(); ++facet) {
      if (state_.facet_alive[facet] != 0 && (lowest == kNone || mgf_[facet] < mgf_[lowest])) {
        lowest = facet;
      }
    }
    remove_facet(lowest);
    ++state_.pockets_opened;
    return true;
  }

  const MedialComplex& complex_;
  const ErosionOrder& order_;
  const std::vector<double>& mgf_;

  ErodedComplex state_;
  std::vector<Index> marks_;
  std::vector<Index> facets_of_edge_;   ///< live cofaces
  std::vector<Index> edges_of_vertex_;  ///< live cofaces
  std::vector<Index> marks_of_vertex_;
  Index live_facets_ = 0;
  RankQueue queue_;  ///< ranks of cells that may have become free
};

}  // namespace mgf
