// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"
#include "filter_mgf_skeleton/reporting.h"
#include "filter_mgf_skeleton/result_layers.h"

namespace mgf::plugin {
namespace {

Layer function_layer(const MedialAxis& axis, const MedialGeodesicField& field,
                     const Legend& legend) {
  FacetLayer facets = facet_layer("medial geodesic function", axis);
  Layer& layer = facets.layer;
  std::array<Attribute, 3> gradient{{{"gradient_x", {}}, {"gradient_y", {}}, {"gradient_z", {}}}};
  for (const Index f : facets.facet) {
    const double value = shown(field.mgf[f]);
    layer.face_quality.push_back(value);
    layer.face_colour.push_back(legend.scale(value));
    for (int i = 0; i < 3; ++i) {
      gradient[static_cast<std::size_t>(i)].values.push_back(field.gradient[f][i]);
    }
  }
  layer.face_attributes.insert(layer.face_attributes.end(), gradient.begin(), gradient.end());
  return layer;
}

/// The local girth on the user's faces and vertices; 0 on what was left out.
Paint girth_paint(const TriangleSurface& mesh, const MedialAxis& axis,
                  const MedialGeodesicField& field, const Legend& legend) {
  const SurfaceGirth girth = surface_girth(axis, field);
  Paint paint;
  for (const Index f : faces_speaking_for(mesh, axis.working)) {
    const double value = f == kNone ? 0.0 : girth.of_face[f];
    paint.face_quality.push_back(value);
    paint.face_colour.push_back(f == kNone ? io::kUnlabelledColour : legend.scale(value));
  }
  for (const Index v : axis.working.vertex_of_input) {
    paint.point_quality.push_back(v == kNone ? 0.0 : girth.of_vertex[v]);
  }
  return paint;
}

FilterOutput make_medial_geodesic_function(const FilterInput& input) {
  const Study study = input.workbench.study(
      input.mesh, {parameters::medial_axis_options(input.values, input.mesh), {}, {}},
      Stage::kField, input.progress);
  const MedialGeodesicField& field = study.function->field;
  const Legend legend = make_legend("medial geodesic function", field.mgf);
  FilterOutput output;
  output.layers.push_back(function_layer(*study.axis, field, legend));
  output.paint = girth_paint(input.mesh, *study.axis, field, legend);
  output.notes.push_back(legend.sentence);
  report_medial_axis(*study.axis, output);
  report_medial_geodesic_function(field, output);
  return output;
}

}  // namespace

Filter medial_geodesic_function_filter() {
  Filter filter;
  filter.name = "Medial Geodesic Function";
  filter.python_name = "compute_scalar_by_medial_geodesic_function_per_face";
  filter.effect = FilterEffect::kPaintsAndAddsLayers;
  filter.parameters = parameters::with_input_parameters({});
  filter.help =
      std::string(
          "Computes the <b>medial geodesic function</b> (MGF): at each point of the medial axis "
          "the length of the shortest path on the surface between the two points where the "
          "largest ball around it touches. It is exact on the mesh, and proven so path by "
          "path.<br>"
          "Adds a layer with the medial axis, its face quality the MGF, red where it is large and "
          "blue where it is small; and gives each face and vertex of the mesh, as quality, the "
          "largest MGF of the facets that touch it: the local girth of the shape (half of it, "
          "for a round limb). Faces are coloured in the same way.") +
      kRequirement + kReference;
  filter.run = make_medial_geodesic_function;
  return filter;
}

}  // namespace mgf::plugin
