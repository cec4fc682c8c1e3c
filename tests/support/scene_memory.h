// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>

#include "golden/build/float_tree.h"
#include "golden/tree/compressed_tree.h"
#include "golden/tree/node_pair_format.h"
#include "rtl_model/memory/line_store.h"

/// Golden's scenes and trees as they lie in a memory, each from the beginning of a line on.
namespace cbvh::testing {

inline void poke_float(rtl::LineStore& store, std::uint64_t word, float value) {
  store.poke(word, std::bit_cast<std::uint32_t>(value));
}

inline void poke_primitives(rtl::LineStore& store, std::uint64_t line, const golden::Mesh& mesh) {
  std::uint64_t word = line * rtl::kWordsPerLine;
  for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
    for (int vertex = 0; vertex < 3; ++vertex) {
      for (int axis = 0; axis < 3; ++axis) {
        poke_float(store, word++, mesh.positions[mesh.triangles[id][vertex]][axis]);
      }
    }
    store.poke(word++, id);
  }
}

inline void poke_ids(rtl::LineStore& store, std::uint64_t line, const std::vector<std::uint32_t>& ids) {
  for (std::size_t i = 0; i < ids.size(); ++i) store.poke(line * rtl::kWordsPerLine + i, ids[i]);
}

inline void poke_pairs(rtl::LineStore& store, std::uint64_t line, const std::vector<golden::CompressedPair>& pairs) {
  std::uint64_t word = line * rtl::kWordsPerLine;
  for (const auto& pair : pairs) {
    for (const std::uint64_t half : golden::pack_node_pair(pair)) {
      store.poke(word++, static_cast<std::uint32_t>(half));
      store.poke(word++, static_cast<std::uint32_t>(half >> 32));
    }
  }
}
/// A line each: per child lower x y z, upper x y z, pointer with the leaf bit as bit 31, zero.
inline void poke_float_pairs(rtl::LineStore& store, std::uint64_t line, const std::vector<golden::FloatPair>& pairs) {
  std::uint64_t word = line * rtl::kWordsPerLine;
  for (const auto& pair : pairs) {
    for (int child = 0; child < 2; ++child) {
      for (int axis = 0; axis < 3; ++axis) poke_float(store, word++, pair.child[child].lower[axis]);
      for (int axis = 0; axis < 3; ++axis) poke_float(store, word++, pair.child[child].upper[axis]);
      store.poke(word++, pair.pointer[child] | (pair.leaf[child] ? 1u << 31 : 0u));
      store.poke(word++, 0);
    }
  }
}
inline std::vector<golden::CompressedPair> peek_pairs(const rtl::LineStore& store, std::uint64_t line,
                                                      std::size_t count) {
  std::vector<golden::CompressedPair> pairs;
  std::uint64_t word = line * rtl::kWordsPerLine;
  for (std::size_t i = 0; i < count; ++i) {
    golden::NodePairWords words{};
    for (std::uint64_t& half : words) {
      half = store.peek(word) | std::uint64_t{store.peek(word + 1)} << 32;
      word += 2;
    }
    pairs.push_back(golden::unpack_node_pair(words));
  }
  return pairs;
}

}  // namespace cbvh::testing
