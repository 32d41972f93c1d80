// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/parameter_bridge.h"

#include "vcg_ext/core/errors.h"

namespace mgf::plugin {
namespace {

QString qt(const std::string& text) {
  return QString::fromStdString(text);
}

QStringList qt(const std::vector<std::string>& texts) {
  QStringList list;
  for (const std::string& text : texts) list << qt(text);
  return list;
}

/// Single precision would show 0.699999988 for 0.7: the shortest decimal is what the user sees.
double shortest(float value) {
  return QString::number(value, 'g', 6).toDouble();
}

[[noreturn]] void wrong_type(const Parameter& parameter) {
  throw InputError("parameter_type", "The parameter '" + parameter.key +
                                         "' is given with another type than the filter declares.");
}

ParameterValues::Value value_of(const Parameter& parameter, const Value& value) {
  // A value asked for with the wrong getter stops the program, so each is asked for its type first.
  switch (parameter.kind) {
    case ParameterKind::kNumber:
      if (value.isFloat()) return shortest(value.getFloat());
      break;
    case ParameterKind::kSlider:
      if (value.isDynamicFloat()) return shortest(value.getDynamicFloat());
      break;
    case ParameterKind::kLength:
      if (value.isAbsPerc()) return static_cast<double>(value.getAbsPerc());
      break;
    case ParameterKind::kCount:
      if (value.isInt()) return value.getInt();
      break;
    case ParameterKind::kChoice:
      if (value.isEnum()) return value.getEnum();
      break;
    case ParameterKind::kSwitch:
      if (value.isBool()) return value.getBool();
      break;
    case ParameterKind::kText:
      if (value.isString()) return value.getString().toStdString();
      break;
  }
  wrong_type(parameter);
}

}  // namespace

void declare_parameters(const std::vector<Parameter>& parameters, double diagonal,
                        RichParameterList& list) {
  for (const Parameter& p : parameters) {
    const QString key = qt(p.key);
    const QString label = qt(p.label);
    const QString tooltip = qt(p.tooltip);
    const auto initial = static_cast<float>(p.initial);
    const auto low = static_cast<float>(p.low);
    const auto high = static_cast<float>(p.high);
    const auto unit = static_cast<float>(diagonal);
    switch (p.kind) {
      case ParameterKind::kNumber:
        list.addParam(RichFloat(key, initial, label, tooltip));
        break;
      case ParameterKind::kSlider:
        list.addParam(RichDynamicFloat(key, initial, low, high, label, tooltip));
        break;
      case ParameterKind::kLength:
        list.addParam(RichLength(key, initial * unit, 0.0F, unit, label, tooltip));
        break;
      case ParameterKind::kCount:
        list.addParam(RichInt(key, static_cast<int>(p.initial), label, tooltip));
        break;
      case ParameterKind::kChoice:
        list.addParam(RichEnum(key, static_cast<int>(p.initial), qt(p.choices), label, tooltip));
        break;
      case ParameterKind::kSwitch:
        list.addParam(RichBool(key, p.initial != 0.0, label, tooltip));
        break;
      case ParameterKind::kText:
        list.addParam(RichString(key, QString(), label, tooltip));
        break;
    }
  }
}

ParameterValues read_parameters(const std::vector<Parameter>& parameters,
                                const RichParameterList& list) {
  ParameterValues values;
  for (const Parameter& parameter : parameters) {
    const QString key = qt(parameter.key);
    if (!list.hasParameter(key)) {
      throw InputError("parameter_missing", "The parameter '" + parameter.key + "' is missing.");
    }
    values.set(parameter.key, value_of(parameter, list.getParameterByName(key).value()));
  }
  return values;
}

}  // namespace mgf::plugin
