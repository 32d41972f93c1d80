// SPDX-License-Identifier: GPL-3.0-or-later
// Measures skeletons of shapes whose centreline is known; prints a table in Markdown.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/known_shapes.h"
#include "bench/program.h"
#include "vcg_ext/mgf_skeleton.h"
#include "vcg_ext/skeleton/branches.h"
#include "vcg_ext/skeleton/smoothing.h"
#include "vcg_ext/surface/contact_paths.h"
#include "vcg_ext/surface/segmentation.h"

namespace {

using namespace mgf;
using bench::CentrePiece;
using bench::KnownShape;

constexpr const char* kUsage =
    "usage: centreline_study [--seed N] [--coarser FACTOR] [--only NAME]\n";

struct Arguments {
  unsigned seed = 1;
  double coarser = 1.0;  // times the usual edge length
  std::string only;
};

Arguments parse(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; i += 2) {
    const std::string word = values[i];
    if (i + 1 == count) throw std::invalid_argument(word);
    const std::string value = values[i + 1];
    if (word == "--seed") {
      arguments.seed = static_cast<unsigned>(std::stoul(value));
    } else if (word == "--coarser") {
      arguments.coarser = std::stod(value);
    } else if (word == "--only") {
      arguments.only = value;
    } else {
      throw std::invalid_argument(word);
    }
  }
  return arguments;
}

/// Distance to the centreline over the radius of the nearest tube.
double relative_distance(const Vec3& p, const std::vector<CentrePiece>& centreline) {
  double least = std::numeric_limits<double>::infinity();
  for (const CentrePiece& piece : centreline) {
    least = std::min(least,
                     (p - nearest_point_of_segment(p, piece.from, piece.to)).norm() / piece.radius);
  }
  return least;
}

/// The middle of a short piece of an edge.
struct EdgePoint {
  Vec3 position;
  Vec3 along;  ///< the piece
};

/// All edges in pieces not longer than `step`.
std::vector<EdgePoint> points_along(const CurveSkeleton& skeleton, double step) {
  std::vector<EdgePoint> points;
  for (const auto& [u, v] : skeleton.edge) {
    const Vec3 along = skeleton.position[v] - skeleton.position[u];
    const int pieces = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
    for (int i = 0; i < pieces; ++i) {
      points.push_back({skeleton.position[u] + along * ((i + 0.5) / pieces), along / pieces});
    }
  }
  return points;
}

struct Deviation {
  double most_of_it = 0.0;  ///< that of 95 % of the length is smaller
  double largest = 0.0;
};

Deviation deviation(const CurveSkeleton& skeleton, const KnownShape& shape) {
  std::vector<std::pair<double, double>> distances;  // and lengths
  double length = 0.0;
  for (const EdgePoint& point : points_along(skeleton, 0.1 * shape.centreline.front().radius)) {
    distances.emplace_back(relative_distance(point.position, shape.centreline), point.along.norm());
    length += distances.back().second;
  }
  std::sort(distances.begin(), distances.end());
  Deviation deviation;
  double walked = 0.0;
  for (const auto& [distance, own_length] : distances) {
    walked += own_length;
    if (walked <= 0.95 * length) deviation.most_of_it = distance;
    deviation.largest = distance;
  }
  return deviation;
}

