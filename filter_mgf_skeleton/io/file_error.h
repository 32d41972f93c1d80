// SPDX-License-Identifier: GPL-3.0-or-later
// The one error of the file writers.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace mgf::io {

/// A file can't be written. `what()` is a sentence that names the file and the reason. Nothing of
/// the file is left behind, and an older file of that name is as it was.
class FileError : public std::runtime_error {
 public:
  FileError(std::filesystem::path path, const std::string& reason)
      : std::runtime_error("can't write '" + path.string() + "': " + reason),
        path_(std::move(path)) {}
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace mgf::io
