// SPDX-License-Identifier: GPL-3.0-or-later
// Marking, erosion and drawing in one go: the skeleton at every theta (paper, sections 5.3 to 5.5).
#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "vcg_ext/core/disjoint_sets.h"
#include "vcg_ext/core/parallel.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"
#include "vcg_ext/medial/medial_complex.h"
#include "vcg_ext/medial/medial_geodesic_function.h"
#include "vcg_ext/skeleton/contact_spacing.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/erosion.h"
#include "vcg_ext/skeleton/erosion_order.h"
#include "vcg_ext/skeleton/graph_edits.h"
#include "vcg_ext/skeleton/inside_routes.h"
#include "vcg_ext/skeleton/level_of_detail.h"
#include "vcg_ext/skeleton/marking.h"
#include "vcg_ext/skeleton/shape_interior.h"
#include "vcg_ext/skeleton/skeleton_graph.h"
#include "vcg_ext/skeleton/theta_births.h"

namespace mgf {

/// The range of theta. At the loosest every edge with negative divergence is marked; the paper asks
/// for no other. Below the strictest, where no mark is left, nothing changes any more.
inline constexpr double kLoosestTheta = 0.0;
inline constexpr double kStrictestTheta = -1.1;

/// Which edges make the skeleton, and how it is shown.
struct SkeletonOptions {
  double theta = -0.8;  ///< divergence threshold of the marking, in [-1.1, 0]; smaller: less detail
  double prune = 0.3;   ///< what sticks out of a junction by less is dropped; 0: nothing
  MarkingRule marking_rule = MarkingRule::kAll;
  bool open_pockets = false;  ///< open a closed pocket of the medial axis at its lowest MGF
  unsigned threads = 0;       ///< 0: all; the result is the same for any number
};

/// The skeleton at every theta, from one erosion.
struct SkeletonHierarchy {
  CurveSkeleton full;             ///< at the loosest theta; edges carry `theta_birth`
  std::vector<Index> last_nodes;  ///< of `full`: what remains of each tree when every mark is gone
  std::vector<double> contact_spacing;  ///< length of the surface's edges, one per contact
  Index residual_facets = 0;            ///< facets that no collapse could reach: a closed pocket
  Index pockets_opened = 0;  ///< facets given up by `open_pockets`, each a change of homotopy
  BettiNumbers betti;        ///< of `full` (b2: always 0); equal to the interior's unless
                             ///< facets are left or pockets were opened
};

/// Betti numbers of a graph.
inline BettiNumbers betti_numbers(const CurveSkeleton& skeleton) {
  DisjointSets sets(skeleton.node_count());
  BettiNumbers betti;
  betti.b0 = to_index(skeleton.node_count());
  for (const auto& ends : skeleton.edge) {
    if (sets.join(ends[0], ends[1])) {
      --betti.b0;
    } else {
      ++betti.b1;
    }
  }
  return betti;
}

/// How many edges leave the shape.
inline Index count_outside_edges(const CurveSkeleton& skeleton) {
  return to_index(static_cast<std::size_t>(
      std::count(skeleton.outside.begin(), skeleton.outside.end(), char{1})));
}

namespace detail {

/// Makes one node of Voronoi vertices that are one but for rounding; `scale` as below.
inline VoronoiSkeleton contract_coincident_nodes(const VoronoiSkeleton& drawing, double scale) {
  constexpr double kCoincident = 1e-9;  // of `scale`
  VoronoiSkeleton result;
  std::vector<Index> new_number;
  result.skeleton = contract_short_edges(drawing.skeleton, kCoincident * scale, new_number);
  result.voronoi_vertex.assign(result.skeleton.node_count(), kNone);
  for (Index node = 0; node < new_number.size(); ++node) {
    Index& vertex = result.voronoi_vertex[new_number[node]];
    if (vertex == kNone) vertex = drawing.voronoi_vertex[node];  // the one whose place is kept
  }
  for (const Index node : drawing.last_nodes) result.last_nodes.push_back(new_number[node]);
  return result;
}

}  // namespace detail

/// Marks at the loosest theta, erodes once, and draws what is left inside the shape.
/// `surface` is numbered as the contacts; `scale` is a length of the size of the shape (its
/// diagonal); `make_shape` may be called on another thread.
inline SkeletonHierarchy build_skeleton_hierarchy(
    const InteriorTetrahedra& interior, const MedialComplex& complex,
    const MedialGeodesicField& field, const TriangleSurface& surface, double scale,
    const SkeletonOptions& options, const std::function<ShapeInterior()>& make_shape) {
  const unsigned threads = thread_count(options.threads);
  ErosionOrder order;
  std::vector<double> score;
  parallel_beside(
      threads, [&] { order = order_cells(complex, field.mgf, surface.points, threads); },
      [&] { score = divergence_scores(complex, field, surface, threads); });
  const std::vector<Index> marks =
      choose_marks(complex, score, order.edge_rank, kLoosestTheta, options.marking_rule);
  ErodedComplex eroded;
  ThetaBirths births;
  ShapeInterior shape;
  parallel_beside(
      threads,
      [&] {
        eroded = Erosion(complex, order, field.mgf).run(marks, score, options.open_pockets);
        births = compute_theta_births(complex, eroded, order, kLoosestTheta);
      },
      [&] { shape = make_shape(); });
  VoronoiSkeleton drawing = detail::contract_coincident_nodes(
      draw_skeleton(complex, field, surface.points, eroded, births, threads), scale);
  route_inside(interior, shape, threads, drawing);

  SkeletonHierarchy hierarchy;
  hierarchy.full = std::move(drawing.skeleton);
  hierarchy.last_nodes = std::move(drawing.last_nodes);
  hierarchy.contact_spacing = contact_spacing(surface);
  fill_undefined_eccentricity(hierarchy.full);
  average_eccentricity(hierarchy.full);
  hierarchy.residual_facets = eroded.residual_facets;
  hierarchy.pockets_opened = eroded.pockets_opened;
  hierarchy.betti = betti_numbers(hierarchy.full);
  return hierarchy;
}

/// The skeleton at `theta` without its insignificant leaf branches. Node averages are those of
/// `full`. Linear in the skeleton but for the pruning's logarithm.
inline CurveSkeleton skeleton_at(const SkeletonHierarchy& hierarchy, double theta, double prune) {
  return prune_leaf_branches(skeleton_at_theta(hierarchy.full, hierarchy.last_nodes, theta),
                             hierarchy.contact_spacing, prune);
}

}  // namespace mgf
