// SPDX-License-Identifier: GPL-3.0-or-later
// filter_script FILTER [KEY=VALUE...]: the MeshLab script (.mlx) that runs the filter with these
// values, and with the defaults of all its other parameters. MeshLab 2020.09 ends itself over a
// script that leaves a parameter out, so scripts are never written by hand.
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/filter.h"

namespace {

using mgf::plugin::Filter;
using mgf::plugin::Parameter;
using mgf::plugin::ParameterKind;
using Given = std::map<std::string, std::string>;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + escaped(value) + "\"";
}

std::string attribute(const std::string& name, double value) {
  std::ostringstream text;
  text << value;
  return attribute(name, text.str());
}

const char* host_type(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kNumber:
      return "RichFloat";
    case ParameterKind::kSlider:
      return "RichDynamicFloat";
    case ParameterKind::kLength:
      return "RichAbsPerc";
    case ParameterKind::kCount:
      return "RichInt";
    case ParameterKind::kChoice:
      return "RichEnum";
    case ParameterKind::kSwitch:
      return "RichBool";
    case ParameterKind::kText:
      return "RichString";
  }
  throw std::logic_error("unknown kind of parameter");
}

/// Whether `text` is a value of the parameter's kind and range. Lengths are in mesh units and have
/// no range here.
void check_value(const Parameter& parameter, const std::string& text) {
  if (parameter.kind == ParameterKind::kText) return;
  if (parameter.kind == ParameterKind::kSwitch) {
    if (text != "true" && text != "false")
      throw std::invalid_argument(parameter.key + " must be true or false, not '" + text + "'");
    return;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0')
    throw std::invalid_argument(parameter.key + " must be a number, not '" + text + "'");
  if (parameter.kind != ParameterKind::kLength &&
      !(value >= parameter.low && value <= parameter.high)) {
    std::ostringstream message;
    message << parameter.key << " must be from " << parameter.low << " to " << parameter.high
            << ", not " << text;
    throw std::invalid_argument(message.str());
  }
}

std::string initial_text(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::kText) return "";
  if (parameter.kind == ParameterKind::kSwitch) return parameter.initial != 0.0 ? "true" : "false";
  std::ostringstream text;
  text << parameter.initial;
  return text.str();
}

std::string parameter_line(const Parameter& parameter, const Given& given) {
  const auto found = given.find(parameter.key);
  const std::string value = found != given.end() ? found->second : initial_text(parameter);
  check_value(parameter, value);
  std::string line = "  <Param" + attribute("type", host_type(parameter.kind)) +
                     attribute("name", parameter.key) + attribute("value", value);
  if (parameter.kind == ParameterKind::kSlider)
    line += attribute("min", parameter.low) + attribute("max", parameter.high);
  if (parameter.kind == ParameterKind::kLength)
    line += attribute("min", 0.0) + attribute("max", 1.0);
  if (parameter.kind == ParameterKind::kChoice) {
    line += attribute("enum_cardinality", std::to_string(parameter.choices.size()));
    for (std::size_t i = 0; i < parameter.choices.size(); ++i)
      line += attribute("enum_val" + std::to_string(i), parameter.choices[i]);
  }
  return line + attribute("description", parameter.label) +
         attribute("tooltip", parameter.tooltip) + "/>\n";
}

/// A filter with the values given for it.
struct Step {
  const Filter* filter;
  Given given;
};

std::string script(const std::vector<Step>& steps) {
  std::string text = "<!DOCTYPE FilterScript>\n<FilterScript>\n";
  for (const Step& step : steps) {
    text += " <filter" + attribute("name", step.filter->name) + ">\n";
    for (const Parameter& parameter : step.filter->parameters)
      text += parameter_line(parameter, step.given);
    text += " </filter>\n";
  }
  return text + "</FilterScript>\n";
}

const Filter& filter_named(const std::string& name) {
  for (const Filter& filter : mgf::plugin::all_filters())
    if (filter.name == name) return filter;
  throw std::invalid_argument("there is no filter '" + name + "'");
}

void require_parameter(const Filter& filter, const std::string& key) {
  for (const Parameter& parameter : filter.parameters)
    if (parameter.key == key) return;
  throw std::invalid_argument("'" + filter.name + "' has no parameter '" + key + "'");
}

/// Words without '=' name filters, the others give values to the filter before them.
std::vector<Step> parsed_steps(const std::vector<std::string>& words) {
  std::vector<Step> steps;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      steps.push_back({&filter_named(word), {}});
    } else if (steps.empty()) {
      throw std::invalid_argument("'" + word + "' comes before any filter");
    } else {
      const std::string key = word.substr(0, equals);
      require_parameter(*steps.back().filter, key);
      steps.back().given[key] = word.substr(equals + 1);
    }
  }
  return steps;
}

}  // namespace

int main(int argument_count, char** arguments) {
  try {
    if (argument_count < 2) {
      std::cerr << "usage: filter_script FILTER [KEY=VALUE...]...; the filters are:\n";
      for (const Filter& filter : mgf::plugin::all_filters())
        std::cerr << "  " << filter.name << '\n';
      return 2;
    }
    std::cout << script(parsed_steps({arguments + 1, arguments + argument_count}));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
