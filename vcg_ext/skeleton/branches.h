// SPDX-License-Identifier: GPL-3.0-or-later
// The branches of a curve skeleton and what is measured on each.
#pragma once

#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// What a node is in the graph.
enum class NodeKind : char { kRegular = 0, kTip = 1, kJunction = 2, kIsolated = 3 };

/// A maximal chain of edges without a junction inside. Lengths in mesh units.
struct Branch {
  Index first_node = kNone;   ///< an end: tip or junction; of a cycle without junction, its start
  Index last_node = kNone;    ///< the other end; equal to `first_node` for a closed branch
  Index parent = kNone;       ///< branch nearer the root of its component's spanning tree, or kNone
  Index component = 0;        ///< connected component of the skeleton
  bool on_cycle = false;      ///< part of a loop of the skeleton
  double length = 0.0;
  double chord = 0.0;         ///< straight distance between the ends
  double tortuosity = 0.0;    ///< length / chord; 0 for a closed branch, where it is undefined
  double radius_min = 0.0, radius_mean = 0.0, radius_max = 0.0;
  double girth_min = 0.0, girth_mean = 0.0, girth_max = 0.0;
  double eccentricity_median = 0.0;  ///< weighted by length
  bool tubular = false;              ///< `eccentricity_median` below the threshold
  double area_share = 0.0;           ///< of the input surface nearest to this branch, in [0, 1]
  std::vector<Index> nodes;          ///< from `first_node` to `last_node`
  std::vector<Index> edges;          ///< edge i joins nodes i and i + 1
};

/// The branches of a skeleton; ids are positions, stable for the same input and options.
struct BranchGraph {
  std::vector<Branch> branches;
  std::vector<Index> edge_branch;    ///< one per skeleton edge
  std::vector<NodeKind> node_kind;   ///< one per skeleton node
  std::vector<Index> node_branch;    ///< one per node: a branch it lies on; a junction's longest
  Index components = 0;
  Index cycles = 0;                  ///< first Betti number of the skeleton
};

}  // namespace mgf
