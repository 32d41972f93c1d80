// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: its `v` and `f` lines; all else (normals, textures, groups, lines) is passed over.
#include "filter_mgf_skeleton/tools/text_scanner.h"

namespace mgf::files {
namespace {

/// Lines that end in a backslash go on in the next one. Blanks take the place of both characters,
/// so that line numbers in errors are too small only behind such a line.
std::string joined_lines(std::string text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    const std::size_t end = text.compare(at + 1, 2, "\r\n") == 0 ? at + 2 : at + 1;
    if (end < text.size() && text[end] == '\n') text.replace(at, end - at + 1, end - at + 1, ' ');
  }
  return text;
}

/// The vertex of a corner `v`, `v/t`, `v//n` or `v/t/n`, numbered from 0. In the file numbers begin
/// at 1, and negative ones count back from the newest vertex.
std::int64_t corner_vertex(const TextScanner& scanner, std::string_view corner,
                           std::size_t points_so_far) {
  const std::string_view digits = corner.substr(0, corner.find('/'));
  if (digits.empty()) scanner.fail(TextScanner::quoted(corner) + " names no vertex");
  const auto number = scanner.parsed<std::int64_t>(digits, "a vertex number");
  if (number == 0) scanner.fail("a face names vertex 0, but OBJ numbers them from 1");
  return number > 0 ? number - 1 : static_cast<std::int64_t>(points_so_far) + number;
}

struct FaceLine {
  TextScanner scanner;  ///< stands on the line, for errors
  std::vector<std::int64_t> corners;
};

}  // namespace

FileMesh read_obj(const std::string& bytes) {
  const std::string text = joined_lines(bytes);
  FileMesh mesh;
  std::vector<FaceLine> faces;  // a face may stand before its vertices
  TextScanner scanner(text);
  while (!scanner.at_end()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "v") {
      Point& point = mesh.points.emplace_back();
      for (double& coordinate : point) {
        const std::string_view word = scanner.word_on_line();
        if (word.empty()) scanner.fail("a vertex has fewer than three coordinates");
        coordinate = scanner.parsed<double>(word, "a coordinate");
      }
    } else if (keyword == "f") {
      std::vector<std::int64_t> corners;
      for (std::string_view word = scanner.word_on_line(); !word.empty();
           word = scanner.word_on_line())
        corners.push_back(corner_vertex(scanner, word, mesh.points.size()));
      faces.push_back({scanner, std::move(corners)});
    }
    scanner.next_line();
  }
  for (const FaceLine& face : faces) {
    try {
      append_polygon(mesh, face.corners);
    } catch (const ParseError& error) {
      face.scanner.fail(error.what());
    }
  }
  return mesh;
}

}  // namespace mgf::files
