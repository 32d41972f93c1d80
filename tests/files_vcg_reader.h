// SPDX-License-Identifier: GPL-3.0-or-later
// Reading back any property of a PLY file with vcglib's PLY library, which MeshLab reads with.
#pragma once

#include <wrap/ply/plylib.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace mgf::test {

/// One element of a PLY file, as vcglib's PLY library sees it.
class VcgPlyElement {
 public:
  VcgPlyElement(const std::filesystem::path& path, const std::string& element)
      : path_(path), element_(element) {}

  /// Names of the properties, in the file's order.
  std::vector<std::string> properties() const {
    vcg::ply::PlyFile file;
    open(file);
    std::vector<std::string> names;
    for (const vcg::ply::PlyProperty& property : file.elements[number_in(file)].props) {
      names.push_back(property.name);
    }
    return names;
  }

  /// The values of a scalar property of the PLY type that `Number` is.
  template <class Number>
  std::vector<Number> scalars(const std::string& property) const {
    vcg::ply::PlyFile file;
    open(file);
    const int type = ply_type(Number{});
    if (file.AddToRead(element_.c_str(), property.c_str(), type, type, 0, 0, 0, 0, 0, 0) < 0) {
      throw std::runtime_error(property + ": not there, or of another type");
    }
    std::vector<Number> values;
    read_rows<Number>(file, [&](const Number& value) { values.push_back(value); });
    return values;
  }

  /// The rows of a list of int counted by a byte.
  std::vector<std::vector<int>> lists(const std::string& property) const {
    struct List {
      std::array<int, 256> items;
      unsigned char size;
    };
    vcg::ply::PlyFile file;
    open(file);
    using vcg::ply::T_INT;
    using vcg::ply::T_UCHAR;
    if (file.AddToRead(element_.c_str(), property.c_str(), T_INT, T_INT, offsetof(List, items), 1,
                       0, T_UCHAR, T_UCHAR, offsetof(List, size)) < 0) {
      throw std::runtime_error(property + ": not there, or of another type");
    }
    std::vector<std::vector<int>> rows;
    read_rows<List>(file, [&](const List& list) {
      rows.emplace_back(list.items.begin(), list.items.begin() + list.size);
    });
    return rows;
  }

 private:
  static int ply_type(double /*of the type*/) { return vcg::ply::T_DOUBLE; }
  static int ply_type(int /*of the type*/) { return vcg::ply::T_INT; }
  static int ply_type(unsigned char /*of the type*/) { return vcg::ply::T_UCHAR; }

  void open(vcg::ply::PlyFile& file) const {
    if (file.Open(path_.c_str(), vcg::ply::PlyFile::MODE_READ) < 0) {
      throw std::runtime_error("vcglib can't open " + path_.string());
    }
  }

  std::size_t number_in(vcg::ply::PlyFile& file) const {
    for (std::size_t i = 0; i < file.elements.size(); ++i) {
      if (file.elements[i].name == element_) return i;
    }
    throw std::runtime_error("no element " + element_);
  }

  // Elements come one after the other: those before ours have to be passed over.
  template <class Row, class Take>
  void read_rows(vcg::ply::PlyFile& file, const Take& take) const {
    const std::size_t wanted = number_in(file);
    for (std::size_t i = 0; i <= wanted; ++i) {
      file.SetCurElement(static_cast<int>(i));
      for (int row = 0; row < file.ElemNumber(static_cast<int>(i)); ++row) {
        Row value{};
        if (file.Read(&value) < 0) throw std::runtime_error("vcglib can't read a row");
        if (i == wanted) take(value);
      }
    }
  }

  std::filesystem::path path_;
  std::string element_;
};

}  // namespace mgf::test
