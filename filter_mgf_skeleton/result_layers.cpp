// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/result_layers.h"

#include <algorithm>
#include <cmath>

#include "filter_mgf_skeleton/facet_orientation.h"
#include "filter_mgf_skeleton/io/tube_mesh.h"
#include "filter_mgf_skeleton/io/vertex_numbers.h"
#include "filter_mgf_skeleton/short_number.h"

namespace mgf::plugin {
namespace {

using parameters::SkeletonQuality;

/// Bit i is set where side i of triangle `i` of a fan of `count` triangles lies within the polygon.
std::uint8_t faux_sides(std::size_t i, std::size_t count) {
  const unsigned first = i > 0 ? 1U : 0U;
  const unsigned last = i + 1 < count ? 4U : 0U;
  return static_cast<std::uint8_t>(first | last);
}

std::vector<double> all_shown(const std::vector<double>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(shown(value));
  return result;
}

std::vector<double> as_numbers(const std::vector<Index>& ids) {
  std::vector<double> result;
  result.reserve(ids.size());
  for (const Index id : ids) result.push_back(id == kNone ? -1.0 : static_cast<double>(id));
  return result;
}

std::vector<double> mean_of_ends(const CurveSkeleton& skeleton,
                                 const std::vector<double>& of_node) {
  std::vector<double> result;
  result.reserve(skeleton.edge_count());
  for (const auto& ends : skeleton.edge) {
    result.push_back(0.5 * (of_node[ends[0]] + of_node[ends[1]]));
  }
  return result;
}

/// Fills in quality other than by branch.
void measure(const CurveSkeleton& skeleton, SkeletonQuality quality, SkeletonPaint& paint) {
  switch (quality) {
    case SkeletonQuality::kMgf:
      paint.of_node = all_shown(skeleton.node_mgf);
      paint.of_edge = all_shown(skeleton.mgf);
      break;
    case SkeletonQuality::kRadius:
      paint.of_node = skeleton.radius;
      paint.of_edge = mean_of_ends(skeleton, skeleton.radius);
      break;
    default:
      paint.of_node = all_shown(skeleton.node_eccentricity);
      paint.of_edge = all_shown(skeleton.eccentricity);
      break;
  }
}

const char* name_of(SkeletonQuality quality) {
  switch (quality) {
    case SkeletonQuality::kMgf:
      return "medial geodesic function";
    case SkeletonQuality::kRadius:
      return "radius";
    case SkeletonQuality::kBranch:
      return "branch";
    default:
      return "eccentricity";
  }
}

}  // namespace

double shown(double value) {
  return std::isfinite(value) ? value : 0.0;
}

Legend make_legend(const std::string& quantity, std::vector<double> values) {
  constexpr double kTail = 0.02;
  values.erase(std::remove_if(values.begin(), values.end(),
                              [](double value) { return !std::isfinite(value); }),
               values.end());
  Legend legend;
  if (values.empty()) {
    legend.sentence = "Colours: there is no " + quantity + " to show.";
    return legend;
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::string range = short_number(*least) + " to " + short_number(*most);
  legend.scale = io::quantile_scale(values, kTail);
  legend.sentence = "Colours: " + quantity + ", blue " + short_number(legend.scale.low) +
                    " and below, green " +
                    short_number(0.5 * (legend.scale.low + legend.scale.high)) + ", red " +
                    short_number(legend.scale.high) + " and above (values from " + range + ").";
  return legend;
}

FacetLayer facet_layer(const std::string& name, const MedialAxis& axis) {
  const MedialComplex& complex = axis.complex;
  const io::VertexNumbers numbers{axis.working.input_of_vertex,
                                  to_index(axis.working.vertex_of_input.size())};
  FacetLayer result;
  Layer& layer = result.layer;
  layer.name = name;
  layer.points = complex.position;
  layer.point_quality = complex.radius;
  Attribute contact_a{"contact_a", {}};
  Attribute contact_b{"contact_b", {}};
  const std::vector<char> reverse = facets_to_reverse(complex);
  for (Index f = 0; f < complex.facet_count(); ++f) {
    const Row<Index> row = complex.facet_vertices[f];
    if (row.size() < 3) continue;
    std::vector<Index> corners(row.begin(), row.end());
    if (reverse[f]) std::reverse(corners.begin(), corners.end());
    const std::size_t count = corners.size() - 2;
    for (std::size_t i = 0; i < count; ++i) {
      layer.triangles.push_back({corners[0], corners[i + 1], corners[i + 2]});
      layer.faux_edges.push_back(faux_sides(i, count));
      result.facet.push_back(f);
      contact_a.values.push_back(numbers[complex.facet_contacts[f].a]);
      contact_b.values.push_back(numbers[complex.facet_contacts[f].b]);
    }
  }
  layer.face_attributes = {contact_a, contact_b, {"facet", as_numbers(result.facet)}};
  for (Index e = 0; e < complex.edge_count(); ++e) {
    const auto& facets = complex.edge_facets[e];
    const bool bare = facets[0] == kNone && facets[1] == kNone && facets[2] == kNone;
    if (bare) layer.edges.push_back(complex.edge_vertices[e]);
  }
  return result;
}

Colour SkeletonPaint::colour(double quality) const {
  if (branch_colour.empty()) return legend.scale(quality);
  return quality < 0.0 ? io::kUnlabelledColour : branch_colour[static_cast<std::size_t>(quality)];
}

SkeletonPaint paint_skeleton(const SkeletonLevel& level, SkeletonQuality quality) {
  SkeletonPaint paint;
  if (quality == SkeletonQuality::kBranch) {
    paint.of_node = as_numbers(level.graph.node_branch);
    paint.of_edge = as_numbers(level.graph.edge_branch);
    paint.branch_colour = io::branch_colours(level.graph);
    paint.legend.sentence = "Colours: one per branch.";
  } else {
    measure(level.skeleton, quality, paint);
    paint.legend = make_legend(name_of(quality), paint.of_edge);
  }
  return paint;
}

SkeletonPaint paint_smooth(const SmoothSkeleton& smooth, const SkeletonPaint& raw,
                           SkeletonQuality quality) {
  SkeletonPaint paint = raw;
  if (quality != SkeletonQuality::kBranch) {
    measure(smooth, quality, paint);
    return paint;
  }
  paint.of_edge = as_numbers(smooth.edge_branch);
  paint.of_node.assign(smooth.node_count(), -1.0);
  for (Index e = 0; e < smooth.edge_count(); ++e) {
    for (const Index node : smooth.edge[e]) paint.of_node[node] = paint.of_edge[e];
  }
  return paint;
}

Layer line_layer(const std::string& name, const CurveSkeleton& skeleton,
                 const SkeletonPaint& paint) {
  Layer layer;
  layer.name = name;
  layer.points = skeleton.position;
  layer.edges = skeleton.edge;
  layer.point_quality = paint.of_node;
  for (const double quality : paint.of_node) layer.point_colour.push_back(paint.colour(quality));
  layer.point_attributes = {{"radius", skeleton.radius}, {"mgf", skeleton.node_mgf}};
  return layer;
}

Layer tube_layer(const std::string& name, const CurveSkeleton& skeleton, const BranchGraph& graph,
                 const SkeletonPaint& paint) {
  const double isolated = paint.of_node.empty() ? 0.0 : paint.of_node.front();
  io::TubeMesh tubes = io::make_tubes(io::tube_paths(skeleton, graph, paint.of_edge, isolated),
                                      io::default_tube_radius(skeleton));
  Layer layer;
  layer.name = name;
  for (const Triangle& t : tubes.surface.triangles) {
    const double quality = (tubes.quality[t[0]] + tubes.quality[t[1]] + tubes.quality[t[2]]) / 3.0;
    layer.face_quality.push_back(quality);
    layer.face_colour.push_back(paint.colour(quality));
  }
  for (const double quality : tubes.quality) layer.point_colour.push_back(paint.colour(quality));
  layer.points = std::move(tubes.surface.points);
  layer.triangles = std::move(tubes.surface.triangles);
  layer.point_quality = std::move(tubes.quality);
  return layer;
}

Layer circle_layer(const std::string& name, const GeodesicCircles& circles, const Legend& legend) {
  Layer layer;
  layer.name = name;
  for (Index c = 0; c < circles.polyline.size(); ++c) {
    const Row<Vec3> curve = circles.polyline[c];
    if (curve.size() < 3) continue;
    const double eccentricity = shown(circles.eccentricity[c]);
    const Index first = to_index(layer.points.size());
    const Index count = to_index(curve.size()) - 1;  // the last point repeats the first
    for (Index i = 0; i < count; ++i) {
      layer.points.push_back(curve[i]);
      layer.point_quality.push_back(eccentricity);
      layer.point_colour.push_back(legend.scale(eccentricity));
      layer.edges.push_back({first + i, first + (i + 1) % count});
    }
  }
  return layer;
}

}  // namespace mgf::plugin
