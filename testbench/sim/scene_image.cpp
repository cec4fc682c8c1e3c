// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/scene_image.h"

#include <bit>

#include "golden/input_error.h"
#include "golden/tree/float_pair_format.h"
#include "golden/tree/node_pair_format.h"
#include "rtl_model/datapath/lbvh_payloads.h"

namespace cbvh::testbench {

namespace {

constexpr std::size_t kWordsPerPair = 4;

std::string compare_ids(const std::vector<std::uint32_t>& wanted, const std::vector<std::uint32_t>& found) {
  if (wanted.size() != found.size())
    return fmt::format("{} entries in the ID array, want {}", found.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] != found[i]) return fmt::format("ID entry {}: found {:08x}, want {:08x}", i, found[i], wanted[i]);
  }
  return "";
}

}  // namespace

void store_primitives(const golden::Mesh& mesh, std::uint64_t first_line, rtl::LineStore& store) {
  std::uint64_t word = first_line * rtl::kWordsPerLine;
  std::uint32_t id = 0;
  for (const auto& triangle : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const auto& position = mesh.positions[triangle[corner]];
      for (int axis = 0; axis < 3; ++axis) store.poke(word++, std::bit_cast<std::uint32_t>(position[axis]));
    }
    store.poke(word++, id++);
  }
}

void store_pairs(const golden::CompressedTree& tree, std::uint64_t first_line, rtl::LineStore& store) {
  std::uint64_t word = first_line * rtl::kWordsPerLine;
  for (const golden::CompressedPair& pair : tree.pairs) {
    for (const std::uint64_t half : golden::pack_node_pair(pair)) {
      store.poke(word++, static_cast<std::uint32_t>(half));
      store.poke(word++, static_cast<std::uint32_t>(half >> 32U));
    }
  }
}

void store_ids(const std::vector<std::uint32_t>& ids, std::uint64_t first_line, rtl::LineStore& store) {
  for (std::size_t i = 0; i < ids.size(); ++i) store.poke(first_line * rtl::kWordsPerLine + i, ids[i]);
}

std::vector<golden::CompressedPair> load_pairs(std::uint64_t first_line, std::size_t count,
                                               const rtl::LineStore& store) {
  std::vector<golden::CompressedPair> pairs;
  pairs.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t word = first_line * rtl::kWordsPerLine + i * kWordsPerPair;
    const auto half = [&](std::uint64_t at) { return std::uint64_t{store.peek(at + 1)} << 32U | store.peek(at); };
    pairs.push_back(golden::unpack_node_pair({half(word), half(word + 2)}));
  }
  return pairs;
}

std::vector<std::uint32_t> load_ids(std::uint64_t first_line, std::size_t count, const rtl::LineStore& store) {
  std::vector<std::uint32_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) ids[i] = store.peek(first_line * rtl::kWordsPerLine + i);
  return ids;
}

std::string compare_float_pairs(const golden::FloatTree& wanted, std::uint64_t first_line,
                                const rtl::LineStore& store) {
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i) {
    const golden::FloatPairWords words = golden::pack_float_pair(wanted.pairs[i]);
    for (std::size_t word = 0; word < words.size(); ++word) {
      const std::uint32_t found = store.peek((first_line + i) * rtl::kWordsPerLine + word);
      if (found != words[word])
        return fmt::format("float pair {} word {}: found {:08x}, want {:08x}", i, word, found, words[word]);
    }
  }
  return "";
}

std::string first_difference(const golden::CompressedTree& wanted, const golden::CompressedTree& found) {
  if (wanted.pairs.size() != found.pairs.size())
    return fmt::format("{} pairs, want {}", found.pairs.size(), wanted.pairs.size());
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i) {
    if (wanted.pairs[i] == found.pairs[i]) continue;
    const auto found_words = golden::pack_node_pair(found.pairs[i]);
    const auto wanted_words = golden::pack_node_pair(wanted.pairs[i]);
    return fmt::format("pair {}: found {:016x} {:016x}, want {:016x} {:016x}", i, found_words[0], found_words[1],
                       wanted_words[0], wanted_words[1]);
  }
  if (wanted.root != found.root) return "the root's context";
  return compare_ids(wanted.primitive_ids, found.primitive_ids);
}

}  // namespace cbvh::testbench
