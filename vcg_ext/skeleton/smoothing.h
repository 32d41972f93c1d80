// SPDX-License-Identifier: GPL-3.0-or-later
// The skeleton as smooth curves that keep its graph, its junctions and its tips.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/graph_edits.h"
#include "vcg_ext/skeleton/resampling.h"
#include "vcg_ext/skeleton/shape_interior.h"
#include "vcg_ext/skeleton/smooth_branch.h"

namespace mgf {

/// The smooth skeleton: a graph with the branches of the raw one, evenly resampled.
/// Edges carry the measures of the raw edge beneath their middle.
struct SmoothSkeleton : CurveSkeleton {
  std::vector<Index> raw_node;     ///< one per node: the tip, junction or isolated node of the raw
                                   ///< skeleton that it is, exactly in its place; else kNone
  std::vector<Index> raw_edge;     ///< one per edge: the raw edge beneath its middle
  std::vector<Index> edge_branch;  ///< one per edge: id in the BranchGraph
  Index outside_edges = 0;         ///< edges that leave the shape: those of the raw one, if any
  double mean_turning = 0.0;       ///< angle between consecutive segments of a branch, radians
};

namespace smoothing {

/// Adds a node; returns its number.
inline Index add_node(const CurveSample& sample, Index raw_node, SmoothSkeleton& smooth) {
  smooth.position.push_back(sample.point);
  smooth.radius.push_back(sample.radius);
  smooth.node_eccentricity.push_back(0.0);
  smooth.node_mgf.push_back(sample.mgf);
  smooth.raw_node.push_back(raw_node);
  return to_index(smooth.position.size() - 1);
}

/// Adds an edge with the measures of raw edge `e`.
inline void add_edge(const CurveSkeleton& raw, Index e, Index branch, std::array<Index, 2> ends,
                     SmoothSkeleton& smooth) {
  smooth.edge.push_back(ends);
  smooth.mgf.push_back(raw.mgf[e]);
  smooth.girth.push_back(raw.girth[e]);
  smooth.circumference.push_back(raw.circumference[e]);
  smooth.eccentricity.push_back(raw.eccentricity[e]);
  smooth.theta_birth.push_back(raw.theta_birth[e]);
  smooth.voronoi_edge.push_back(raw.voronoi_edge[e]);
  smooth.contacts.push_back(raw.contacts[e]);
  smooth.raw_edge.push_back(e);
  smooth.edge_branch.push_back(branch);
}

/// The nodes that every branch end maps to: one per tip, junction and isolated node.
inline std::vector<Index> add_kept_nodes(const CurveSkeleton& raw, const BranchGraph& graph,
                                         SmoothSkeleton& smooth) {
  std::vector<Index> kept(raw.node_count(), kNone);
  for (Index v = 0; v < raw.node_count(); ++v) {
    if (graph.node_kind[v] == NodeKind::kRegular) continue;
    kept[v] = add_node({0.0, raw.position[v], raw.radius[v], raw.node_mgf[v], 0.0}, v, smooth);
  }
  return kept;
}

/// Adds a branch's polyline between its kept ends.
inline void add_branch(const CurveSkeleton& raw, const Branch& branch, Index id,
                       const SmoothBranch& bent, const std::vector<Index>& kept,
                       SmoothSkeleton& smooth) {
  const std::vector<CurveSample>& polyline = bent.polyline;
  Index previous = kept[branch.first_node];
  if (previous == kNone) previous = add_node(polyline.front(), kNone, smooth);
  const Index last = kept[branch.last_node] == kNone ? previous : kept[branch.last_node];
  for (std::size_t k = 1; k < polyline.size(); ++k) {
    const Index node = k + 1 == polyline.size() ? last : add_node(polyline[k], kNone, smooth);
    const double middle = 0.5 * (polyline[k - 1].parameter + polyline[k].parameter);
    const Index e = branch.edges[locate(bent.curve.parameter, middle).segment];
    add_edge(raw, e, id, {previous, node}, smooth);
    previous = node;
  }
}

}  // namespace smoothing

/// Resamples every branch and bends it as little as its constraints allow: ends in place (a loop
/// without junction is free all round), no point further than `max_shift` radii from its raw place,
/// no segment outside the shape unless the raw one's is.
/// `shape` is asked a few times a node. Cost: a banded linear system a branch and round.
inline SmoothSkeleton smooth_skeleton(const CurveSkeleton& skeleton, const BranchGraph& graph,
                                      const ShapeInterior& shape,
                                      const SmoothingOptions& options = {}) {
  SmoothSkeleton smooth;
  const std::vector<Index> kept = smoothing::add_kept_nodes(skeleton, graph, smooth);
  smoothing::Turning turning;
  for (Index b = 0; b < graph.branches.size(); ++b) {
    const Branch& branch = graph.branches[b];
    const bool closed = graph.node_kind[branch.first_node] == NodeKind::kRegular;
    const smoothing::SmoothBranch bent =
        smoothing::smooth_branch(skeleton, branch, closed, options, shape);
    smoothing::add_branch(skeleton, branch, b, bent, kept, smooth);
    turning.sum += bent.turning.sum;
    turning.count += bent.turning.count;
  }
  const InsideParts inside = find_inside_parts(shape, smooth.position, smooth.edge, 1);
  for (Index e = 0; e < smooth.edge_count(); ++e) {
    smooth.outside.push_back(inside.has_edge(e, smooth.edge[e]) ? 0 : 1);
    smooth.outside_edges += smooth.outside.back() != 0 ? 1 : 0;
  }
  average_eccentricity(smooth);
  smooth.mean_turning = turning.mean();
  return smooth;
}

}  // namespace mgf
