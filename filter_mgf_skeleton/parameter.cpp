// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/parameter.h"

#include <algorithm>
#include <cmath>

#include "filter_mgf_skeleton/short_number.h"
#include "vcg_ext/core/errors.h"

namespace mgf::plugin {
namespace {

std::string described(const Parameter& parameter, double value) {
  switch (parameter.kind) {
    case ParameterKind::kSwitch:
      return value != 0.0 ? "yes" : "no";
    case ParameterKind::kChoice:
      return parameter.choices[static_cast<std::size_t>(value)];
    case ParameterKind::kLength:
      return short_number(100.0 * value) + " % of the diagonal";
    case ParameterKind::kText:
      return "empty";
    default:
      return short_number(value);
  }
}

std::string described_range(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::kSwitch:
      return "yes, no";
    case ParameterKind::kText:
      return "a path";
    case ParameterKind::kChoice: {
      std::string all;
      for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        all += (i == 0 ? "" : ", ") + std::to_string(i) + " = " + parameter.choices[i];
      }
      return all;
    }
    default:
      return described(parameter, parameter.low) + " to " + described(parameter, parameter.high);
  }
}

bool has_fixed_range(const Parameter& parameter) {
  return parameter.kind != ParameterKind::kText && parameter.kind != ParameterKind::kSwitch &&
         parameter.kind != ParameterKind::kLength;
}

double as_number(const Parameter& parameter, const ParameterValues& values) {
  const bool whole =
      parameter.kind == ParameterKind::kCount || parameter.kind == ParameterKind::kChoice;
  return whole ? values.count(parameter) : values.number(parameter);
}

}  // namespace

template <class T>
const T& ParameterValues::get(const Parameter& parameter) const {
  const auto found = values_.find(parameter.key);
  if (found == values_.end()) {
    throw InputError("parameter_missing", "The parameter '" + parameter.key + "' is missing.");
  }
  if (const T* value = std::get_if<T>(&found->second)) return *value;
  throw InputError("parameter_type", "The parameter '" + parameter.key +
                                         "' is given with another type than the filter declares.");
}

double ParameterValues::number(const Parameter& parameter) const {
  return get<double>(parameter);
}
int ParameterValues::count(const Parameter& parameter) const {
  return get<int>(parameter);
}
bool ParameterValues::yes(const Parameter& parameter) const {
  return get<bool>(parameter);
}
const std::string& ParameterValues::text(const Parameter& parameter) const {
  return get<std::string>(parameter);
}

ParameterValues::Value initial_value(const Parameter& parameter, double diagonal) {
  switch (parameter.kind) {
    case ParameterKind::kSwitch:
      return parameter.initial != 0.0;
    case ParameterKind::kCount:
    case ParameterKind::kChoice:
      return static_cast<int>(parameter.initial);
    case ParameterKind::kText:
      return std::string();
    case ParameterKind::kLength:
      return parameter.initial * diagonal;
    default:
      return parameter.initial;
  }
}

void check_range(const Parameter& parameter, double value, double diagonal) {
  // Hosts pass single precision: a value typed as the limit may come back a rounding beyond it.
  constexpr double kRounding = 1e-6;
  const double unit = parameter.kind == ParameterKind::kLength ? diagonal : 1.0;
  const double slack = kRounding * std::max(std::abs(parameter.low), std::abs(parameter.high));
  if (std::isfinite(value) && value >= (parameter.low - slack) * unit &&
      value <= (parameter.high + slack) * unit) {
    return;
  }
  throw InputError("parameter_out_of_range",
                   "The parameter '" + parameter.key + "' (" + parameter.label + ") is " +
                       short_number(value) + " but must be in " + described_range(parameter) + ".");
}

void check_ranges(const std::vector<Parameter>& parameters, const ParameterValues& values) {
  for (const Parameter& parameter : parameters) {
    if (has_fixed_range(parameter)) check_range(parameter, as_number(parameter, values), 1.0);
  }
}

std::string markdown_table(const std::vector<Parameter>& parameters) {
  std::string table = "| parameter | default | range | meaning |\n|---|---|---|---|\n";
  for (const Parameter& parameter : parameters) {
    table += "| `" + parameter.key + "` | " + described(parameter, parameter.initial) + " | " +
             described_range(parameter) + " | **" + parameter.label + ".** " + parameter.tooltip +
             " |\n";
  }
  return table;
}

}  // namespace mgf::plugin
