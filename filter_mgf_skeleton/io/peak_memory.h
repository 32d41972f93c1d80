// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory the process has used.
#pragma once

#include <sys/resource.h>

namespace mgf::io {

/// Largest resident size of this process so far, in units of 2^20 bytes.
inline double peak_memory_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in units of 2^10 bytes
}

}  // namespace mgf::io
