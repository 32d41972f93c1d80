// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_mgf_skeleton/precise_coordinates.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "filter_mgf_skeleton/tools/file_mesh.h"
#include "vcg_ext/core/errors.h"

namespace mgf::plugin {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw InputError("coordinates_file",
                   "The coordinates file '" + path + "' can't be used: " + reason);
}

std::string lower_case_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

files::FileMesh read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse(path, "it can't be opened.");
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  const std::string extension = lower_case_extension(path);
  if (extension != ".ply" && extension != ".off") refuse(path, "it is neither PLY nor OFF.");
  try {
    return extension == ".ply" ? files::read_ply(bytes) : files::read_off(bytes);
  } catch (const files::ParseError& error) {
    refuse(path, error.what());
  }
}

bool same_in_single_precision(double precise, double single) {
  // Not a number, or too large: no fault of the file. The diagnosis tells.
  if (!std::isfinite(single)) return !(std::abs(precise) <= std::numeric_limits<float>::max());
  return std::abs(precise - single) <= std::numeric_limits<float>::epsilon() * std::abs(precise) +
                                           std::numeric_limits<float>::min();
}

}  // namespace

TriangleSurface with_precise_coordinates(TriangleSurface mesh, const std::string& path) {
  const files::FileMesh file = read_file(path);
  if (file.points.size() != mesh.points.size()) {
    refuse(path, "it has " + std::to_string(file.points.size()) + " vertices, the layer has " +
                     std::to_string(mesh.points.size()) + ".");
  }
  for (std::size_t v = 0; v < file.points.size(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      double& coordinate = mesh.points[v][static_cast<Eigen::Index>(i)];
      if (!same_in_single_precision(file.points[v][i], coordinate)) {
        refuse(path, "its vertex " + std::to_string(v) + " isn't where the layer's is.");
      }
      if (std::isfinite(coordinate)) coordinate = file.points[v][i];
    }
  }
  return mesh;
}

}  // namespace mgf::plugin
