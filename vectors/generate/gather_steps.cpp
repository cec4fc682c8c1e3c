// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/gather_steps.h"

#include <set>

#include "vectors/generate/array_steps.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSingle,
  kTwoLines,
  kNeighbours,
  kBackwards,
  kAgain,
  kCollisions,
  kScattered,
  kOutOfRange,
  kTwoArrays
};

constexpr std::uint64_t kPrimitives = 3000;
/// So many primitives are five times as many lines as are held: a step that leads to the same place of the store.
constexpr std::uint64_t kSamePlace = 8 * kGathererLines;

/// Collects inputs and the lines that they touch.
class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  void array(std::uint64_t first_line, const std::vector<std::uint64_t>& ids) {
    GatherInput begin;
    begin.array = {rtl::LineAddress(first_line), rtl::ItemCount(kPrimitives)};
    inputs_.push_back(begin);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      GatherInput input;
      input.is_id = rtl::UInt<1>(1);
      const bool last = i + 1 == ids.size();
      input.id = {rtl::Pointer(ids[i]), rtl::UInt<1>(last || random_.flip()), rtl::UInt<1>(last)};
      inputs_.push_back(input);
      if (ids[i] >= kPrimitives) continue;
      lines_.insert(first_line + ids[i] * 10 / 16);
      lines_.insert(first_line + (ids[i] * 10 + 9) / 16);
    }
  }

  std::vector<GatherStep> steps() {
    std::vector<GatherStep> result;
    for (const std::uint64_t line : lines_) {
      result.push_back({rtl::UInt<1>(0), rtl::LineAddress(line), random_line(random_), {}});
    }
    for (const GatherInput& input : inputs_) result.push_back({rtl::UInt<1>(1), {}, {}, input});
    return result;
  }

 private:
  Random& random_;
  std::set<std::uint64_t> lines_;
  std::vector<GatherInput> inputs_;
};

std::vector<std::uint64_t> ids_of(std::size_t case_class, Random& random) {
  std::vector<std::uint64_t> ids;
  const std::uint64_t first = random.below(kPrimitives / 2);
  const int count = random.between(3, 7);
  for (int n = 0; n < count; ++n) {
    const auto i = static_cast<std::uint64_t>(n);
    switch (case_class) {
      case kTwoLines:
        ids.push_back(first / 8 * 8 + 1 + 2 * i);
        break;
      case kNeighbours:
        ids.push_back(first + i);
        break;
      case kBackwards:
        ids.push_back(first + 8 - i);
        break;
      case kAgain:
        ids.push_back(first + random.below(2));
        break;
      case kCollisions:
        ids.push_back(first + random.below(3) * kSamePlace);
        break;
      case kOutOfRange:
        ids.push_back(random.flip() ? kPrimitives + random.below(random.flip() ? 2 : 1U << 26U) : kPrimitives - 1);
        break;
      default:  // kScattered, kTwoArrays
        ids.push_back(random.below(kPrimitives));
    }
  }
  if (case_class == kSingle) ids = {first};
  if (case_class == kOutOfRange) ids.push_back(kPrimitives + random.below(2) * ((1U << 26U) - 1));
  return ids;
}

}  // namespace

std::vector<GatherStep> make_gather_steps(std::size_t case_class, Random& random) {
  Writer writer(random);
  const auto ids = ids_of(case_class, random);
  writer.array(random.below(1000), ids);
  if (case_class == kTwoArrays) {
    const auto more = ids_of(kNeighbours, random);
    writer.array(5000 + random.below(1000), more);
  }
  return writer.steps();
}

}  // namespace cbvh::vectors
