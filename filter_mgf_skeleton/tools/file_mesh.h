// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh file holds, in double precision and in the order of the file.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace mgf::files {

using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

struct FileMesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

/// The bytes aren't a mesh in the format that was asked for; `what()` says where and why.
class ParseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Each reads the bytes of one file. Throws ParseError on whatever is not as the format says, and
/// on faces that name a vertex the file doesn't have; polygons become triangles (`append_polygon`).
FileMesh read_off(const std::string& bytes);
FileMesh read_obj(const std::string& bytes);
FileMesh read_ply(const std::string& bytes);

/// STL repeats a vertex in each of its triangles: exactly equal points become one vertex, numbered
/// by first appearance.
FileMesh read_stl(const std::string& bytes);

/// Appends the polygon `corners` as its n - 2 triangles, by cutting ears (shortest diagonal first),
/// so that polygons that aren't convex keep their shape. The orientation is the polygon's. Throws
/// ParseError for fewer than three corners and for a corner that is no vertex of `mesh`. Cost:
/// O(n^3) at worst, for n corners.
void append_polygon(FileMesh& mesh, const std::vector<std::int64_t>& corners);

}  // namespace mgf::files
