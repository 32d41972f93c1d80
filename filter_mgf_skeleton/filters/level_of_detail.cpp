// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter level_of_detail_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Curve Skeleton Level of Detail";
  filter.python_name = "generate_curve_skeleton_level_of_detail";
  filter.effect = FilterEffect::kAddsLayers;
  filter.parameters = {theta_slider(), prune_slider(), skeleton_quality()};
  filter.help = std::string("Level of detail.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
