// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/catalogue.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {

Filter export_files_filter() {
  using namespace parameters;
  Filter filter;
  filter.name = "Export Curve Skeleton Files";
  filter.python_name = "save_curve_skeleton_files";
  filter.effect = FilterEffect::kWritesFiles;
  filter.parameters = [] {
    std::vector<Parameter> all =
        with_input_parameters({output_folder(), coordinates_file(), theta(), prune(),
                               eccentricity_threshold(), marking_rule(), open_pockets()});
    all.push_back(threads());
    return all;
  }();
  filter.help = std::string("Export.") + kRequirement + kReference;
  filter.run = [](const FilterInput&) -> FilterOutput {
    throw InputError("not_available", "This filter is not finished.");
  };
  return filter;
}

}  // namespace mgf::plugin
