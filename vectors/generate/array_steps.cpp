// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/array_steps.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t { kSingle, kPart, kWhole, kMany, kTwo, kOnes, kPast };

constexpr std::uint64_t kAllOnes = 0xFFFFFFFF;

rtl::LineWords full_line() {
  rtl::LineWords words;
  words.fill(rtl::UInt<32>(kAllOnes));
  return words;
}

}  // namespace

rtl::LineWords random_line(Random& random) {
  rtl::LineWords words;
  for (rtl::UInt<32>& word : words) word = rtl::UInt<32>::of_raw(random.next());
  return words;
}

std::vector<ArrayStep> make_array_steps(std::size_t case_class, std::uint64_t items_per_line, Random& random) {
  std::vector<ArrayStep> steps;
  std::vector<ArrayStep> commands;
  std::uint64_t line = random.below(1000);
  const auto add = [&](std::uint64_t items) {
    const std::uint64_t lines = (items + items_per_line - 1) / items_per_line;
    ArrayStep command;
    command.act = rtl::UInt<1>(1);
    command.command = {rtl::LineAddress(line), rtl::ItemCount(items)};
    commands.push_back(command);
    for (std::uint64_t i = 0; i < lines; ++i) {
      ArrayStep step;
      step.line = rtl::LineAddress(line++);
      step.words = case_class == kOnes ? full_line() : random_line(random);
      steps.push_back(step);
    }
    line += random.below(3);
  };
  const auto part = [&] { return 1 + random.below(items_per_line); };
  switch (case_class) {
    case kSingle:
      add(1);
      break;
    case kPart:
      add(random.below(2) * items_per_line + part());
      break;
    case kWhole:
      add((1 + random.below(3)) * items_per_line);
      break;
    case kMany:
      add((2 + random.below(5)) * items_per_line + part());
      break;
    case kTwo:
      add(part());
      add(random.below(2) * items_per_line + part());
      break;
    case kOnes:
      add(part());
      break;
    default:  // kPast
      add((15 + random.below(4)) * items_per_line + part());
  }
  steps.insert(steps.end(), commands.begin(), commands.end());
  return steps;
}

}  // namespace cbvh::vectors
