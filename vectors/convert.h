// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/float_tree.h"
#include "golden/quantize/grid.h"
#include "golden/tree/compressed_tree.h"
#include "rtl_model/datapath/payloads.h"

/// Values of the golden model as payloads of the hardware, and back. Nothing is computed here.
namespace cbvh::vectors {

inline rtl::SceneRegisters scene_registers(const golden::GridRules& rules, golden::Code code) {
  return {rtl::Scale(rules.min_scale), rtl::UInt<1>(rules.scale_rule == golden::ScaleRule::figure5),
          rtl::UInt<1>(code == golden::Code::relative)};
}

inline rtl::FloatBox float_box(const golden::Box& box) {
  rtl::FloatBox result;
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[static_cast<std::size_t>(axis)] = rtl::Float32::of(box.lower[axis]);
    result.upper[static_cast<std::size_t>(axis)] = rtl::Float32::of(box.upper[axis]);
  }
  return result;
}

inline golden::Box plain_box(const rtl::FloatBox& box) {
  golden::Box result{};
  for (int axis = 0; axis < 3; ++axis) {
    result.lower[axis] = box.lower[static_cast<std::size_t>(axis)].value();
    result.upper[axis] = box.upper[static_cast<std::size_t>(axis)].value();
  }
  return result;
}

inline rtl::FloatPair float_pair(const golden::FloatPair& pair) {
  rtl::FloatPair result;
  for (std::size_t child = 0; child < 2; ++child) {
    result.box[child] = float_box(pair.child[child]);
    result.leaf[child] = rtl::UInt<1>(pair.leaf[child]);
    result.pointer[child] = rtl::Pointer(pair.pointer[child]);
  }
  return result;
}

/// Pair `index` of a tree as it arrives at the stream compressor.
inline rtl::StreamJob stream_job(const golden::FloatTree& tree, std::size_t index,
                                 const rtl::SceneRegisters& registers) {
  return {float_pair(tree.pairs[index]), rtl::UInt<1>(index + 1 == tree.pairs.size()), registers};
}

template <int N>
rtl::NodePair<N> node_pair(const golden::CompressedPair& pair) {
  rtl::NodePair<N> result;
  for (std::size_t child = 0; child < 2; ++child) {
    auto& codes = result.child[child];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      codes.lo[axis] = rtl::UInt<N>(pair.child[child].codes[axis].lower);
      codes.hi[axis] = rtl::UInt<N>(pair.child[child].codes[axis].upper);
    }
    codes.leaf = rtl::UInt<1>(pair.child[child].leaf);
    codes.pointer = rtl::Pointer(pair.child[child].pointer);
  }
  return result;
}

template <int N>
golden::CompressedPair compressed_pair(const rtl::NodePair<N>& pair) {
  golden::CompressedPair result{};
  for (std::size_t child = 0; child < 2; ++child) {
    const auto& codes = pair.child[child];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.child[child].codes[axis] = {static_cast<std::uint8_t>(codes.lo[axis].value()),
                                         static_cast<std::uint8_t>(codes.hi[axis].value())};
    }
    result.child[child].leaf = bool(codes.leaf);
    result.child[child].pointer = static_cast<std::uint32_t>(codes.pointer.value());
  }
  return result;
}

template <class Index>
rtl::Context context(const golden::Context<Index>& from) {
  rtl::Context result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result[axis] = {rtl::Scale(from[axis].scale), rtl::CellIndex(static_cast<std::int64_t>(from[axis].lower))};
  }
  return result;
}

}  // namespace cbvh::vectors
