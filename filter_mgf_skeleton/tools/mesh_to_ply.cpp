// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_to_ply INPUT OUTPUT.ply: a PLY, OFF, STL or OBJ file as triangles in a binary PLY file with
// double coordinates. MeshLab 2020.09 reads the formats unevenly (it aborts on OBJ), and in floats.
#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "filter_mgf_skeleton/tools/binary_reader.h"
#include "filter_mgf_skeleton/tools/file_mesh.h"

namespace {

using mgf::files::FileMesh;

std::string read_bytes(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw std::runtime_error("there is no such file");
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw std::runtime_error("the file can't be opened");
  std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw std::runtime_error("the file can't be read");
  if (bytes.empty()) throw std::runtime_error("the file is empty");
  return bytes;
}

FileMesh read_mesh(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  FileMesh (*read)(const std::string&) = nullptr;
  if (extension == ".ply") read = mgf::files::read_ply;
  if (extension == ".off") read = mgf::files::read_off;
  if (extension == ".stl") read = mgf::files::read_stl;
  if (extension == ".obj") read = mgf::files::read_obj;
  if (read == nullptr) throw std::runtime_error("the name doesn't end in .ply, .off, .stl or .obj");
  return read(read_bytes(path));
}

template <class Number>
void append(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(Number));
}

std::string ply_bytes(const FileMesh& mesh) {
  const bool little = mgf::files::machine_byte_order() == mgf::files::ByteOrder::kLittleEndian;
  std::string bytes = std::string("ply\nformat binary_") + (little ? "little" : "big") +
                      "_endian 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const mgf::files::Point& point : mesh.points)
    for (const double coordinate : point) append(bytes, coordinate);
  for (const mgf::files::Triangle& triangle : mesh.triangles) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) append(bytes, static_cast<std::int32_t>(corner));
  }
  return bytes;
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("can't write " + path.string());
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::cerr << "usage: mesh_to_ply INPUT OUTPUT.ply\n";
    return 2;
  }
  try {
    write_bytes(arguments[2], ply_bytes(read_mesh(arguments[1])));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
