// SPDX-License-Identifier: GPL-3.0-or-later
// Binary little-endian PLY from columns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "filter_mgf_skeleton/io/atomic_file.h"
#include "filter_mgf_skeleton/io/table.h"
#include "vcg_ext/core/types.h"

namespace mgf::io {

/// A list property: row i of the element holds the numbers `items(i)`.
struct ListColumn {
  std::string name;
  std::function<Row<Index>(std::size_t)> items;
};

/// An element of a PLY file: its list, if it has one, comes before the table's columns.
struct PlyElement {
  Table table;
  std::optional<ListColumn> list;
};

namespace ply_detail {

inline const char* type_name(NumberType type) {
  switch (type) {
    case NumberType::kReal:
      return "double";
    case NumberType::kInteger:
      return "int";
    case NumberType::kByte:
      return "uchar";
  }
  return "";
}

// Little-endian bytes on any machine: by value, not by memory.
template <class Unsigned>
void append_bytes(Unsigned value, std::string& bytes) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
  }
}

inline void append_number(double value, NumberType type, std::string& bytes) {
  if (type == NumberType::kReal) {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    append_bytes(bits, bytes);
  } else if (type == NumberType::kInteger) {
    append_bytes(static_cast<std::uint32_t>(static_cast<std::int32_t>(value)), bytes);
  } else {
    append_bytes(static_cast<std::uint8_t>(value), bytes);
  }
}

// A byte counts the items of a list wherever that is enough: some readers know nothing else.
inline NumberType count_type(const PlyElement& element) {
  for (std::size_t row = 0; row < element.table.rows; ++row) {
    if (element.list->items(row).size() > std::numeric_limits<std::uint8_t>::max()) {
      return NumberType::kInteger;
    }
  }
  return NumberType::kByte;
}

inline std::string header(const std::string& comment, const std::vector<PlyElement>& elements) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + comment + "\n";
  for (const PlyElement& element : elements) {
    text += "element " + element.table.name + " " + std::to_string(element.table.rows) + "\n";
    if (element.list) {
      text += std::string("property list ") + type_name(count_type(element)) + " int " +
              element.list->name + "\n";
    }
    for (const Column& column : element.table.columns) {
      text += std::string("property ") + type_name(column.type) + " " + column.name + "\n";
    }
  }
  return text + "end_header\n";
}

inline void append_rows(const PlyElement& element, AtomicFile& file) {
  const NumberType counter = element.list ? count_type(element) : NumberType::kByte;
  std::string bytes;
  for (std::size_t row = 0; row < element.table.rows; ++row) {
    bytes.clear();
    if (element.list) {
      const Row<Index> items = element.list->items(row);
      append_number(static_cast<double>(items.size()), counter, bytes);
      for (const Index item : items) append_number(item, NumberType::kInteger, bytes);
    }
    for (const Column& column : element.table.columns) {
      append_number(checked_value(element.table, column, row, file.path()), column.type, bytes);
    }
    file.append(bytes);
  }
}

}  // namespace ply_detail

/// Writes `elements` in their order, with one comment line. Throws `FileError`.
inline void write_ply(const std::filesystem::path& path, const std::string& comment,
                      const std::vector<PlyElement>& elements) {
  AtomicFile file(path);
  file.append(ply_detail::header(comment, elements));
  for (const PlyElement& element : elements) ply_detail::append_rows(element, file);
  file.commit();
}

/// The element `vertex` with x, y, z; more columns may be added.
inline PlyElement vertex_element(const std::vector<Vec3>& points) {
  PlyElement element{{"vertex", points.size(), {}}, std::nullopt};
  add_vector_columns("", points, element.table.columns);
  return element;
}

/// The element `face` with the list `vertex_indices`; columns may be added.
inline PlyElement face_element(const std::vector<Triangle>& triangles) {
  return {{"face", triangles.size(), {}},
          ListColumn{"vertex_indices", [&triangles](std::size_t f) {
                       const Triangle& corners = triangles.at(f);
                       return Row<Index>(corners.data(), corners.data() + corners.size());
                     }}};
}

}  // namespace mgf::io
