// SPDX-License-Identifier: GPL-3.0-or-later
// skeleton.graphml: the curve skeleton for graph software.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/skeleton_tables.h"
#include "filter_mgf_skeleton/io/text_number.h"

namespace mgf::io {

namespace graphml_detail {

// `domain` is "node" or "edge"; keys are unique in the file, so their names begin with it.
inline std::string key_of(const Column& column, const char* domain) {
  return std::string(domain).append("_").append(column.name);
}

inline std::string key_declarations(const Table& table, const char* domain, std::size_t first) {
  std::string text;
  for (std::size_t c = first; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    text.append("  <key id=\"").append(key_of(column, domain)).append("\" for=\"").append(domain);
    text.append("\" attr.name=\"").append(column.name).append("\" attr.type=\"");
    text.append(column.type == NumberType::kReal ? "double" : "int").append("\"/>\n");
  }
  return text;
}

inline std::string data(const Table& table, const char* domain, std::size_t first, std::size_t row,
                        const std::filesystem::path& path) {
  std::string text;
  for (std::size_t c = first; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    text.append("<data key=\"").append(key_of(column, domain)).append("\">");
    text.append(to_text(table, column, row, path)).append("</data>");
  }
  return text;
}

}  // namespace graphml_detail

/// Writes an undirected graph: nodes n0, n1, … and edges e0, e1, … with every column of the
/// skeleton's tables as a typed attribute; vertex1 and vertex2 become source and target. Throws
/// `FileError`.
inline void write_graphml(const std::filesystem::path& path, const CurveSkeleton& skeleton,
                          const BranchGraph& graph) {
  const SkeletonLabels labels = labels_of(graph);
  const GraphTables tables = skeleton_tables(skeleton, labels);
  using graphml_detail::data;
  using graphml_detail::key_declarations;
  constexpr std::size_t kEnds = 2;  // the columns vertex1 and vertex2
  AtomicFile file(path);
  file.append(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n");
  file.append(key_declarations(tables.nodes, "node", 0));
  file.append(key_declarations(tables.edges, "edge", kEnds));
  file.append("  <graph id=\"skeleton\" edgedefault=\"undirected\">\n");
  for (std::size_t n = 0; n < tables.nodes.rows; ++n) {
    file.append("    <node id=\"n" + std::to_string(n) + "\">" +
                data(tables.nodes, "node", 0, n, path) + "</node>\n");
  }
  for (std::size_t e = 0; e < tables.edges.rows; ++e) {
    const auto end = [&](std::size_t which) {
      return "n" + to_text(tables.edges, tables.edges.columns[which], e, path);
    };
    file.append("    <edge id=\"e" + std::to_string(e) + "\" source=\"" + end(0) + "\" target=\"" +
                end(1) + "\">" + data(tables.edges, "edge", kEnds, e, path) + "</edge>\n");
  }
  file.append("  </graph>\n</graphml>\n");
  file.commit();
}

}  // namespace mgf::io
