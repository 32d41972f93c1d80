// SPDX-License-Identifier: GPL-3.0-or-later
// Marking of skeleton edges by the divergence of the MGF (paper, section 5.3).
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/skeleton/tangent_balls.h"

namespace mgf {

/// The divergence score of an edge that can't be marked at any theta.
inline constexpr double kUnmarkable = std::numeric_limits<double>::infinity();

/// Which of the edges that qualify are marked.
enum class MarkingRule {
  kAll,          ///< all of them that close no loop
  kOnePerFacet,  ///< the paper's: at most one edge of a facet, the strongest first
};

namespace detail {

/// The inward normal n of a Voronoi edge towards the facet dual to side ab of its dual triangle
/// abc: it lies in the plane of abc, orthogonal to ab, away from c. Zero if abc is collinear.
inline Vec3 normal_towards_facet(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 axis = (b - a).normalized();
  const Vec3 height = (c - a) - axis * axis.dot(c - a);
  const double norm = height.norm();
  constexpr double kCollinear = 1e-12;
  return norm > kCollinear * (c - a).norm() ? Vec3(-height / norm) : Vec3(Vec3::Zero());
}

/// Whether the balls round both ends of a Voronoi edge are tangent to the surface at its contacts.
inline bool has_tangent_balls(const MedialComplex& complex, const BallTangency& balls, Index edge) {
  const auto& ends = complex.edge_vertices[edge];
  const Triangle& contacts = complex.edge_contacts[edge];
  return std::all_of(contacts.begin(), contacts.end(), [&](Index contact) {
    return balls.tangent(complex.position[ends[0]], contact) &&
           balls.tangent(complex.position[ends[1]], contact);
  });
}

}  // namespace detail

/// For each Voronoi edge E the largest d_E(F) = v(F) · n over its incident facets F: the smallest
/// theta above which the gradient flow of *every* facet sinks into E. In [-1, 1]; `kUnmarkable` on
/// the boundary of M_T (at most one facet), beside a displaced vertex, where a facet's gradient or
/// normal vanishes, and where the balls round E's ends cut through the surface at a contact: there
/// the sample is too sparse for flows to mean anything. `surface` is numbered as the contacts.
inline std::vector<double> divergence_scores(const MedialComplex& complex,
                                             const MedialGeodesicField& field,
                                             const TriangleSurface& surface, unsigned threads = 1) {
  constexpr std::size_t kChunk = 4096;
  const std::vector<Vec3>& points = surface.points;
  const BallTangency balls(surface);
  std::vector<double> score(complex.edge_count(), kUnmarkable);
  parallel_for(score.size(), threads, kChunk, [&](std::size_t e, unsigned) {
    const auto& ends = complex.edge_vertices[e];
    if (complex.displaced[ends[0]] != 0 || complex.displaced[ends[1]] != 0) return;
    const Triangle& dual = complex.edge_contacts[e];
    std::size_t facets = 0;
    double largest = -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index facet = complex.edge_facets[e][i];
      if (facet == kNone) continue;
      ++facets;
      const Vec3 normal = detail::normal_towards_facet(points[dual[(i + 1) % 3]],
                                                       points[dual[(i + 2) % 3]], points[dual[i]]);
      const Vec3& gradient = field.gradient[facet];
      const bool defined = !normal.isZero(0.0) && !gradient.isZero(0.0);
      double inflow = kUnmarkable;
      if (defined) inflow = gradient.dot(normal);
      largest = std::max(largest, inflow);
    }
    if (facets < 2) return;
    const bool marks_nothing = largest >= 0.0;  // so it need not be looked at
    if (marks_nothing || detail::has_tangent_balls(complex, balls, to_index(e))) score[e] = largest;
  });
  return score;
}

/// The edges marked at every theta up to `loosest_theta`: E is marked at theta if it is in the list
/// and its score is below theta. Ascending by (score, rank), so the marks at one theta are a prefix
/// of the marks at any larger one. Marks close no loop (paper, section 5.3: MGF has no local
/// minimum). `rank` orders edges with equal scores.
inline std::vector<Index> choose_marks(const MedialComplex& complex,
                                       const std::vector<double>& score,
                                       const std::vector<Index>& rank, double loosest_theta,
                                       MarkingRule rule) {
  std::vector<Index> candidates;
  for (Index e = 0; e < score.size(); ++e) {
    if (score[e] < loosest_theta) candidates.push_back(e);
  }
  std::sort(candidates.begin(), candidates.end(), [&](Index e, Index g) {
    return score[e] != score[g] ? score[e] < score[g] : rank[e] < rank[g];
  });

  std::vector<Index> marks;
  DisjointSets joined(complex.vertex_count());
  std::vector<char> facet_used(complex.facet_count(), 0);
  for (const Index e : candidates) {
    const auto& facets = complex.edge_facets[e];
    const bool blocked = rule == MarkingRule::kOnePerFacet &&
                         std::any_of(facets.begin(), facets.end(), [&](Index facet) {
                           return facet != kNone && facet_used[facet] != 0;
                         });
    if (blocked || !joined.join(complex.edge_vertices[e][0], complex.edge_vertices[e][1])) continue;
    marks.push_back(e);
    for (const Index facet : facets) {
      if (facet != kNone) facet_used[facet] = 1;
    }
  }
  return marks;
}

}  // namespace mgf
