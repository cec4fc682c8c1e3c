// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "golden/tree/node_pair_format.h"
#include "vectors/line_payloads.h"

namespace cbvh::vectors {

/// Memory as the steps of an episode leave it, by word. What nobody wrote is zero.
class LineMemory {
 public:
  template <class Command>
  explicit LineMemory(std::span<const MemoryStep<Command>> steps) {
    for (const auto& step : steps) {
      if (!step.act) write(step.line.value(), step.words);
    }
  }

  std::uint32_t word(std::uint64_t address) const {
    const auto found = words_.find(address);
    return found == words_.end() ? 0 : found->second;
  }
  /// The packed pair `index` of an array.
  golden::CompressedPair pair(std::uint64_t first_line, std::uint64_t index) const {
    const std::uint64_t first = first_line * 16 + index * 4;
    return golden::unpack_node_pair(
        {word(first) | std::uint64_t{word(first + 1)} << 32, word(first + 2) | std::uint64_t{word(first + 3)} << 32});
  }

 private:
  void write(std::uint64_t line, const rtl::LineWords& words) {
    for (std::size_t i = 0; i < words.size(); ++i) words_[line * 16 + i] = static_cast<std::uint32_t>(words[i].raw());
  }
  std::map<std::uint64_t, std::uint32_t> words_;
};

/// The commands among the steps.
template <class Command>
std::vector<Command> commands_of(std::span<const MemoryStep<Command>> steps) {
  std::vector<Command> commands;
  for (const auto& step : steps) {
    if (step.act) commands.push_back(step.command);
  }
  return commands;
}

}  // namespace cbvh::vectors
