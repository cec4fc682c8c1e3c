// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace cbvh::testbench {

namespace {
constexpr auto kSilence = std::chrono::seconds(1);
constexpr auto kPeriod = std::chrono::milliseconds(100);
constexpr std::uint64_t kWidth = 40;
}  // namespace

Progress::Progress(std::string title, std::uint64_t total)
    : title_(std::move(title)), total_(std::max<std::uint64_t>(total, 1)), enabled_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void Progress::step(std::uint64_t amount) {
  const std::uint64_t done = done_ += amount;
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (now - start_ < kSilence || now - drawn_ < kPeriod) return;
  drawn_ = now;
  draw(std::min(done, total_));
}

void Progress::draw(std::uint64_t done) {
  visible_ = true;
  const auto filled = static_cast<std::size_t>(done * kWidth / total_);
  fmt::print(stderr, "\r{} [{}{}] {:3d} %", title_, std::string(filled, '#'), std::string(kWidth - filled, ' '),
             done * 100 / total_);
  std::fflush(stderr);
}

}  // namespace cbvh::testbench
