// SPDX-License-Identifier: GPL-3.0-or-later
// A filter as the host shows it and runs it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/layer.h"
#include "filter_mgf_skeleton/parameter.h"
#include "vcg_ext/core/progress.h"
#include "vcg_ext/core/types.h"

namespace mgf::plugin {

class Workbench;

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

/// Checks the parameters and runs the filter; turns every exception into a failure, and selects
/// the faces and vertices that are to blame when the input is.
FilterOutcome run_filter(const Filter& filter, const FilterInput& input) noexcept;

}  // namespace mgf::plugin
