// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter medial_axis_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Medial Axis (Voronoi)";
  filter.python_name = "generate_medial_axis";
  filter.effect = FilterEffect::kAddsLayers;
  filter.parameters = with_input_parameters({});
  filter.help = std::string("Voronoi facets inside the mesh.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
