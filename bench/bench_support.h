// SPDX-License-Identifier: GPL-3.0-or-later
// What the benchmark programs have in common: meshes from files, clocks, one line of JSON.
#pragma once

#include <sys/resource.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "bench/program.h"
#include "filter_mgf_skeleton/io/peak_memory.h"
#include "filter_mgf_skeleton/tools/file_mesh.h"
#include "vcg_ext/core/types.h"
#include "vcg_ext/medial/interior_tetrahedra.h"

namespace mgf::bench {

using Json = nlohmann::ordered_json;

/// A triangle mesh from an OFF, PLY, OBJ or STL file. Throws `std::runtime_error`.
inline TriangleSurface read_surface(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("can't open " + path.string());
  std::string bytes(std::filesystem::file_size(path), ' ');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const std::string extension = path.extension().string();
  const files::FileMesh mesh = extension == ".ply"   ? files::read_ply(bytes)
                               : extension == ".obj" ? files::read_obj(bytes)
                               : extension == ".stl" ? files::read_stl(bytes)
                                                     : files::read_off(bytes);
  TriangleSurface surface;
  for (const files::Point& p : mesh.points) surface.points.emplace_back(p[0], p[1], p[2]);
  surface.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  return surface;
}

/// As reports call a verdict.
inline const char* word(TopologyVerdict verdict) {
  switch (verdict) {
    case TopologyVerdict::kProven:
      return "proven";
    case TopologyVerdict::kCounted:
      return "counted";
    case TopologyVerdict::kFailed:
      return "failed";
  }
  return "";
}

/// Processor time of all threads of this process, user and system.
inline double cpu_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Wall and processor time since its making.
class Stopwatch {
 public:
  double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
  }
  double cpu() const { return cpu_seconds() - cpu_start_; }

 private:
  std::chrono::steady_clock::time_point wall_start_ = std::chrono::steady_clock::now();
  double cpu_start_ = cpu_seconds();
};

/// Prints `line` with the peak memory in one line.
inline void print_line(Json line) {
  line["peak_memory_mb"] = io::peak_memory_mb();
  std::cout << line.dump() << std::endl;
}

/// Prints what `measure` returns; see `guarded` for what it throws.
template <class Measure>
int report_line(const Measure& measure) {
  return guarded([&] { print_line(measure()); });
}

}  // namespace mgf::bench
