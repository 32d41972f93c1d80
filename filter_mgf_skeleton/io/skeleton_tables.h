// SPDX-License-Identifier: GPL-3.0-or-later
// The curve skeleton as two tables: what stands in its PLY, VTP and GraphML files alike.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "filter_mgf_skeleton/io/table.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"
#include "vcg_ext/skeleton/smoothing.h"

namespace mgf::io {

/// A graph in space. The first columns of `nodes` are x, y, z, those of `edges` vertex1, vertex2.
struct GraphTables {
  Table nodes;
  Table edges;
};

/// What each node and edge of a skeleton is in the branch graph.
struct SkeletonLabels {
  std::vector<Index> node_branch;   ///< one per node; kNone for an isolated one
  std::vector<NodeKind> node_kind;  ///< one per node
  std::vector<Index> edge_branch;   ///< one per edge
};

/// The labels of the skeleton that `graph` was built from.
inline SkeletonLabels labels_of(const BranchGraph& graph) {
  return {graph.node_branch, graph.node_kind, graph.edge_branch};
}

/// The labels of a smooth skeleton by the branches of the raw one.
inline SkeletonLabels labels_of(const SmoothSkeleton& smooth, const BranchGraph& graph) {
  SkeletonLabels labels;
  labels.node_branch.assign(smooth.node_count(), kNone);
  labels.node_kind.assign(smooth.node_count(), NodeKind::kRegular);
  labels.edge_branch = smooth.edge_branch;
  for (Index e = 0; e < smooth.edge_count(); ++e) {
    for (const Index node : smooth.edge[e]) labels.node_branch[node] = smooth.edge_branch[e];
  }
  for (Index n = 0; n < smooth.node_count(); ++n) {
    const Index raw = smooth.raw_node[n];
    if (raw == kNone) continue;
    labels.node_branch[n] = graph.node_branch[raw];
    labels.node_kind[n] = graph.node_kind[raw];
  }
  return labels;
}

/// The graph of `position` and `edge` without any measure; columns may be added.
inline GraphTables graph_tables(const std::vector<Vec3>& position,
                                const std::vector<std::array<Index, 2>>& edge) {
  GraphTables graph{{"vertex", position.size(), {}}, {"edge", edge.size(), {}}};
  add_vector_columns("", position, graph.nodes.columns);
  graph.edges.columns = {
      index_column("vertex1", [&edge](std::size_t e) { return edge.at(e)[0]; }),
      index_column("vertex2", [&edge](std::size_t e) { return edge.at(e)[1]; }),
  };
  return graph;
}

/// `kind` of a node: the number of its `NodeKind`.
inline Column kind_column(const std::vector<NodeKind>& kinds) {
  return {"kind", NumberType::kByte,
          [&kinds](std::size_t n) { return static_cast<double>(kinds.at(n)); }};
}

/// A skeleton with its measures and labels as tables that refer to both.
inline GraphTables skeleton_tables(const CurveSkeleton& skeleton, const SkeletonLabels& labels) {
  GraphTables tables = graph_tables(skeleton.position, skeleton.edge);
  const auto append = [](std::vector<Column> more, Table& table) {
    for (Column& column : more) table.columns.push_back(std::move(column));
  };
  append({real_column("radius", skeleton.radius), path_length_column("mgf", skeleton.node_mgf),
          measure_column("eccentricity", skeleton.node_eccentricity),
          index_column("branch", labels.node_branch), kind_column(labels.node_kind)},
         tables.nodes);
  append(
      {path_length_column("mgf", skeleton.mgf),
       measure_column("eccentricity", skeleton.eccentricity),
       path_length_column("girth", skeleton.girth),
       real_column("theta_birth", skeleton.theta_birth), index_column("branch", labels.edge_branch),
       measure_column("circumference", skeleton.circumference)},
      tables.edges);
  return tables;
}

}  // namespace mgf::io
