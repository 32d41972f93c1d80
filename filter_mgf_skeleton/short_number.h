// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for sentences.
#pragma once

#include <cstdio>
#include <string>

namespace mgf::plugin {

/// The number with at most five digits that count.
inline std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

}  // namespace mgf::plugin
