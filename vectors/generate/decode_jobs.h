// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "golden/tree/compressed_tree.h"
#include "rtl_model/datapath/traverse_payloads.h"
#include "vectors/faces/axis.h"
#include "vectors/random.h"

namespace cbvh::vectors {

/// A stored child and its parent's context, in plain numbers.
struct PlainDecodeJob {
  golden::CompressedChild node{};
  golden::Context<Index> parent{};
  rtl::SceneRegisters registers;
};

template <int N>
rtl::DecodeJob<N> to_wires(const PlainDecodeJob& job) {
  rtl::DecodeJob<N> wires;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    wires.node.lo[axis] = rtl::UInt<N>(job.node.codes[axis].lower);
    wires.node.hi[axis] = rtl::UInt<N>(job.node.codes[axis].upper);
  }
  wires.node.leaf = rtl::UInt<1>(job.node.leaf);
  wires.node.pointer = rtl::Pointer(job.node.pointer);
  wires.parent = to_wires(job.parent);
  wires.registers = job.registers;
  return wires;
}

inline constexpr std::array<std::string_view, 21> kDecodeJobClasses = {
    "signed-zero",      "subnormal",           "largest-finite",     "sign-crossing",   "edge-on-grid",
    "one-cell",         "power-of-two-size",   "full-grid",          "degenerate-axis", "minimum-scale-saturation",
    "exponent-gap",     "random-bits",         "parents-upper-edge", "largest-index",   "inverted",
    "beyond-exactness", "scale-below-minimum", "too-wide",           "several-reasons", "any-codes",
    "any-wires"};
PlainDecodeJob make_decode_job(std::size_t case_class, Random& random, int bits);

}  // namespace cbvh::vectors
