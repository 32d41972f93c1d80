// SPDX-License-Identifier: GPL-3.0-or-later
// skeleton.swc: the curve skeleton as a forest with radii, for neuron and vessel software.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/skeleton_tables.h"
#include "filter_mgf_skeleton/io/text_number.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/curve_skeleton.h"

namespace mgf::io {

/// A skeleton with its loops cut: every node once, after its parent.
struct SkeletonForest {
  std::vector<Index> order;   ///< the nodes, depth first, each tree from its root
  std::vector<Index> parent;  ///< one per node: the node before it, or kNone for a root
  std::vector<Index> cut;     ///< edges left out, ascending
};

namespace swc_detail {

// A forest of widest edges: edges by falling girth, ties by number; those that close a loop stay
// out. So a loop loses the edge where it is narrowest.
inline std::vector<Index> narrowest_edges_of_loops(const CurveSkeleton& skeleton) {
  std::vector<Index> edges(skeleton.edge_count());
  std::iota(edges.begin(), edges.end(), Index{0});
  std::stable_sort(edges.begin(), edges.end(),
                   [&](Index i, Index j) { return skeleton.girth[i] > skeleton.girth[j]; });
  std::vector<Index> tree(skeleton.node_count());
  std::iota(tree.begin(), tree.end(), Index{0});
  const auto root_of = [&tree](Index node) {
    while (tree[node] != node) node = tree[node] = tree[tree[node]];
    return node;
  };
  std::vector<Index> cut;
  for (const Index e : edges) {
    const Index a = root_of(skeleton.edge[e][0]);
    const Index b = root_of(skeleton.edge[e][1]);
    if (a == b) {
      cut.push_back(e);
    } else {
      tree[a] = b;
    }
  }
  std::sort(cut.begin(), cut.end());
  return cut;
}

// Where trees start: at the roots of the branch graph, then anywhere that is not reached.
inline std::vector<Index> starting_nodes(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  std::vector<Index> nodes;
  for (const Branch& branch : graph.branches) {
    if (branch.parent == kNone) nodes.push_back(branch.first_node);
  }
  for (Index n = 0; n < skeleton.node_count(); ++n) nodes.push_back(n);
  return nodes;
}

}  // namespace swc_detail

/// Cuts each loop of the skeleton at its edge of smallest girth and orders what is left. A tree's
/// root is that of the branch graph's component. O(n log n).
inline SkeletonForest skeleton_forest(const CurveSkeleton& skeleton, const BranchGraph& graph) {
  SkeletonForest forest;
  forest.cut = swc_detail::narrowest_edges_of_loops(skeleton);
  std::vector<std::vector<Index>> neighbours(skeleton.node_count());
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    if (std::binary_search(forest.cut.begin(), forest.cut.end(), e)) continue;
    neighbours[skeleton.edge[e][0]].push_back(skeleton.edge[e][1]);
    neighbours[skeleton.edge[e][1]].push_back(skeleton.edge[e][0]);
  }
  forest.parent.assign(skeleton.node_count(), kNone);
  std::vector<bool> reached(skeleton.node_count(), false);
  std::vector<Index> stack;
  for (const Index root : swc_detail::starting_nodes(skeleton, graph)) {
    if (reached[root]) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const Index node = stack.back();
      stack.pop_back();
      reached[node] = true;
      forest.order.push_back(node);
      for (const Index next : neighbours[node]) {
        if (reached[next]) continue;
        forest.parent[next] = node;
        stack.push_back(next);
      }
    }
  }
  return forest;
}

/// Writes one line per node: number from 1, type (5 junction, 6 tip, else 0), x, y, z, radius,
/// number of the parent or -1. The edges that were cut to open the loops follow the rule as
/// comments, by node numbers. Lengths in mesh units. Throws `FileError`.
inline void write_swc(const std::filesystem::path& path, const CurveSkeleton& skeleton,
                      const BranchGraph& graph) {
  const SkeletonForest forest = skeleton_forest(skeleton, graph);
  std::vector<Index> number(skeleton.node_count());
  for (Index i = 0; i < forest.order.size(); ++i) number[forest.order[i]] = i + 1;
  const auto type_of = [&graph](Index node) -> Index {
    constexpr std::array<Index, 4> kTypes{0, 6, 5, 0};  // by NodeKind
    return kTypes.at(static_cast<std::size_t>(graph.node_kind.at(node)));
  };
  Table table{"node", forest.order.size(), {}};
  table.columns = {
      index_column("number", [](std::size_t i) { return to_index(i + 1); }),
      index_column("type", [&](std::size_t i) { return type_of(forest.order[i]); }),
      real_column("x", [&](std::size_t i) { return skeleton.position[forest.order[i]].x(); }),
      real_column("y", [&](std::size_t i) { return skeleton.position[forest.order[i]].y(); }),
      real_column("z", [&](std::size_t i) { return skeleton.position[forest.order[i]].z(); }),
      real_column("radius", [&](std::size_t i) { return skeleton.radius.at(forest.order[i]); }),
      index_column("parent",
                   [&](std::size_t i) {
                     const Index parent = forest.parent[forest.order[i]];
                     return parent == kNone ? kNone : number[parent];
                   }),
  };

  AtomicFile file(path);
  file.append("# curve skeleton, lengths in mesh units\n");
  file.append("# each loop is cut at its edge of smallest girth: " +
              std::to_string(forest.cut.size()) + " cut\n");
  for (const Index e : forest.cut) {
    file.append("# cut " + std::to_string(number[skeleton.edge[e][0]]) + " " +
                std::to_string(number[skeleton.edge[e][1]]) + "\n");
  }
  file.append("# number type x y z radius parent\n");
  for (std::size_t row = 0; row < table.rows; ++row) {
    std::string line;
    for (const Column& column : table.columns) line += to_text(table, column, row, path) + " ";
    line.back() = '\n';
    file.append(line);
  }
  file.commit();
}

}  // namespace mgf::io
