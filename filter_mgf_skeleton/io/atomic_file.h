// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all.
#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "filter_mgf_skeleton/io/file_error.h"

namespace mgf::io {

/// Collects bytes in a hidden file beside `path`; `commit` puts it in the place of `path` in one
/// step, after the bytes are on the disk. Without `commit` the hidden file is removed. Every member
/// throws `FileError`.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path) : path_(std::move(path)) { open_temporary(); }
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile(AtomicFile&&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile() { discard(); }

  const std::filesystem::path& path() const { return path_; }

  void append(std::string_view bytes) {
    buffer_.append(bytes);
    if (buffer_.size() >= kBufferSize) flush();
  }

  void commit() {
    flush();
    if (::fsync(descriptor_) != 0) fail(errno);
    const int descriptor = std::exchange(descriptor_, kClosed);
    if (::close(descriptor) != 0) fail(errno);
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    temporary_.clear();
    sync_folder();
  }

 private:
  static constexpr std::size_t kBufferSize = std::size_t{1} << 20;
  static constexpr int kClosed = -1;

  [[noreturn]] void fail(int error) const {
    throw FileError(path_, std::generic_category().message(error));
  }

  std::filesystem::path folder() const {
    return path_.has_parent_path() ? path_.parent_path() : std::filesystem::path(".");
  }

  // The name holds the process number, so that two runs that write the same file can't meet; the
  // counter passes over what a killed run has left.
  void open_temporary() {
    const std::string stem =
        "." + path_.filename().string() + "." + std::to_string(::getpid()) + "-";
    for (int attempt = 0; descriptor_ == kClosed; ++attempt) {
      const std::filesystem::path name = folder() / (stem + std::to_string(attempt) + ".part");
      descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ != kClosed) {
        temporary_ = name;
      } else if (errno != EEXIST) {
        fail(errno);
      }
    }
  }

  void flush() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
      const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
      if (written >= 0) {
        rest.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno != EINTR) {
        fail(errno);
      }
    }
    buffer_.clear();
  }

  // Makes the new name durable. Some file systems can't sync a folder; the file is whole all the
  // same, so that is no failure.
  void sync_folder() const {
    const int descriptor = ::open(folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor == kClosed) return;
    ::fsync(descriptor);
    ::close(descriptor);
  }

  void discard() {
    if (descriptor_ != kClosed) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }

  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty once it has become `path_`
  std::string buffer_;
  int descriptor_ = kClosed;
};

}  // namespace mgf::io
