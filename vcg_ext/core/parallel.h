// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel work whose results can't depend on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "vcg_ext/core/thread_pool.h"

namespace mgf {

/// The number of threads to use for a wish of `requested` (0: all the machine has).
inline unsigned thread_count(unsigned requested) {
  return requested != 0 ? requested : std::max(1U, std::thread::hardware_concurrency());
}

namespace detail {

/// Throws the first of the exceptions caught, if any.
template <class Failures>
void rethrow_first(const Failures& failures) {
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace detail

/// Calls `body(i, worker)` once for each i in [0, count), in chunks taken by `threads` workers in
/// no fixed order; `worker` in [0, threads) names the worker's own workspace, and is 0 on the
/// caller's thread. The result is the same for any number of threads if `body(i, ·)` writes only
/// what belongs to i. An exception stops the loop and is rethrown here after all workers have
/// ended.
template <class Body>
void parallel_for(std::size_t count, unsigned threads, std::size_t chunk, const Body& body) {
  threads = static_cast<unsigned>(std::min<std::size_t>(
      threads, std::max<std::size_t>(1, count / std::max<std::size_t>(chunk, 1))));
  if (threads <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i, 0U);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::vector<std::exception_ptr> failures(threads);
  ThreadPool::shared().run(threads, [&](unsigned worker) {
    try {
      while (!stop) {
        const std::size_t first = next.fetch_add(chunk);
        if (first >= count) return;
        const std::size_t last = std::min(count, first + chunk);
        for (std::size_t i = first; i < last; ++i) body(i, worker);
      }
    } catch (...) {
      failures[worker] = std::current_exception();
      stop = true;
    }
  });
  detail::rethrow_first(failures);
}

/// Calls `work` on this thread and, if another is free, `beside` on that at the same time; else one
/// after the other. What reports progress belongs in `work`. An exception of either is rethrown
/// here after both have ended.
template <class Work, class Beside>
void parallel_beside(unsigned threads, const Work& work, const Beside& beside) {
  if (thread_count(threads) <= 1) {
    work();
    beside();
    return;
  }
  std::atomic<bool> is_taken{false};
  std::array<std::exception_ptr, 2> failures;
  ThreadPool::shared().run(2, [&](unsigned worker) {
    try {
      if (worker == 0) work();
    } catch (...) {
      failures[0] = std::current_exception();
    }
    if (is_taken.exchange(true)) return;
    try {
      beside();
    } catch (...) {
      failures[1] = std::current_exception();
    }
  });
  detail::rethrow_first(failures);
}

}  // namespace mgf
