// SPDX-License-Identifier: GPL-3.0-or-later
// STL, binary and text.
#include <unordered_map>

#include "filter_mgf_skeleton/tools/binary_reader.h"
#include "filter_mgf_skeleton/tools/text_scanner.h"

namespace mgf::files {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

struct PointHash {
  std::size_t operator()(const Point& point) const {
    std::size_t hash = 0;
    for (const double coordinate : point)
      hash = hash * 0x9E3779B97F4A7C15ULL + std::hash<double>()(coordinate);
    return hash;
  }
};

/// Gives equal points one number.
class Welder {
 public:
  std::uint32_t vertex(FileMesh& mesh, const Point& point) {
    const auto [entry, is_new] =
        numbers_.emplace(point, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back(point);
    return entry->second;
  }

 private:
  std::unordered_map<Point, std::uint32_t, PointHash> numbers_;
};

std::uint32_t triangle_count(const std::string& bytes) {
  return BinaryReader(std::string_view(bytes).substr(kHeaderBytes), ByteOrder::kLittleEndian)
      .next<std::uint32_t>();
}

/// A binary file may begin with `solid` as text does, and then its length tells.
bool is_binary(const std::string& bytes) {
  if (bytes.size() < kHeaderBytes + sizeof(std::uint32_t)) return false;
  const std::size_t expected =
      kHeaderBytes + sizeof(std::uint32_t) + kTriangleBytes * triangle_count(bytes);
  TextScanner scanner(bytes, 0);
  return bytes.size() == expected || scanner.word() != "solid";
}

FileMesh read_binary(const std::string& bytes) {
  FileMesh mesh;
  Welder welder;
  BinaryReader reader(std::string_view(bytes).substr(kHeaderBytes), ByteOrder::kLittleEndian);
  const auto triangles = reader.next<std::uint32_t>();
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (int coordinate = 0; coordinate < 3; ++coordinate) reader.next<float>();  // normal
    Triangle triangle{};
    for (std::uint32_t& corner : triangle) {
      Point point{};
      for (double& coordinate : point) coordinate = static_cast<double>(reader.next<float>());
      corner = welder.vertex(mesh, point);
    }
    mesh.triangles.push_back(triangle);
    reader.next<std::uint16_t>();  // attributes
  }
  return mesh;
}

FileMesh read_text(const std::string& bytes) {
  FileMesh mesh;
  Welder welder;
  TextScanner scanner(bytes, 0);
  if (scanner.word() != "solid") scanner.fail("'solid' should stand here");
  scanner.next_line();
  while (!scanner.at_end()) {
    if (scanner.word() != "facet") {  // endsolid, or solid again
      scanner.next_line();
      continue;
    }
    scanner.next_line();  // normal
    scanner.next_line();  // outer loop
    Triangle triangle{};
    for (std::uint32_t& corner : triangle) {
      if (scanner.word() != "vertex") scanner.fail("'vertex' should stand here");
      Point point{};
      for (double& coordinate : point) coordinate = scanner.real("a coordinate");
      corner = welder.vertex(mesh, point);
    }
    if (scanner.word() != "endloop") scanner.fail("'endloop' should stand here");
    if (scanner.word() != "endfacet") scanner.fail("'endfacet' should stand here");
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

}  // namespace

FileMesh read_stl(const std::string& bytes) {
  return is_binary(bytes) ? read_binary(bytes) : read_text(bytes);
}

}  // namespace mgf::files
