// SPDX-License-Identifier: GPL-3.0-or-later
// branches.csv: one line per branch.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/table.h"
#include "filter_mgf_skeleton/io/text_number.h"
#include "vcg_ext/skeleton/branches.h"

namespace mgf::io {

/// The branches as a table that refers to `graph`: the columns of branches.csv and the members of
/// `branches` in report.json.
inline Table branch_table(const BranchGraph& graph) {
  const auto integer = [&graph](std::string name, auto member) {
    return index_column(std::move(name),
                        [&graph, member](std::size_t b) { return graph.branches[b].*member; });
  };
  const auto real = [&graph](std::string name, double Branch::*member) {
    return real_column(std::move(name),
                       [&graph, member](std::size_t b) { return graph.branches[b].*member; });
  };
  const auto flag = [&graph](std::string name, bool Branch::*member) {
    return Column{std::move(name), NumberType::kByte, [&graph, member](std::size_t b) {
                    return graph.branches[b].*member ? 1.0 : 0.0;
                  }};
  };
  Table table{"branch", graph.branches.size(), {}};
  table.columns = {
      index_column("branch", [](std::size_t b) { return to_index(b); }),
      integer("first_node", &Branch::first_node),
      integer("last_node", &Branch::last_node),
      integer("parent", &Branch::parent),
      integer("component", &Branch::component),
      flag("on_cycle", &Branch::on_cycle),
      integer("cycle", &Branch::cycle),
      flag("closes_cycle", &Branch::closes_cycle),
      index_column("edges",
                   [&graph](std::size_t b) { return to_index(graph.branches[b].edges.size()); }),
      real("length", &Branch::length),
      real("chord", &Branch::chord),
      real("tortuosity", &Branch::tortuosity),
      real("radius_min", &Branch::radius_min),
      real("radius_mean", &Branch::radius_mean),
      real("radius_max", &Branch::radius_max),
      real("girth_min", &Branch::girth_min),
      real("girth_mean", &Branch::girth_mean),
      real("girth_max", &Branch::girth_max),
      real("eccentricity_median", &Branch::eccentricity_median),
      flag("tubular", &Branch::tubular),
      real("area_share", &Branch::area_share),
      real("tubular_share", &Branch::tubular_share),
  };
  return table;
}

/// Writes a line of column names, then one line per branch (RFC 4180, but lines end in LF). Throws
/// `FileError`.
inline void write_branches_csv(const std::filesystem::path& path, const BranchGraph& graph) {
  const Table table = branch_table(graph);
  AtomicFile file(path);
  std::string line;
  const auto add_field = [&line](const std::string& text) {
    if (!line.empty()) line += ',';
    line += text;
  };
  const auto end_line = [&] {
    file.append(line + "\n");
    line.clear();
  };
  for (const Column& column : table.columns) add_field(column.name);
  end_line();
  for (std::size_t b = 0; b < table.rows; ++b) {
    for (const Column& column : table.columns) add_field(to_text(table, column, b, path));
    end_line();
  }
  file.commit();
}

}  // namespace mgf::io
