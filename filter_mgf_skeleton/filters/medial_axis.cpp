// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/reporting.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

FilterOutput make_medial_axis(const FilterInput& input) {
  const Study study = input.workbench.study(
      input.mesh, {parameters::medial_axis_options(input.values, input.mesh), {}, {}},
      Stage::kMedialAxis, input.progress);
  FilterOutput output;
  Layer layer = facet_layer("medial axis", *study.axis).layer;
  const Legend legend = make_legend("radius", layer.point_quality);
  for (const double radius : layer.point_quality) {
    layer.point_colour.push_back(legend.scale(radius));
  }
  output.layers.push_back(std::move(layer));
  output.notes.push_back(legend.sentence);
  output.notes.emplace_back(kHideNote);
  report_medial_axis(*study.axis, output);
  return output;
}

}  // namespace

Filter medial_axis_filter() {
  Filter filter;
  filter.name = "Medial Axis (Voronoi)";
  filter.python_name = "generate_medial_axis_by_voronoi";
  filter.effect = FilterEffect::kAddsLayers;
  filter.parameters = parameters::with_input_parameters({});
  filter.help =
      std::string(
          "Adds a layer with the <b>medial axis</b> of the solid that the mesh bounds: the facets "
          "of the Voronoi diagram of its vertices that lie inside, as polygons. The quality of "
          "each vertex is its radius, the distance to the surface. Each facet keeps the two "
          "vertices of the mesh that it lies halfway between (the face attributes contact_a and "
          "contact_b).<br>"
          "The medial axis has the topology of the solid, which is checked and told in the log.") +
      kRequirement + kReference;
  filter.run = make_medial_axis;
  return filter;
}

}  // namespace mgf::plugin
