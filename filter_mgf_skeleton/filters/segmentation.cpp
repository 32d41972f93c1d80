// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter segmentation_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Tubular and Flat Segmentation (Geodesic Circles)";
  filter.python_name = "compute_scalar_by_tubular_and_flat_segmentation_per_face";
  filter.effect = FilterEffect::kPaintsAndAddsLayers;
  filter.parameters =
      with_input_parameters({eccentricity_threshold(), segmentation_quality(), theta(), prune()});
  filter.help = std::string("Segmentation.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
