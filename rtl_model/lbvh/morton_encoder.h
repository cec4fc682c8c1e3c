// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "rtl_model/datapath/morton.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/pipeline.h"

namespace cbvh::rtl {

/// Gives a box its place on the Morton curve, a box a clock. Latency 36, initiation interval 1: halving 1, sum 4,
/// difference 4, divider 26 (a bit of quotient a stage), rounding and cell 1; three axes side by side. The scene box is
/// set for a whole scene, and what depends on it alone is kept in registers. A refused primitive passes as a box of
/// zeros; `first_refused` tells which was the first. DESIGN 3.2, LBVH.
template <class Bits>
class MortonEncoder {
 public:
  static constexpr int kLatency = 36;

  MortonEncoder(Channel<PrimitiveBox>& boxes, Channel<SortItem>& items, const SceneBox& registers)
      : boxes_(boxes), items_(items), frame_(morton_frame<Bits>(registers)) {}

  void tick() {
    if (!items_.can_push()) return;
    if (pipe_.output_valid()) items_.push(pipe_.output());
    if (boxes_.can_pop()) {
      pipe_.shift(encode(boxes_.pop()));
    } else {
      pipe_.bubble();
    }
  }
  void commit(CommitKey key) { pipe_.commit(key); }

  /// A register for the driver: the number of the first primitive that was refused; of such a scene the result is void.
  const std::optional<Pointer>& first_refused() const { return first_refused_; }

 private:
  SortItem encode(const PrimitiveBox& box) {
    if (!(box.status == StatusBits()) && !first_refused_) first_refused_ = box.id;
    return {{box.box, morton_code<Bits>(box.box, frame_), box.id}, UInt<1>(0), box.last};
  }

  Channel<PrimitiveBox>& boxes_;
  Channel<SortItem>& items_;
  const MortonFrame<Bits> frame_;
  Pipeline<SortItem, kLatency - 1> pipe_;
  std::optional<Pointer> first_refused_;
};

}  // namespace cbvh::rtl
