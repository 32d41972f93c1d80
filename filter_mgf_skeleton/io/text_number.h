// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text that reads back as the same number, whatever the locale.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <string>

#include "filter_mgf_skeleton/io/table.h"

namespace mgf::io {

/// The shortest decimal that gives `value` again. Requires a finite value.
inline std::string to_text(double value) {
  constexpr std::size_t kLongest = 32;  // "-1.2345678901234567e-308" is 24
  std::array<char, kLongest> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// A table's number as text; throws as `checked_value`.
inline std::string to_text(const Table& table, const Column& column, std::size_t row,
                           const std::filesystem::path& path) {
  const double value = checked_value(table, column, row, path);
  return column.type == NumberType::kReal ? to_text(value)
                                          : std::to_string(static_cast<long>(value));
}

}  // namespace mgf::io