/// Mean over the skeleton of |d - d'| / (d + d') for opposite rays across it.
double imbalance(const CurveSkeleton& skeleton, const SurfaceTree& tree, double size) {
  constexpr int kRays = 16;
  double sum = 0.0;
  std::size_t count = 0;
  for (const EdgePoint& point : points_along(skeleton, 0.02 * size)) {
    if (point.along.norm() == 0.0) continue;
    const bench::detail::Frame frame = bench::detail::first_frame(point.along.normalized());
    for (int i = 0; i < kRays; ++i) {
      const Vec3 ray = size * frame.around(M_PI * i / kRays);
      const auto there = tree.first_hit(point.position, point.position + ray);
      const auto back = tree.first_hit(point.position, point.position - ray);
      if (!there || !back) continue;
      sum += std::abs(there->distance - back->distance) / (there->distance + back->distance);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double share_inside(const CurveSkeleton& skeleton) {
  double inside = 0.0;
  double all = 0.0;
  for (Index e = 0; e < skeleton.edge_count(); ++e) {
    const double length = skeleton_edge_length(skeleton, e);
    all += length;
    inside += skeleton.outside[e] == 0 ? length : 0.0;
  }
  return all > 0.0 ? inside / all : 1.0;
}

/// Edges of a skeleton at a smaller theta that are missing at a larger one.
std::size_t nesting_violations(const SkeletonHierarchy& hierarchy) {
  std::size_t violations = 0;
  std::set<Index> looser;
  bool first = true;
  for (double theta = 0.0; theta > -1.1; theta -= 0.05) {
    std::set<Index> edges;
    for (const Index e :
         skeleton_at_theta(hierarchy.full, hierarchy.last_nodes, theta).voronoi_edge) {
      edges.insert(e);
      if (!first && looser.count(e) == 0) ++violations;
    }
    looser = std::move(edges);
    first = false;
  }
  return violations;
}

/// How far the smooth nodes are from the raw skeleton, in local radii, at most.
double largest_shift(const CurveSkeleton& raw, const SmoothSkeleton& smooth) {
  double largest = 0.0;
  for (Index v = 0; v < smooth.node_count(); ++v) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : raw.edge) {
      const Vec3 foot =
          nearest_point_of_segment(smooth.position[v], raw.position[a], raw.position[b]);
      least = std::min(least, (foot - smooth.position[v]).norm());
    }
    if (std::isfinite(least)) largest = std::max(largest, least / smooth.radius[v]);
  }
  return largest;
}

/// Share of the faces off the paddle's transition that are labelled as they should be.
double faces_right(const MedialAxis& axis, const MedialGeodesicField& field,
                   const CurveSkeleton& skeleton, const BranchGraph& graph) {
  constexpr double kThreshold = 1.3;
  const TriangleSurface& surface = axis.working.surface;
  const GeodesicCircles circles =
      trace_geodesic_circles(skeleton, ContactPaths(axis.surface.surface, field));
  const Segmentation segmentation =
      segment_surface(surface, axis.surface, skeleton, graph, circles, kThreshold);
  Index right = 0;
  Index judged = 0;
  for (Index f = 0; f < surface.triangles.size(); ++f) {
    const Triangle& t = surface.triangles[f];
    const double x =
        (surface.points[t[0]].x() + surface.points[t[1]].x() + surface.points[t[2]].x()) / 3;
    if (x > 5.0 && x < 5.5) continue;
    ++judged;
    right += (segmentation.tubular[f] != 0) == (x < 5.25) ? 1U : 0U;
  }
  return static_cast<double>(right) / judged;
}

Index count_tips(const BranchGraph& graph) {
  return to_index(static_cast<std::size_t>(
      std::count(graph.node_kind.begin(), graph.node_kind.end(), NodeKind::kTip)));
}

void study(const KnownShape& shape) {
  const MedialAxis axis = compute_medial_axis(shape.surface);
  const MedialGeodesicFunction function = compute_medial_geodesic_function(axis);
  const SkeletonOptions options;
  const CurveSkeletonResult result = compute_skeleton_hierarchy(axis, function.field, options);
  const CurveSkeleton raw = skeleton_at(result.hierarchy, options.theta, options.prune);
  const BranchGraph graph = build_branches(raw);
  const SurfaceTree tree(axis.working.surface);
  const SmoothSkeleton smooth = smooth_skeleton(raw, graph, shape_interior(tree, false));

  const double size = bounding_box_diagonal(shape.surface.points);
  const Deviation raw_deviation = deviation(raw, shape);
  const Deviation smooth_deviation = deviation(smooth, shape);
  std::printf(
      "| %s | %zu | %.4f | %.3f | %.4f | %.3f | %u (%u) | %u (%u) | %u (%u) | %.3f | %.0f |"
      " %.1f | %.2f | %zu | ",
      shape.name.c_str(), shape.surface.points.size(), raw_deviation.most_of_it,
      raw_deviation.largest, smooth_deviation.most_of_it, smooth_deviation.largest, graph.cycles,
      shape.cycles, count_tips(graph), shape.leaves, graph.junction_clusters, shape.junctions,
      imbalance(smooth, tree, size), 100 * std::min(share_inside(raw), share_inside(smooth)),
      smooth.mean_turning * 180 / M_PI, largest_shift(raw, smooth),
      nesting_violations(result.hierarchy));
  if (shape.name == "paddle") {
    std::printf("%.1f", 100 * faces_right(axis, function.field, raw, graph));
  }
  std::printf(" |\n");
  std::fflush(stdout);
}

void run(const Arguments& arguments) {
  std::printf(
      "| shape | vertices | raw 95 %% | raw max | smooth 95 %% | smooth max | cycles | leaves |"
      " junctions | imbalance | inside %% | turning | shift | nesting | faces right %% |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const unsigned seed = arguments.seed;
  const double coarser = arguments.coarser;
  const auto tube = [&](double length, double radius, Index sides) {
    bench::TubeMesh mesh;
    mesh.sides = std::max(6U, static_cast<Index>(sides / coarser));
    mesh.rings = static_cast<Index>(length / (2 * M_PI * radius / mesh.sides));
    return mesh;
  };
  const std::vector<std::pair<std::string, std::function<KnownShape()>>> shapes = {
      {"trefoil", [&] { return bench::trefoil(0.5, tube(30, 0.5, 24), seed); }},
      {"trefoil", [&] { return bench::trefoil(0.3, tube(30, 0.3, 16), seed + 1); }},
      {"helix", [&] { return bench::helix(0.5, tube(38, 0.5, 24), seed + 2); }},
      {"helix", [&] { return bench::helix(0.7, tube(38, 0.7, 40), seed + 3); }},
      {"Y", [&] { return bench::y_shape(0.7, 0.12 * coarser, seed); }},
      {"Y", [&] { return bench::y_shape(0.5, 0.12 * coarser, seed + 1); }},
      {"tree", [&] { return bench::random_tree(9, 0.4, 0.11 * coarser, seed); }},
      {"tree", [&] { return bench::random_tree(17, 0.4, 0.11 * coarser, seed + 1); }},
      {"tree", [&] { return bench::random_tree(25, 0.4, 0.13 * coarser, seed + 2); }},
      {"grid", [&] { return bench::grid_of_tubes(2, 0.5, 0.12 * coarser); }},
      {"grid", [&] { return bench::grid_of_tubes(3, 0.4, 0.12 * coarser); }},
      {"paddle", [&] { return bench::paddle(coarser); }},
      {"block", [&] { return bench::block(2.0, 1.0, 0.1 * coarser); }},
      {"block", [&] { return bench::block(1.0, 1.0, 0.1 * coarser); }},
      {"ellipsoid", [&] { return bench::ellipsoid(1.5, 1.0, 0.11 * coarser); }},
      {"ellipsoid", [&] { return bench::ellipsoid(1.0, 1.0, 0.11 * coarser); }},
  };
  for (const auto& [name, make] : shapes) {
    if (arguments.only.empty() || arguments.only == name) study(make());
  }
}

}  // namespace

int main(int count, char** values) {
  return mgf::bench::run_program(
      kUsage, [&] { return parse(count, values); }, run);
}
