// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/core/parallel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <future>
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

TEST(ParallelFor, CallsTheFirstWorkerOnTheCallersThread) {
  const std::thread::id caller = std::this_thread::get_id();
  parallel_for(1000, 4, 1, [&](std::size_t, unsigned worker) {
    EXPECT_EQ(std::this_thread::get_id() == caller, worker == 0);
  });
}

TEST(ParallelFor, MayBeNestedAndCalledFromManyThreads) {
  std::vector<std::vector<int>> calls(8, std::vector<int>(100, 0));
  const auto work = [&](std::size_t first) {
    parallel_for(4, 4, 1, [&](std::size_t i, unsigned) {
      std::vector<int>& row = calls[first + i];
      parallel_for(row.size(), 4, 1, [&](std::size_t j, unsigned) { ++row[j]; });
    });
  };
  std::thread other(work, 4);
  work(0);
  other.join();
  EXPECT_EQ(calls, std::vector<std::vector<int>>(8, std::vector<int>(100, 1)));
}

TEST(ParallelBeside, WorksOnTheCallersThread) {
  for (const unsigned threads : {1U, 2U}) {
    std::thread::id working;
    bool has_run_beside = false;
    parallel_beside(
        threads, [&] { working = std::this_thread::get_id(); }, [&] { has_run_beside = true; });
    EXPECT_EQ(working, std::this_thread::get_id());
    EXPECT_TRUE(has_run_beside);
  }
}

TEST(ParallelBeside, RunsBothAtTheSameTime) {
  std::promise<void> begun;
  std::future_status status{};
  parallel_beside(
      2, [&] { status = begun.get_future().wait_for(std::chrono::minutes(1)); },
      [&] { begun.set_value(); });
  EXPECT_EQ(status, std::future_status::ready);
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
