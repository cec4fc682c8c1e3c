// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <cstdint>

#include "rtl_model/kernel/commit_key.h"

namespace cbvh::rtl {

/// The handshake of a channel, without what it carries: for those who watch.
class ChannelState {
 public:
  ChannelState(const ChannelState&) = delete;
  ChannelState& operator=(const ChannelState&) = delete;

  bool can_push() const { return count_ < 2; }
  bool can_pop() const { return count_ > 0; }

  /// Transfers out of the channel so far: it grows when the cycle of a pop ends.
  std::uint64_t pops() const { return pops_; }
  /// Transfers into it so far: it grows when the cycle of a push ends.
  std::uint64_t pushes() const { return pops_ + count_; }

  void commit(CommitKey) {
    head_ = (head_ + popped_) & 1u;
    count_ = count_ + pushed_ - popped_;
    pops_ += popped_;
    pushed_ = popped_ = false;
  }

 protected:
  ChannelState() = default;
  ~ChannelState() = default;

  unsigned head_ = 0;
  unsigned count_ = 0;
  std::uint64_t pops_ = 0;
  bool pushed_ = false;
  bool popped_ = false;
};

/// A two-entry skid buffer between two modules. valid (`can_pop`) and ready (`can_push`) both come from registers: full
/// rate, no combinational path between the modules, and so no meaning in the order they are evaluated in. One module
/// pushes, one pops.
template <class T>
class Channel : public ChannelState {
 public:
  Channel() = default;

  const T& front() const {
    assert(can_pop());
    return entries_[head_];
  }

  /// At most once a cycle, and only when can_push(). The entry is seen from the next cycle on.
  void push(const T& value) {
    assert(can_push() && !pushed_);
    entries_[(head_ + count_) & 1u] = value;
    pushed_ = true;
  }
  /// At most once a cycle, and only when can_pop(). The reference holds until the end of the cycle.
  const T& pop() {
    assert(can_pop() && !popped_);
    popped_ = true;
    return entries_[head_];
  }

  /// What the last pop took, until two more entries have come.
  const T& last_popped() const { return entries_[(head_ + 1) & 1u]; }

 private:
  std::array<T, 2> entries_{};
};

}  // namespace cbvh::rtl
