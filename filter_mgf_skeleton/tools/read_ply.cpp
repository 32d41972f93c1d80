// SPDX-License-Identifier: GPL-3.0-or-later
// PLY, text and binary: the elements `vertex` and `face`, of any number types; all else is passed
// over.
#include <cmath>
#include <functional>
#include <optional>

#include "filter_mgf_skeleton/tools/binary_reader.h"
#include "filter_mgf_skeleton/tools/text_scanner.h"

namespace mgf::files {
namespace {

enum class NumberType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct Property {
  std::string name;
  NumberType type = NumberType::kFloat32;
  std::optional<NumberType> length_type;  ///< set: the property is a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::optional<ByteOrder> binary;  ///< none: text
  std::vector<Element> elements;
};

NumberType number_type(const TextScanner& scanner, std::string_view name) {
  if (name == "char" || name == "int8") return NumberType::kInt8;
  if (name == "uchar" || name == "uint8") return NumberType::kUint8;
  if (name == "short" || name == "int16") return NumberType::kInt16;
  if (name == "ushort" || name == "uint16") return NumberType::kUint16;
  if (name == "int" || name == "int32") return NumberType::kInt32;
  if (name == "uint" || name == "uint32") return NumberType::kUint32;
  if (name == "float" || name == "float32") return NumberType::kFloat32;
  if (name == "double" || name == "float64") return NumberType::kFloat64;
  scanner.fail(TextScanner::quoted(name) + " is no number type of PLY");
}

std::optional<ByteOrder> format(const TextScanner& scanner, std::string_view name) {
  if (name == "ascii") return std::nullopt;
  if (name == "binary_little_endian") return ByteOrder::kLittleEndian;
  if (name == "binary_big_endian") return ByteOrder::kBigEndian;
  scanner.fail(TextScanner::quoted(name) + " is no format of PLY");
}

Element read_element(TextScanner& scanner) {
  Element element;
  element.name = scanner.word_on_line();
  const auto count = scanner.parsed<std::int64_t>(scanner.word_on_line(), "a number of elements");
  if (count < 0) scanner.fail("a negative number of elements");
  element.count = static_cast<std::size_t>(count);
  return element;
}

Property read_property(TextScanner& scanner) {
  Property property;
  std::string_view type = scanner.word_on_line();
  if (type == "list") {
    property.length_type = number_type(scanner, scanner.word_on_line());
    type = scanner.word_on_line();
  }
  property.type = number_type(scanner, type);
  property.name = scanner.word_on_line();
  return property;
}

/// Leaves `scanner` on the line behind the header.
Header read_header(TextScanner& scanner) {
  if (scanner.word() != "ply") scanner.fail("'ply' should stand here");
  scanner.next_line();
  Header header;
  for (std::string_view keyword = scanner.word(); keyword != "end_header";
       keyword = scanner.word()) {
    if (keyword == "format") {
      header.binary = format(scanner, scanner.word_on_line());
    } else if (keyword == "element") {
      header.elements.push_back(read_element(scanner));
    } else if (keyword == "property") {
      if (header.elements.empty()) scanner.fail("a property stands before any element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword != "comment" && keyword != "obj_info") {
      scanner.fail(TextScanner::quoted(keyword) + " has no meaning in the header of a PLY file");
    }
    scanner.next_line();
  }
  scanner.next_line();
  return header;
}

/// The next number of the data, whatever its type.
using NextNumber = std::function<double(NumberType)>;

NextNumber from_text(TextScanner scanner) {
  return [scanner](NumberType) mutable { return scanner.real("a number"); };
}

NextNumber from_binary(BinaryReader reader) {
  return [reader](NumberType type) mutable -> double {
    switch (type) {
      case NumberType::kInt8:
        return reader.next<std::int8_t>();
      case NumberType::kUint8:
        return reader.next<std::uint8_t>();
      case NumberType::kInt16:
        return reader.next<std::int16_t>();
      case NumberType::kUint16:
        return reader.next<std::uint16_t>();
      case NumberType::kInt32:
        return reader.next<std::int32_t>();
      case NumberType::kUint32:
        return reader.next<std::uint32_t>();
      case NumberType::kFloat32:
        return static_cast<double>(reader.next<float>());
      case NumberType::kFloat64:
        return reader.next<double>();
    }
    throw ParseError("unknown number type");
  };
}

std::size_t list_length(const Property& property, const NextNumber& next) {
  if (!property.length_type) return 1;
  const double length = next(*property.length_type);
  if (!(length >= 0)) throw ParseError("a list has a negative length");
  return static_cast<std::size_t>(length);
}

void read_vertices(const Element& element, const NextNumber& next, FileMesh& mesh) {
  for (std::size_t i = 0; i < element.count; ++i) {
    Point& point = mesh.points.emplace_back();
    for (const Property& property : element.properties) {
      const std::size_t length = list_length(property, next);
      for (std::size_t k = 0; k < length; ++k) {
        const double value = next(property.type);
        if (property.name == "x") point[0] = value;
        if (property.name == "y") point[1] = value;
        if (property.name == "z") point[2] = value;
      }
    }
  }
}

constexpr double kLargestVertexNumber = 4294967295.0;

std::int64_t vertex_number(double value) {
  if (!(std::abs(value) <= kLargestVertexNumber) || value != std::trunc(value))
    throw ParseError("a face names a vertex by something that is no whole number");
  return static_cast<std::int64_t>(value);
}

/// The polygons as they stand: they may come before the vertices.
std::vector<std::vector<std::int64_t>> read_faces(const Element& element, const NextNumber& next) {
  std::vector<std::vector<std::int64_t>> faces;
  for (std::size_t i = 0; i < element.count; ++i) {
    std::vector<std::int64_t>& corners = faces.emplace_back();
    for (const Property& property : element.properties) {
      const bool is_corners = property.name == "vertex_indices" || property.name == "vertex_index";
      const std::size_t length = list_length(property, next);
      for (std::size_t k = 0; k < length; ++k) {
        const double value = next(property.type);
        if (is_corners) corners.push_back(vertex_number(value));
      }
    }
  }
  return faces;
}

void skip_element(const Element& element, const NextNumber& next) {
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const Property& property : element.properties) {
      for (std::size_t left = list_length(property, next); left > 0; --left) next(property.type);
    }
  }
}

bool has_property(const Element& element, std::string_view name) {
  for (const Property& property : element.properties)
    if (property.name == name) return true;
  return false;
}

}  // namespace

FileMesh read_ply(const std::string& bytes) {
  TextScanner scanner(bytes, 0);
  const Header header = read_header(scanner);
  const std::string_view data = std::string_view(bytes).substr(scanner.position());
  const NextNumber next =
      header.binary ? from_binary(BinaryReader(data, *header.binary)) : from_text(scanner);

  FileMesh mesh;
  std::vector<std::vector<std::int64_t>> faces;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") {
      if (!has_property(element, "x") || !has_property(element, "y") || !has_property(element, "z"))
        throw ParseError("the vertices have no x, y and z");
      read_vertices(element, next, mesh);
    } else if (element.name == "face") {
      faces = read_faces(element, next);
    } else {
      if (element.name == "tristrips")
        throw ParseError("triangle strips can't be read; save the mesh with faces");
      skip_element(element, next);
    }
  }
  for (const std::vector<std::int64_t>& corners : faces) append_polygon(mesh, corners);
  return mesh;
}

}  // namespace mgf::files
