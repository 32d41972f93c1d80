// SPDX-License-Identifier: GPL-3.0-or-later
// OFF and its variants with colours, normals and texture coordinates (COFF, NOFF, STOFF), as text.
#include "filter_mgf_skeleton/tools/text_scanner.h"

namespace mgf::files {
namespace {

/// Goes past the header word, if there is one: the word is optional in the format.
void skip_header(TextScanner& scanner) {
  TextScanner ahead = scanner;
  const std::string_view header = ahead.word();
  if (header.size() < 3 || header.substr(header.size() - 3) != "OFF") return;
  if (header.find_first_of("4n") != std::string_view::npos)
    scanner.fail(TextScanner::quoted(header) + ": only OFF in three dimensions can be read");
  scanner = ahead;
  if (ahead.word_on_line() == "BINARY") scanner.fail("binary OFF can't be read; save it as text");
}

std::size_t count(TextScanner& scanner, const char* what) {
  const std::int64_t value = scanner.integer(what);
  if (value < 0) scanner.fail(std::string("negative: ") + what);
  return static_cast<std::size_t>(value);
}

}  // namespace

FileMesh read_off(const std::string& bytes) {
  TextScanner scanner(bytes);
  skip_header(scanner);
  const std::size_t points = count(scanner, "the number of vertices");
  const std::size_t faces = count(scanner, "the number of faces");
  scanner.next_line();  // the number of edges, which nobody needs

  FileMesh mesh;
  for (std::size_t i = 0; i < points; ++i) {
    Point& point = mesh.points.emplace_back();
    for (double& coordinate : point) coordinate = scanner.real("a coordinate");
    scanner.next_line();  // normal, colour, texture coordinates
  }
  std::vector<std::int64_t> corners;
  for (std::size_t i = 0; i < faces; ++i) {
    corners.resize(count(scanner, "the number of corners of a face"));
    for (std::int64_t& corner : corners) corner = scanner.integer("a vertex number");
    try {
      append_polygon(mesh, corners);
    } catch (const ParseError& error) {
      scanner.fail(error.what());
    }
    scanner.next_line();  // colour
  }
  return mesh;
}

}  // namespace mgf::files
