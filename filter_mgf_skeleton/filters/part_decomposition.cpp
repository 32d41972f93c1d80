// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter part_decomposition_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Part Decomposition by Curve Skeleton";
  filter.python_name = "compute_scalar_by_curve_skeleton_branch_per_face";
  filter.effect = FilterEffect::kPaintsInput;
  filter.parameters = with_input_parameters({theta(), prune()});
  filter.help = std::string("Parts.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
