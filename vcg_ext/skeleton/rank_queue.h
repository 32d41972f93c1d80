// SPDX-License-Identifier: GPL-3.0-or-later
// A priority queue of small integers: a tree of bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "vcg_ext/core/types.h"

namespace mgf {

/// A set of numbers below a bound, of which the least can be taken out. Both operations cost one
/// word a level, and 64^4 numbers have four levels.
class RankQueue {
 public:
  /// Empty, for numbers below `bound`.
  explicit RankQueue(std::size_t bound) {
    do {
      bound = (bound + kBits - 1) / kBits;
      levels_.emplace_back(bound, Word{0});
    } while (bound > 1);
  }

  bool empty() const { return levels_.back().empty() || levels_.back().front() == 0; }

  /// Adds a number; no effect if it is there.
  void push(Index number) {
    for (std::vector<Word>& level : levels_) {
      Word& word = level[number / kBits];
      const bool known_above = word != 0;
      word |= Word{1} << number % kBits;
      if (known_above) return;
      number /= kBits;
    }
  }

  /// Takes out the least number. Requires that there is one.
  Index pop() {
    Index number = 0;
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
      number = number * kBits + lowest_bit((*level)[number]);
    }
    Index at = number;
    for (std::vector<Word>& level : levels_) {
      Word& word = level[at / kBits];
      word &= ~(Word{1} << at % kBits);
      if (word != 0) break;
      at /= kBits;
    }
    return number;
  }

 private:
  using Word = std::uint64_t;
  static constexpr Index kBits = 64;

  /// Position of the lowest bit of a word that isn't 0.
  static Index lowest_bit(Word word) { return static_cast<Index>(__builtin_ctzll(word)); }

  std::vector<std::vector<Word>> levels_;  ///< a bit says whether the word below it has any
};

}  // namespace mgf
