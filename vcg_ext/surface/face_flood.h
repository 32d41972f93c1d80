// SPDX-License-Identifier: GPL-3.0-or-later
// Labels spread over the faces of a surface, each face taking that of the nearest labelled one.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// The dual graph of a triangle surface: faces, joined across their common edges.
struct FaceGraph {
  std::vector<std::array<Index, 3>> neighbour;  ///< across the edge from corner i to i+1, or kNone
  std::vector<std::array<double, 3>> step;      ///< way from centroid to centroid over the middle
                                                ///< of the common edge, mesh units
  std::vector<std::array<double, 3>> edge_length;  ///< of the edge from corner i to i+1
  std::vector<Vec3> centroid;
  std::vector<double> area;

  std::size_t face_count() const { return neighbour.size(); }
};

namespace detail {

/// Makes two faces neighbours across the edges from their corners i and j.
inline void join_faces(const Vec3& middle, Index f, Index i, Index g, Index j, FaceGraph& graph) {
  graph.neighbour[f][i] = g;
  graph.neighbour[g][j] = f;
  graph.step[f][i] = graph.step[g][j] =
      (graph.centroid[f] - middle).norm() + (middle - graph.centroid[g]).norm();
}

}  // namespace detail

/// The dual graph of `surface`, at most two faces of which share an edge. Linear time for vertices
/// of bounded degree.
inline FaceGraph build_face_graph(const TriangleSurface& surface) {
  const std::size_t n = surface.triangles.size();
  FaceGraph graph;
  graph.neighbour.assign(n, {kNone, kNone, kNone});
  graph.step.assign(n, {0.0, 0.0, 0.0});
  graph.edge_length.resize(n);
  graph.centroid.reserve(n);
  graph.area.reserve(n);
  std::vector<Index> low_end;  // of the side from corner i of face f, at 3 f + i
  std::vector<Index> high_end;
  low_end.reserve(3 * n);
  high_end.reserve(3 * n);
  for (Index f = 0; f < n; ++f) {
    const Triangle& t = surface.triangles[f];
    const Vec3& a = surface.points[t[0]];
    const Vec3& b = surface.points[t[1]];
    const Vec3& c = surface.points[t[2]];
    graph.centroid.emplace_back((a + b + c) / 3.0);
    graph.area.push_back(0.5 * (b - a).cross(c - a).norm());
    for (Index i = 0; i < 3; ++i) {
      const Index from = t[i];
      const Index to = t[(i + 1) % 3];
      graph.edge_length[f][i] = (surface.points[to] - surface.points[from]).norm();
      low_end.push_back(std::min(from, to));
      high_end.push_back(std::max(from, to));
    }
  }
  const Rows<Index> sides = group_by_key(low_end, surface.points.size());
  for (Index low = 0; low < sides.size(); ++low) {
    const Row<Index> row = sides[low];
    for (const Index* side = row.begin(); side != row.end(); ++side) {
      const Index* const other = std::find_if(
          side + 1, row.end(), [&](Index s) { return high_end[s] == high_end[*side]; });
      if (other == row.end()) continue;
      const Vec3 middle = 0.5 * (surface.points[low] + surface.points[high_end[*side]]);
      detail::join_faces(middle, *side / 3, *side % 3, *other / 3, *other % 3, graph);
    }
  }
  return graph;
}

/// A label and how far it came, one entry per face.
struct FaceFlood {
  std::vector<Index> label;      ///< kNone where no seed reaches
  std::vector<double> distance;  ///< to the nearest seed along the dual graph; infinite likewise
};

/// Gives each face the label of the nearest seed, a face whose `seeds` entry isn't kNone. Of two at
/// the same distance the smaller label wins, so the order of the faces doesn't matter. The flood
/// steps from face f to its neighbour g where `may_pass(f, g)`. Each label's region stays connected
/// to its seeds. O(n log n).
template <class MayPass>
FaceFlood flood_faces(const FaceGraph& graph, const std::vector<Index>& seeds,
                      const MayPass& may_pass) {
  FaceFlood flood;
  flood.label = seeds;
  flood.distance.assign(seeds.size(), std::numeric_limits<double>::infinity());
  using Entry = std::tuple<double, Index, Index>;  // distance, label, face
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index f = 0; f < seeds.size(); ++f) {
    if (seeds[f] == kNone) continue;
    flood.distance[f] = 0.0;
    queue.emplace(0.0, seeds[f], f);
  }
  while (!queue.empty()) {
    const auto [distance, label, f] = queue.top();
    queue.pop();
    if (std::tie(distance, label) != std::tie(flood.distance[f], flood.label[f])) continue;
    for (Index i = 0; i < 3; ++i) {
      const Index g = graph.neighbour[f][i];
      if (g == kNone || seeds[g] != kNone || !may_pass(f, g)) continue;
      const double reached = distance + graph.step[f][i];
      if (std::tie(reached, label) >= std::tie(flood.distance[g], flood.label[g])) continue;
      flood.distance[g] = reached;
      flood.label[g] = label;
      queue.emplace(reached, label, g);
    }
  }
  return flood;
}

/// The flood over all of the surface.
inline FaceFlood flood_faces(const FaceGraph& graph, const std::vector<Index>& seeds) {
  return flood_faces(graph, seeds, [](Index, Index) { return true; });
}

/// For each face of the input, the items (circles) whose triangles of the refined surface are part
/// of it: one row per face, ascending, each item once.
inline Rows<Index> items_on_input_faces(const Rows<Index>& item_triangles,
                                        const std::vector<Index>& parent_face,
                                        std::size_t input_faces) {
  std::vector<Index> face_of_hit;
  std::vector<Index> item_of_hit;
  for (Index item = 0; item < item_triangles.size(); ++item) {
    std::vector<Index> faces;
    for (const Index triangle : item_triangles[item]) faces.push_back(parent_face[triangle]);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    face_of_hit.insert(face_of_hit.end(), faces.begin(), faces.end());
    item_of_hit.insert(item_of_hit.end(), faces.size(), item);
  }
  Rows<Index> rows = group_by_key(face_of_hit, input_faces);
  for (Index& hit : rows.items) hit = item_of_hit[hit];
  return rows;
}

}  // namespace mgf
