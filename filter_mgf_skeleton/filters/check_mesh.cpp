// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter check_mesh_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Check Mesh for Curve Skeleton";
  filter.python_name = "get_curve_skeleton_diagnosis";
  filter.effect = FilterEffect::kSelects;
  filter.parameters = {};
  filter.help = std::string("Doctor.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
