// SPDX-License-Identifier: GPL-3.0-or-later
// skeleton.vtp: the curve skeleton as VTK poly data, in text.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/skeleton_tables.h"
#include "filter_mgf_skeleton/io/text_number.h"

namespace mgf::io {

namespace vtp_detail {

inline std::string data_array(const std::string& type, const std::string& name,
                              const std::string& components, std::size_t rows,
                              const std::function<std::string(std::size_t)>& text) {
  std::string array = "        <DataArray type=\"" + type + "\" Name=\"" + name +
                      "\" NumberOfComponents=\"" + components + "\" format=\"ascii\">\n";
  for (std::size_t row = 0; row < rows; ++row) array += text(row) + "\n";
  return array + "        </DataArray>\n";
}

// The columns from number `first` on as the arrays of <PointData> or <CellData>.
inline std::string attributes(const std::string& section, const Table& table, std::size_t first,
                              const std::filesystem::path& path) {
  std::string text = "      <" + section + ">\n";
  for (std::size_t c = first; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    text +=
        data_array(column.type == NumberType::kReal ? "Float64" : "Int32", column.name, "1",
                   table.rows, [&](std::size_t row) { return to_text(table, column, row, path); });
  }
  return text + "      </" + section + ">\n";
}

// The columns first .. first + count - 1 side by side.
inline std::string joined(const Table& table, std::size_t first, std::size_t count, std::size_t row,
                          const std::filesystem::path& path) {
  std::string text;
  for (std::size_t c = first; c < first + count; ++c) {
    text += to_text(table, table.columns[c], row, path) + " ";
  }
  text.pop_back();
  return text;
}

}  // namespace vtp_detail

/// Writes nodes as points and edges as lines, their columns as point and cell data. Throws
/// `FileError`.
inline void write_vtp(const std::filesystem::path& path, const CurveSkeleton& skeleton,
                      const BranchGraph& graph) {
  using vtp_detail::attributes;
  using vtp_detail::data_array;
  using vtp_detail::joined;
  const SkeletonLabels labels = labels_of(graph);
  const GraphTables tables = skeleton_tables(skeleton, labels);
  const Table& nodes = tables.nodes;
  const Table& edges = tables.edges;
  constexpr std::size_t kCoordinates = 3;
  constexpr std::size_t kEnds = 2;
  AtomicFile file(path);
  file.append(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <PolyData>\n");
  file.append("    <Piece NumberOfPoints=\"" + std::to_string(nodes.rows) +
              "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(edges.rows) +
              "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n");
  file.append(attributes("PointData", nodes, kCoordinates, path));
  file.append(attributes("CellData", edges, kEnds, path));
  file.append("      <Points>\n");
  file.append(data_array("Float64", "Points", "3", nodes.rows,
                         [&](std::size_t n) { return joined(nodes, 0, kCoordinates, n, path); }));
  file.append("      </Points>\n      <Lines>\n");
  file.append(data_array("Int64", "connectivity", "1", edges.rows,
                         [&](std::size_t e) { return joined(edges, 0, kEnds, e, path); }));
  file.append(data_array("Int64", "offsets", "1", edges.rows,
                         [](std::size_t e) { return std::to_string(kEnds * (e + 1)); }));
  file.append("      </Lines>\n    </Piece>\n  </PolyData>\n</VTKFile>\n");
  file.commit();
}

}  // namespace mgf::io
