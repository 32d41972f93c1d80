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

namespace mgf::io {

/// A graph in space. The first columns of `nodes` are x, y, z, those of `edges` vertex1, vertex2.
struct GraphTables {
  Table nodes;
  Table edges;
};

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

/// Skeleton and branches as tables that refer to them.
inline GraphTables skeleton_tables(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  GraphTables tables = graph_tables(skeleton.position, skeleton.edge);
  const auto append = [](std::vector<Column> more, Table& table) {
    for (Column& column : more) table.columns.push_back(std::move(column));
  };
  append({real_column("radius", skeleton.radius), real_column("mgf", skeleton.node_mgf),
          real_column("eccentricity", skeleton.node_eccentricity),
          index_column("branch", graph.node_branch), kind_column(graph.node_kind)},
         tables.nodes);
  append({real_column("mgf", skeleton.mgf), real_column("eccentricity", skeleton.eccentricity),
          real_column("girth", skeleton.girth), real_column("theta_birth", skeleton.theta_birth),
          index_column("branch", graph.edge_branch),
          real_column("circumference", skeleton.circumference)},
         tables.edges);
  return tables;
}

}  // namespace mgf::io
