// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter medial_geodesic_function_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Medial Geodesic Function";
  filter.python_name = "compute_scalar_by_medial_geodesic_function_per_face";
  filter.effect = FilterEffect::kPaintsAndAddsLayers;
  filter.parameters = with_input_parameters({});
  filter.help = std::string("MGF.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
