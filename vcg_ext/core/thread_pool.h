// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that are kept from one parallel loop to the next: to start one takes as long as many a
// loop.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace mgf {

/// Threads that help whoever asks, as far as they are free. Calls may come from any thread, and be
/// nested.
class ThreadPool {
 public:
  /// The one that all loops share. Its threads are started when they are first wanted.
  static ThreadPool& shared() {
    static ThreadPool pool;
    return pool;
  }

  ThreadPool() = default;
  ThreadPool(const ThreadPool&) = delete;  // its threads refer to it
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_ending_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  /// Calls `work(0)` here and `work(1)` to `work(workers - 1)` on other threads at the same time.
  /// Those that no thread was free for by the end of `work(0)` are left out: it has to do all there
  /// is to do by itself if nobody helps. Returns when all have ended. `work` must not throw.
  void run(unsigned workers, const std::function<void(unsigned)>& work) {
    Job job{work, 1, workers, 0};
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      while (threads_.size() + 1 < workers) threads_.emplace_back([this] { help(); });
      if (workers > 1) jobs_.push_back(&job);
    }
    wake_.notify_all();
    work(0);
    std::unique_lock<std::mutex> lock(mutex_);
    jobs_.erase(std::remove(jobs_.begin(), jobs_.end(), &job), jobs_.end());
    ended_.wait(lock, [&] { return job.running == 0; });
  }

 private:
  struct Job {
    const std::function<void(unsigned)>& work;
    unsigned next;  ///< worker to be
    unsigned workers;
    unsigned running;  ///< besides the one who asked
  };

  /// What each thread does.
  void help() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      wake_.wait(lock, [this] { return is_ending_ || !jobs_.empty(); });
      if (is_ending_) return;
      Job& job = *jobs_.front();
      const unsigned worker = job.next++;
      if (job.next == job.workers) jobs_.pop_front();
      ++job.running;
      lock.unlock();
      job.work(worker);
      lock.lock();
      if (--job.running == 0) ended_.notify_all();
    }
  }

  std::mutex mutex_;  // of all below
  std::condition_variable wake_;
  std::condition_variable ended_;
  std::deque<Job*> jobs_;  // with workers still to be taken on
  bool is_ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace mgf
