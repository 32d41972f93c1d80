// SPDX-License-Identifier: GPL-3.0-or-later
// A filter as the host shows it and runs it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/layer.h"
#include "filter_mgf_skeleton/parameter.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"

namespace mgf::plugin {

class Workbench;

/// An empty one, for hosts that need know no more of it.
std::shared_ptr<Workbench> make_workbench();

/// What a filter works on.
struct FilterInput {
  const TriangleSurface& mesh;  ///< the current layer's vertices and faces, in their order
  std::string name;             ///< of that layer
  const ParameterValues& values;
  Workbench& workbench;  ///< results of former runs
  const Progress& progress;
};

/// What a filter does to the document, and so the menus it stands in.
enum class FilterEffect {
  kAddsLayers,
  kReplacesLayers,  ///< its own of a former run; quick enough to follow a slider
  kPaintsInput,
  kPaintsAndAddsLayers,
  kSelects,
  kWritesFiles,
};

/// One entry of the Filters menu.
struct Filter {
  std::string name;         ///< menu text and script key: frozen
  std::string python_name;  ///< for hosts that have one: frozen
  std::string help;         ///< HTML
  FilterEffect effect = FilterEffect::kAddsLayers;
  std::vector<Parameter> parameters;
  /// Computes the output. Throws `InputError` or `Cancelled`, and then nothing has changed.
  std::function<FilterOutput(const FilterInput&)> run;
};

/// All filters, in menu order.
const std::vector<Filter>& all_filters();

/// Why a filter failed.
struct Failure {
  std::string code;
  std::string message;
};

/// How a run ended: with a failure (then the output has only a selection and notes), or without.
struct FilterOutcome {
  FilterOutput output;
  std::optional<Failure> failure;
};

/// Checks the parameters and runs the filter; turns its exceptions into a failure, and selects the
/// faces and vertices that are to blame when the mesh is.
FilterOutcome run_filter(const Filter& filter, const FilterInput& input);

}  // namespace mgf::plugin
