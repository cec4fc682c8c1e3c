// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/scoreboard/compare_trees.h"

#include <fmt/format.h>

namespace cbvh::testbench {

namespace {

constexpr std::uint64_t kChecksPerPair = 16;  ///< of two children: six codes, the leaf flag, the pointer

void compare_pair(const golden::CompressedPair& wanted, const golden::CompressedPair& found, std::uint64_t index,
                  const TreeCase& tree_case, SetReport& report) {
  if (wanted == found) {
    report.checks += kChecksPerPair;
    return;
  }
  for (std::size_t c = 0; c < 2; ++c) {
    const auto compare = [&](const std::string& field, long long want, long long have) {
      compare_number(fmt::format("child_{}_{}", c, field), want, have, tree_case, report, index);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const char name = "xyz"[axis];
      compare(fmt::format("lo_{}", name), wanted.child[c].codes[axis].lower, found.child[c].codes[axis].lower);
      compare(fmt::format("hi_{}", name), wanted.child[c].codes[axis].upper, found.child[c].codes[axis].upper);
    }
    compare("leaf", wanted.child[c].leaf, found.child[c].leaf);
    compare("pointer", wanted.child[c].pointer, found.child[c].pointer);
  }
}

}  // namespace

void compare_number(const std::string& field, long long wanted, long long found, const TreeCase& tree_case,
                    SetReport& report, std::uint64_t response) {
  ++report.checks;
  if (wanted == found) return;
  ++report.failures;
  if (report.mismatches.size() >= kMismatchesKept) return;
  report.mismatches.push_back({report.unit, report.set, tree_case.id, tree_case.case_class, response, field,
                               std::to_string(found), std::to_string(wanted), tree_case.rerun, ""});
}

void compare_trees(const golden::CompressedTree& wanted, const golden::CompressedTree& found, const TreeCase& tree_case,
                   SetReport& report) {
  compare_number("pairs", static_cast<long long>(wanted.pairs.size()), static_cast<long long>(found.pairs.size()),
                 tree_case, report);
  if (wanted.pairs.size() != found.pairs.size()) return;
  for (std::size_t i = 0; i < wanted.pairs.size(); ++i)
    compare_pair(wanted.pairs[i], found.pairs[i], i, tree_case, report);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    compare_number(fmt::format("root_scale_{}", "xyz"[axis]), wanted.root[axis].scale, found.root[axis].scale,
                   tree_case, report);
    compare_number(fmt::format("root_lower_{}", "xyz"[axis]), static_cast<long long>(wanted.root[axis].lower),
                   static_cast<long long>(found.root[axis].lower), tree_case, report);
  }
}

}  // namespace cbvh::testbench
