// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/core/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mgf::test {
namespace {

TEST(ParallelFor, CallsEachOnceWithAnyThreads) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    std::vector<int> calls(1000, 0);
    parallel_for(calls.size(), threads, 16, [&](std::size_t i, unsigned worker) {
      EXPECT_LT(worker, threads);
      ++calls[i];
    });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
  }
}

TEST(ParallelFor, ThrowsOnWhatIsThrownInIt) {
  const auto fail = [](std::size_t i, unsigned) {
    if (i == 500) throw std::runtime_error("five hundred");
  };
  EXPECT_THROW(parallel_for(1000, 2, 16, fail), std::runtime_error);
}

TEST(ParallelBeside, WorksOnTheCallersThread) {
  for (const unsigned threads : {1U, 2U}) {
    std::thread::id working;
    std::thread::id beside;
    parallel_beside(
        threads, [&] { working = std::this_thread::get_id(); },
        [&] { beside = std::this_thread::get_id(); });
    EXPECT_EQ(working, std::this_thread::get_id());
    EXPECT_EQ(beside == working, threads == 1);
  }
}

TEST(ParallelBeside, EndsBothBeforeItThrowsOn) {
  const auto fail = [] { throw std::runtime_error("no"); };
  bool ended = false;
  const auto end = [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ended = true;
  };
  EXPECT_THROW(parallel_beside(2, fail, end), std::runtime_error);
  EXPECT_TRUE(ended);
  ended = false;
  EXPECT_THROW(parallel_beside(2, end, fail), std::runtime_error);
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace mgf::test
