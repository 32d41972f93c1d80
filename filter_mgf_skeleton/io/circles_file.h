// SPDX-License-Identifier: GPL-3.0-or-later
// circles.ply: the geodesic circles as closed polylines.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "filter_mgf_skeleton/io/skeleton_file.h"
#include "vcg_ext/surface/geodesic_circles.h"

namespace mgf::io {

/// Writes each circle's points once, joined by edges to a closed curve. Vertices and edges carry
/// `eccentricity` and `circle`, the number of the skeleton edge that the circle belongs to. A
/// circle of one point has no edge. Throws `FileError`.
inline void write_circles(const std::filesystem::path& path, const GeodesicCircles& circles) {
  std::vector<Vec3> points;
  std::vector<Index> circle_of_point;
  std::vector<std::array<Index, 2>> edges;
  std::vector<Index> circle_of_edge;
  for (Index c = 0; c < circles.polyline.size(); ++c) {
    const Row<Vec3> curve = circles.polyline[c];
    const std::size_t distinct = curve.size() > 1 ? curve.size() - 1 : curve.size();
    const Index first = to_index(points.size());
    for (std::size_t i = 0; i < distinct; ++i) {
      points.push_back(curve[i]);
      circle_of_point.push_back(c);
      if (distinct == 1) break;
      edges.push_back({to_index(first + i), to_index(first + (i + 1) % distinct)});
      circle_of_edge.push_back(c);
    }
  }
  GraphTables tables = graph_tables(points, edges);
  const auto eccentricity_of = [&circles](const std::vector<Index>& circle_of) {
    std::vector<double> values;
    values.reserve(circle_of.size());
    for (const Index c : circle_of) values.push_back(circles.eccentricity.at(c));
    return values;
  };
  const std::vector<double> point_eccentricity = eccentricity_of(circle_of_point);
  const std::vector<double> edge_eccentricity = eccentricity_of(circle_of_edge);
  const auto add_columns = [](const std::vector<double>& eccentricity,
                              const std::vector<Index>& circle_of, Table& table) {
    table.columns.push_back(measure_column("eccentricity", eccentricity));
    table.columns.push_back(index_column("circle", circle_of));
  };
  add_columns(point_eccentricity, circle_of_point, tables.nodes);
  add_columns(edge_eccentricity, circle_of_edge, tables.edges);
  write_graph_ply(path, "geodesic circles, one closed polyline per skeleton edge", tables);
}

}  // namespace mgf::io
