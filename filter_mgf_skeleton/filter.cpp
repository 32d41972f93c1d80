// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/filter.h"

#include <new>

#include "filter_mgf_skeleton/culprits.h"
#include "filter_mgf_skeleton/filters/filters.h"

namespace mgf::plugin {
namespace {

FilterOutcome failed(std::string code, std::string message) {
  FilterOutcome outcome;
  outcome.failure = Failure{std::move(code), std::move(message)};
  return outcome;
}

/// Selects the faces and vertices to blame if it is the mesh that was refused.
FilterOutcome blamed(const InputError& error, const TriangleSurface& mesh) {
  FilterOutcome outcome = failed(error.code(), error.what());
  const Diagnosis diagnosis = diagnose(mesh);
  const Finding* finding = diagnosis.find(error.code());
  if (finding != nullptr && finding->severity == Severity::kFatal) {
    outcome.output.selection = culprits(diagnosis);
  }
  return outcome;
}

}  // namespace

const std::vector<Filter>& all_filters() {
  static const std::vector<Filter> filters = {
      medial_axis_filter(),     medial_geodesic_function_filter(),
      curve_skeleton_filter(),  segmentation_filter(),
      level_of_detail_filter(), part_decomposition_filter(),
      check_mesh_filter(),      export_files_filter(),
  };
  return filters;
}

FilterOutcome run_filter(const Filter& filter, const FilterInput& input) {
  try {
    check_ranges(filter.parameters, input.values);
    return {filter.run(input), std::nullopt};
  } catch (const InputError& error) {
    return blamed(error, input.mesh);
  } catch (const Cancelled&) {
    return failed("cancelled", "Stopped as you asked; nothing has changed.");
  } catch (const std::bad_alloc&) {
    return failed("out_of_memory", "There is not enough memory for a mesh of this size.");
  } catch (const std::exception& error) {
    return failed("internal_error",
                  std::string("This should not happen, please report it: ") + error.what());
  }
}

}  // namespace mgf::plugin
