// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>

namespace cbvh::emulator {

/// A thread that does one thing after another, so that batches are computed while others travel.
template <class Result>
class Worker {
 public:
  Worker() = default;
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      tasks_.clear();
      ends_ = true;
    }
    changed_.notify_all();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Queues the work; what it returns or throws is in the future.
  std::future<Result> start(std::function<Result()> work) {
    std::packaged_task<Result()> task(std::move(work));
    std::future<Result> result = task.get_future();
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back(std::move(task));
    }
    changed_.notify_all();
    return result;
  }

  /// Drops what has not begun. What is being done goes on; nobody waits for it.
  void forget() {
    const std::lock_guard lock(mutex_);
    tasks_.clear();
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return ends_ || !tasks_.empty(); });
      if (ends_) return;
      std::packaged_task<Result()> task = std::move(tasks_.front());
      tasks_.pop_front();
      lock.unlock();
      task();
      lock.lock();
    }
  }

  std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::deque<std::packaged_task<Result()>> tasks_;
  bool ends_ = false;
  std::jthread thread_{[this] { run(); }};
};

}  // namespace cbvh::emulator
