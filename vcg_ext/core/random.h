// SPDX-License-Identifier: GPL-3.0-or-later
// Pseudo-random numbers that are the same on every machine and in every run.
#pragma once

#include <cstddef>
#include <cstdint>

#include "vcg_ext/core/types.h"

namespace mgf {

/// SplitMix64 (Steele, Lea & Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// A number in [0, bound). Requires bound > 0.
  Index below(std::size_t bound) { return static_cast<Index>(next() % bound); }

 private:
  std::uint64_t state_;
};

}  // namespace mgf
