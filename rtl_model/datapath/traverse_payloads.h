// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/payloads.h"

/// What travels between the modules that read a compressed tree.
namespace cbvh::rtl {

/// One child of a stored pair, and the context of the node it is a child of. Paper fig. 4, inputs.
template <int N>
struct DecodeJob {
  NodeCodes<N> node;
  Context parent;  ///< the parent's own grid, and its lower index on it
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("node", &DecodeJob::node, "parent", &DecodeJob::parent, "registers", &DecodeJob::registers);
  }
  bool operator==(const DecodeJob&) const = default;
};

/// A child as it is read. Paper fig. 4, outputs.
struct DecodeResult {
  FloatBox box;     ///< the decoded bounds, exact; +-infinity at +-2^128 and beyond
  Context context;  ///< the child's own grid, and its lower index on it
  UInt<1> leaf;
  Pointer pointer;
  StatusBits status;  ///< inverted, beyond_exactness, scale_below_minimum, too_wide or ok
  static constexpr auto fields() {
    return field_list("box", &DecodeResult::box, "context", &DecodeResult::context, "leaf", &DecodeResult::leaf,
                      "pointer", &DecodeResult::pointer, "status", &DecodeResult::status);
  }
  bool operator==(const DecodeResult&) const = default;
};

}  // namespace cbvh::rtl
