// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "vectors/faces/pair.h"

namespace cbvh::vectors {

struct RepairedPair {
  std::uint32_t index;
  golden::CompressedPair pair;
  int level;  ///< 1: the pair the repair began with
};

/// Compressed pairs in memory, and the repairs that rules 7 and 9 make there.
class BacktrackMemory {
 public:
  explicit BacktrackMemory(int bits) : bits_(bits) {}

  void write(std::uint32_t index, const golden::CompressedPair& pair) { pairs_[index] = pair; }
  const std::map<std::uint32_t, golden::CompressedPair>& pairs() const { return pairs_; }
  void clear() { pairs_.clear(); }

  /// Re-encodes the pair, then child 0's subtree as far as it changes, then child 1's; returns what was written, in
  /// order. Throws InputError when a pair is missing, `after` is finer than `before`, or the repairs do not end.
  std::vector<RepairedPair> repair(std::uint32_t index, const golden::Context<Index>& before,
                                   const golden::Context<Index>& after, const rtl::SceneRegisters& registers);

 private:
  struct Walk {
    const rtl::SceneRegisters& registers;
    std::vector<RepairedPair> written;
  };
  void visit(std::uint32_t index, const golden::Context<Index>& before, const golden::Context<Index>& after, int level,
             Walk& walk);

  int bits_;
  std::map<std::uint32_t, golden::CompressedPair> pairs_;
};

}  // namespace cbvh::vectors
