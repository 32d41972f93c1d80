// SPDX-License-Identifier: GPL-3.0-or-later
// Reads numbers of either byte order from the bytes of a mesh file.
#pragma once

#include <algorithm>
#include <cstring>
#include <string_view>

#include "filter_mgf_skeleton/tools/file_mesh.h"

namespace mgf::files {

enum class ByteOrder { kLittleEndian, kBigEndian };

inline ByteOrder machine_byte_order() {
  const std::uint16_t one = 1;
  char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1 ? ByteOrder::kLittleEndian : ByteOrder::kBigEndian;
}

class BinaryReader {
 public:
  /// `bytes` must outlive the reader.
  BinaryReader(std::string_view bytes, ByteOrder order)
      : bytes_(bytes), swap_(order != machine_byte_order()) {}

  template <class Number>
  Number next() {
    if (bytes_.size() - position_ < sizeof(Number)) {
      throw ParseError("the file ends at byte " + std::to_string(bytes_.size()) +
                       ", in the middle of its data");
    }
    char raw[sizeof(Number)];
    std::memcpy(raw, bytes_.data() + position_, sizeof(Number));
    if (swap_) std::reverse(raw, raw + sizeof(Number));
    position_ += sizeof(Number);
    Number value{};
    std::memcpy(&value, raw, sizeof(Number));
    return value;
  }

 private:
  std::string_view bytes_;
  bool swap_;
  std::size_t position_ = 0;
};

}  // namespace mgf::files
