// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "vectors/faces/pair.h"

namespace cbvh::vectors {

/// A pair that leaves the chip, in plain numbers; see rtl::FinalPair.
struct FinalAnswer {
  std::uint32_t index = 0;
  golden::CompressedPair pair{};
  std::array<bool, 2> repair{};
  std::array<golden::Context<Index>, 2> before{};  ///< zero where repair is clear
  std::array<golden::Context<Index>, 2> after{};
  bool last = false;
  golden::Context<Index> root{};  ///< zero unless last
  rtl::Status status = rtl::Status::ok;
  rtl::SceneRegisters registers;
  std::size_t arrival = 0;  ///< number of the job that made it final
};

/// Sees every pair that is compressed, in order: on the estimate at a treelet's root, on the given context below it and
/// in the flush.
using CompressionObserver = std::function<void(const rtl::PairJob& job, const PairAnswer& answer)>;

/// The pairs that treelets of `levels` levels make final (rule 10), in order: for each arrival those of the last level
/// from left to right; after the root the rest in depth-first pre-order. Emission indices count from 0 in each tree. A
/// refused pair silences the rest of its tree but for one answer with its index and status when the root arrives.
std::vector<FinalAnswer> collect(std::span<const rtl::StreamJob> jobs, int levels, int bits,
                                 const CompressionObserver& observer = {});

template <int N>
rtl::FinalPair<N> to_wires(const FinalAnswer& answer) {
  rtl::FinalPair<N> wires;
  wires.index = rtl::Pointer(answer.index);
  wires.pair = to_wires<N>(answer.pair);
  for (std::size_t c = 0; c < 2; ++c) {
    wires.repair[c] = rtl::UInt<1>(answer.repair[c]);
    wires.before[c] = to_wires(answer.before[c]);
    wires.after[c] = to_wires(answer.after[c]);
  }
  wires.last = rtl::UInt<1>(answer.last);
  wires.root = to_wires(answer.root);
  wires.status = rtl::StatusBits(static_cast<std::uint64_t>(answer.status));
  wires.registers = answer.registers;
  return wires;
}

}  // namespace cbvh::vectors
