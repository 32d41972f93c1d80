// SPDX-License-Identifier: GPL-3.0-or-later
// Reads words and numbers from the text of a mesh file, and knows the line it is on.
#pragma once

#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>

#include "filter_mgf_skeleton/tools/file_mesh.h"

namespace mgf::files {

class TextScanner {
 public:
  /// `text` must outlive the scanner. From `comment` to the end of the line is skipped; 0: no
  /// comments.
  explicit TextScanner(std::string_view text, char comment = '#')
      : text_(text), comment_(comment) {}

  /// The next word on this line or a later one; empty at the end of the text.
  std::string_view word() {
    skip_blanks(true);
    return word_here();
  }

  /// The next word on this line; empty at its end.
  std::string_view word_on_line() {
    skip_blanks(false);
    return word_here();
  }

  /// Goes on to the start of the next line.
  void next_line() {
    while (position_ < text_.size() && text_[position_] != '\n') ++position_;
    if (position_ < text_.size()) step();
  }

  bool at_end() {
    skip_blanks(true);
    return position_ >= text_.size();
  }

  /// The next word as a number; `what` names it in the error. Takes `nan` and `inf`, which the
  /// diagnosis of the mesh reports better than a parser.
  double real(const char* what) { return parsed<double>(word(), what); }
  std::int64_t integer(const char* what) { return parsed<std::int64_t>(word(), what); }

  /// A number from all of `word`.
  template <class Number>
  Number parsed(std::string_view word, const char* what) const {
    if (word.empty()) fail(std::string("the file ends where ") + what + " should be");
    std::string_view digits = word;
    if (digits.front() == '+') digits.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if constexpr (std::is_floating_point_v<Number>) {
      // Beyond the range of double: 0 or infinity, which the diagnosis of the mesh reports.
      if (error == std::errc::result_out_of_range)
        return std::strtod(std::string(digits).c_str(), nullptr);
    }
    if (error != std::errc() || end != digits.data() + digits.size())
      fail(quoted(word) + " stands where " + what + " should be");
    return value;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError("line " + std::to_string(line_) + ": " + message);
  }

  std::size_t position() const { return position_; }

  /// A word for an error message, which must stay one line of text whatever the file holds.
  static std::string quoted(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    for (const char c : word.substr(0, kLongest))
      if (std::isprint(static_cast<unsigned char>(c)) == 0) return "something that is no text";
    return "'" + std::string(word.substr(0, kLongest)) + "'";
  }

 private:
  static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
  }

  void step() {
    if (text_[position_] == '\n') ++line_;
    ++position_;
  }

  void skip_blanks(bool across_lines) {
    while (position_ < text_.size()) {
      const char c = text_[position_];
      if (c == comment_ && comment_ != 0) {
        while (position_ < text_.size() && text_[position_] != '\n') ++position_;
      } else if (is_blank(c) || (across_lines && c == '\n')) {
        step();
      } else {
        return;
      }
    }
  }

  std::string_view word_here() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]) && text_[position_] != '\n')
      ++position_;
    return text_.substr(begin, position_ - begin);
  }

  std::string_view text_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

}  // namespace mgf::files
