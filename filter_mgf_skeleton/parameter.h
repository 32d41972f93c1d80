// SPDX-License-Identifier: GPL-3.0-or-later
// A filter's parameter described once: the description declares it to the host, reads it back,
// checks its range and prints the documentation's table.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace mgf::plugin {

/// How a parameter is asked for and what its value is.
enum class ParameterKind {
  kNumber,  ///< a real number
  kSlider,  ///< a real number, asked for by a slider
  kLength,  ///< a length in mesh units; default and range are fractions of the diagonal
  kCount,   ///< a whole number
  kChoice,  ///< one of `choices`; the value is its position
  kSwitch,  ///< yes or no
  kText,    ///< a path
};

/// The description of one parameter.
struct Parameter {
  std::string key;  ///< lowerCamelCase, frozen: scripts use it
  ParameterKind kind = ParameterKind::kNumber;
  double initial = 0.0;  ///< default; a fraction of the diagonal for a length, 0 or 1 for a switch
  double low = 0.0;      ///< smallest value allowed
  double high = 0.0;     ///< largest value allowed
  std::vector<std::string> choices;
  std::string label;    ///< a few words
  std::string tooltip;  ///< a sentence or two of plain text
};

/// What the user chose: key to value. Numbers and lengths are doubles, counts and choices ints.
class ParameterValues {
 public:
  using Value = std::variant<bool, int, double, std::string>;

  void set(const std::string& key, Value value) { values_[key] = std::move(value); }

  /// The value of a parameter. Throws `InputError` (parameter_missing) if it was never set, and
  /// (parameter_type) if it is of another type.
  double number(const Parameter& parameter) const;
  int count(const Parameter& parameter) const;
  bool yes(const Parameter& parameter) const;
  const std::string& text(const Parameter& parameter) const;

 private:
  template <class T>
  const T& get(const Parameter& parameter) const;

  std::map<std::string, Value> values_;
};

/// The default of a parameter for a mesh with bounding-box diagonal `diagonal`.
ParameterValues::Value initial_value(const Parameter& parameter, double diagonal);

/// Throws `InputError` (parameter_out_of_range) if `value` is not finite or outside the range,
/// which for a length is in units of `diagonal`.
void check_range(const Parameter& parameter, double value, double diagonal);

/// Checks all but the lengths: a script gives these in mesh units whatever the mesh, so they are
/// checked where they are used.
void check_ranges(const std::vector<Parameter>& parameters, const ParameterValues& values);

/// The parameters as a Markdown table: name, default, range, meaning.
std::string markdown_table(const std::vector<Parameter>& parameters);

}  // namespace mgf::plugin
