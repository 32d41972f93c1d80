// SPDX-License-Identifier: GPL-3.0-or-later
// Named columns of numbers: what the writers of PLY, VTP, GraphML and CSV have in common.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "filter_mgf_skeleton/io/file_error.h"
#include "vcg_ext/core/types.h"

namespace mgf::io {

/// How a column is stored.
enum class NumberType {
  kReal,     ///< 64-bit floating point
  kInteger,  ///< 32 bits, signed
  kByte,     ///< 8 bits, unsigned
};

/// A named column; `value(row)` gives the number, which a double holds exactly for every type.
/// Columns refer to the arrays they were made from and must not outlive them.
struct Column {
  std::string name;
  NumberType type = NumberType::kReal;
  std::function<double(std::size_t)> value;
};

/// Columns of one length.
struct Table {
  std::string name;
  std::size_t rows = 0;
  std::vector<Column> columns;
};

/// What stands in an integer column where there is nothing to point to.
inline constexpr double kNothing = -1.0;

inline Column real_column(std::string name, std::function<double(std::size_t)> value) {
  return {std::move(name), NumberType::kReal, std::move(value)};
}

inline Column real_column(std::string name, const std::vector<double>& values) {
  return real_column(std::move(name), [&values](std::size_t row) { return values.at(row); });
}

/// A positive measure that degenerate geometry leaves without a finite value (the circumcircle of
/// three collinear points): then the column holds 0.
inline Column measure_column(std::string name, const std::vector<double>& values) {
  return real_column(std::move(name), [&values](std::size_t row) {
    const double value = values.at(row);
    return std::isfinite(value) ? value : 0.0;
  });
}

/// A length of paths on the surface, infinite where none joins their ends, which lie on separate
/// pieces of a surface that crosses itself: then the column holds 0.
inline Column path_length_column(std::string name, const std::vector<double>& values) {
  return real_column(std::move(name), [&values](std::size_t row) {
    const double value = values.at(row);
    return value == std::numeric_limits<double>::infinity() ? 0.0 : value;
  });
}

/// Index columns are integers; kNone becomes `kNothing`.
inline Column index_column(std::string name, std::function<Index(std::size_t)> value) {
  return {std::move(name), NumberType::kInteger, [value = std::move(value)](std::size_t row) {
            const Index index = value(row);
            return index == kNone ? kNothing : static_cast<double>(index);
          }};
}

inline Column index_column(std::string name, const std::vector<Index>& values) {
  return index_column(std::move(name), [&values](std::size_t row) { return values.at(row); });
}

/// Appends the columns PREFIXx PREFIXy PREFIXz.
inline void add_vector_columns(const std::string& prefix, const std::vector<Vec3>& vectors,
                               std::vector<Column>& columns) {
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::string name = prefix + "xyz"[axis];
    columns.push_back(
        real_column(name, [&vectors, axis](std::size_t row) { return vectors.at(row)[axis]; }));
  }
}

/// The number in a row of a column, if its type can hold it. Throws `FileError`, in the name of the
/// file at `path`, for a number that is infinite, NaN or out of range: no reader would know what to
/// make of it.
inline double checked_value(const Table& table, const Column& column, std::size_t row,
                            const std::filesystem::path& path) {
  const double value = column.value(row);
  const bool fits = column.type == NumberType::kReal ? std::isfinite(value)
                    : column.type == NumberType::kInteger
                        ? value >= std::numeric_limits<std::int32_t>::min() &&
                              value <= std::numeric_limits<std::int32_t>::max()
                        : value >= 0.0 && value <= std::numeric_limits<std::uint8_t>::max();
  if (fits) return value;
  throw FileError(path, table.name + " " + std::to_string(row) + ": " + column.name + " is " +
                            std::to_string(value));
}

}  // namespace mgf::io
