// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/backtrack.h"

#include "golden/input_error.h"

namespace cbvh::vectors {
namespace {

constexpr int kMostLevels = 64;
constexpr std::size_t kMostRepairs = std::size_t{1} << 27;

}  // namespace

std::vector<RepairedPair> BacktrackMemory::repair(std::uint32_t index, const golden::Context<Index>& before,
                                                  const golden::Context<Index>& after,
                                                  const rtl::SceneRegisters& registers) {
  Walk walk{registers, {}};
  visit(index, before, after, 1, walk);
  return std::move(walk.written);
}

void BacktrackMemory::visit(std::uint32_t index, const golden::Context<Index>& before,
                            const golden::Context<Index>& after, int level, Walk& walk) {
  const auto found = pairs_.find(index);
  if (found == pairs_.end()) throw golden::InputError("repair", fmt::format("no pair at index {}", index));
  if (level > kMostLevels || walk.written.size() == kMostRepairs) {
    throw golden::InputError("repair", "the pairs are not a tree");
  }
  const golden::Code code = code_of(walk.registers);
  const golden::GridRules rules = rules_of(walk.registers, bits_);
  golden::CompressedPair& pair = found->second;
  std::array<golden::Context<Index>, 2> child_before{};
  std::array<golden::Context<Index>, 2> child_after{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int d = after[axis].scale - before[axis].scale;
      if (d < 0) throw golden::InputError("repair", fmt::format("pair {}: the grid after is finer", index));
      const Cells<Index> old_cells = golden::decode_codes(pair.child[c].codes[axis], before[axis].lower, code, bits_);
      const Cells<Index> new_cells = golden::coarsen(old_cells, d);
      pair.child[c].codes[axis] = golden::encode_codes(new_cells, after[axis].lower, code, bits_);
      child_before[c][axis] = golden::own_context(old_cells, before[axis].scale, rules);
      child_after[c][axis] = golden::own_context(new_cells, after[axis].scale, rules);
    }
  }
  walk.written.push_back({index, pair, level});
  for (std::size_t c = 0; c < 2; ++c) {
    if (pair.child[c].leaf || !is_invalidated(child_before[c], child_after[c], code)) continue;
    visit(pair.child[c].pointer, child_before[c], child_after[c], level + 1, walk);
  }
}

}  // namespace cbvh::vectors
