// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "rtl_model/kernel/commit_key.h"

namespace cbvh::rtl {

/// A chain of Length registers with valid bits that moves as a whole or holds as a whole. Kept as a ring: moving on is
/// one step of an index.
template <class T, std::size_t Length>
class Pipeline {
  static_assert(Length >= 1);

 public:
  Pipeline() = default;
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  bool output_valid() const { return valid_[oldest_]; }
  const T& output() const { return stages_[oldest_]; }
  bool empty() const { return occupied_ == 0; }

  /// Moves on in this cycle: the output leaves, `value` enters. Without shift() or bubble() the chain holds.
  void shift(const T& value) {
    next_ = value;
    moves_ = next_valid_ = true;
  }
  void bubble() {
    moves_ = true;
    next_valid_ = false;
  }

  void commit(CommitKey) {
    if (!moves_) return;
    occupied_ = occupied_ + next_valid_ - valid_[oldest_];
    valid_[oldest_] = next_valid_;
    if (next_valid_) stages_[oldest_] = next_;
    oldest_ = oldest_ + 1 == Length ? 0 : oldest_ + 1;
    moves_ = false;
  }

 private:
  std::array<T, Length> stages_{};
  std::array<bool, Length> valid_{};
  T next_{};
  std::size_t oldest_ = 0;
  std::size_t occupied_ = 0;
  bool moves_ = false;
  bool next_valid_ = false;
};

}  // namespace cbvh::rtl
