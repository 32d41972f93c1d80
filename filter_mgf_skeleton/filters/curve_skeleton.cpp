// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter curve_skeleton_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Curve Skeleton (MGF)";
  filter.python_name = "generate_curve_skeleton";
  filter.effect = FilterEffect::kAddsLayers;
  filter.parameters =
      with_input_parameters({theta(), prune(), skeleton_quality(), marking_rule(), open_pockets()});
  filter.help = std::string("Curve skeleton.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
