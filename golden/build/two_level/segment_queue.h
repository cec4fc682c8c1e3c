// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "golden/build/two_level/rebraid.h"

namespace cbvh::golden {

/// Segments from which threads take work: what one of them splits, any may go on with. Small ones stay with the thread
/// that made them.
class SegmentQueue {
 public:
  static constexpr std::uint32_t kSmall = 128;  ///< places

  explicit SegmentQueue(const Segment& whole) : waiting_{whole}, unfinished_(1) {}

  /// Builds until nothing is left: `build` makes two segments of one, or none.
  template <class Build>
  void work(Build build) {
    std::vector<Segment> own;
    Segment segment;
    while (take(segment)) {
      own.assign(1, segment);
      while (!own.empty()) {
        segment = own.back();
        own.pop_back();
        if (const auto halves = build(segment)) {
          for (const Segment& half : *halves) {
            if (half.end - half.first <= kSmall) {
              own.push_back(half);
            } else {
              give(half);
            }
          }
        }
      }
      finish();
    }
  }

 private:
  bool take(Segment& segment) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !waiting_.empty() || unfinished_ == 0; });
    if (waiting_.empty()) return false;
    segment = waiting_.back();
    waiting_.pop_back();
    return true;
  }
  void give(const Segment& segment) {
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(segment);
      ++unfinished_;
    }
    changed_.notify_one();
  }
  void finish() {
    const std::lock_guard lock(mutex_);
    if (--unfinished_ == 0) changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Segment> waiting_;
  std::uint64_t unfinished_;  ///< given and not finished
};

/// Builds a whole segment with `threads` threads; make_build() gives each its own function.
template <class MakeBuild>
void run_segments(const Segment& whole, int threads, const MakeBuild& make_build) {
  SegmentQueue queue(whole);
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads; ++i) helpers.emplace_back([&queue, &make_build] { queue.work(make_build()); });
  queue.work(make_build());
}

}  // namespace cbvh::golden
