// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace cbvh::testbench {

/// A bar on stderr, only when that is a terminal and only once the work has lasted a second. Threads may step it
/// together.
class Progress {
 public:
  Progress(std::string title, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(std::uint64_t amount = 1);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(std::uint64_t done);

  std::string title_;
  std::uint64_t total_;
  bool enabled_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::uint64_t> done_ = 0;
  std::mutex mutex_;  ///< of what follows
  Clock::time_point drawn_ = start_;
  bool visible_ = false;
};

}  // namespace cbvh::testbench
