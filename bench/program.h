// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of a benchmark program: wrong usage ends it with status 2, failure with 1.
#pragma once

#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>

namespace mgf::bench {

/// Runs `work`, and turns what it throws into a message and exit status 1.
template <class Work>
int guarded(const Work& work) {
  try {
    work();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

/// Hands what `parse` makes of the command line on to `work`. `parse` throws at an unknown word,
/// number or option, whichever it is: then `usage` is printed.
template <class Parse, class Work>
int run_program(const char* usage, const Parse& parse, const Work& work) {
  std::optional<decltype(parse())> arguments;
  try {
    arguments = parse();
  } catch (const std::exception&) {
    std::cerr << usage;
    return 2;
  }
  return guarded([&] { work(*arguments); });
}

}  // namespace mgf::bench
