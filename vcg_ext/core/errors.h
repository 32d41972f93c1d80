// SPDX-License-Identifier: GPL-3.0-or-later
// The few errors that leave the library, and the warnings that come with a result.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mgf {

/// The input can't be served. `what()` says what is wrong, where, and what to do, in sentences for
/// the mesh's owner; `code` is the same in one stable snake_case word for scripts.
class InputError : public std::runtime_error {
 public:
  InputError(std::string code, const std::string& message)
      : std::runtime_error(message), code_(std::move(code)) {}
  const std::string& code() const { return code_; }

 private:
  std::string code_;
};

/// The user asked to stop; thrown by `Progress::report`.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Something the user should know about a result that was delivered all the same.
struct Warning {
  std::string code;     ///< stable, snake_case
  std::string message;  ///< a sentence
};
using Warnings = std::vector<Warning>;

}  // namespace mgf
