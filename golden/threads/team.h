// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <barrier>
#include <cstdint>
#include <functional>

namespace cbvh::golden {

/// One of several threads that do the same work together, step by step.
class TeamMember {
 public:
  TeamMember(unsigned index, unsigned size, std::barrier<>& barrier) : index_(index), size_(size), barrier_(&barrier) {}

  unsigned index() const { return index_; }
  unsigned size() const { return size_; }

  /// What is mine of `count` things: [first, last). The members' shares follow each other.
  struct Share {
    std::uint32_t first;
    std::uint32_t last;
  };
  Share share(std::uint32_t count) const {
    const auto until = [&](std::uint64_t members) { return static_cast<std::uint32_t>(count * members / size_); };
    return {until(index_), until(index_ + std::uint64_t{1})};
  }

  /// Until all have come here.
  void wait() const { barrier_->arrive_and_wait(); }

 private:
  unsigned index_;
  unsigned size_;
  std::barrier<>* barrier_;
};

/// Calls work on `threads` threads, at least one, of which the caller's is number 0, and waits for them. All must wait
/// equally often; an exception ends the program.
void run_team(unsigned threads, const std::function<void(const TeamMember&)>& work);

}  // namespace cbvh::golden
