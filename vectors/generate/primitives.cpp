// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/primitives.h"

#include "vectors/generate/floats.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSceneLike,
  kSignedZero,
  kSubnormal,
  kLargestFinite,
  kDegenerateAxis,
  kThreeEqual,
  kRandomBits,
  kNotFinite,
  kAnyWires
};

template <class MakeCoordinate>
rtl::Primitive primitive_of(Random& random, MakeCoordinate&& coordinate) {
  rtl::Primitive primitive;
  for (auto& vertex : primitive.vertex) {
    for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] = rtl::Float32::of(coordinate(axis));
  }
  primitive.id = rtl::Pointer::of_raw(random.next());
  primitive.last = rtl::UInt<1>(random.one_in(4));
  return primitive;
}

enum LineClass : std::size_t { kSinglePrimitive, kAcrossALine, kWholeLines, kAnyNumber, kMany };

std::uint64_t number_of_primitives(std::size_t case_class, Random& random) {
  switch (case_class) {
    case kSinglePrimitive:
    case kAcrossALine:  // the second begins in the first line and ends in the next
      return 1 + case_class;
    case kWholeLines:  // eight primitives are five lines
      return 8 * static_cast<std::uint64_t>(random.between(1, 3));
    case kAnyNumber:
      return 1 + random.below(24);
    default:
      return 40 + random.below(60);
  }
}

}  // namespace

rtl::Primitive make_primitive(std::size_t case_class, Random& random) {
  switch (case_class) {
    case kSceneLike: {
      const std::array<float, 3> centre = {float_within(100, random), float_within(100, random),
                                           float_within(100, random)};
      return primitive_of(random, [&](std::size_t axis) { return centre[axis] + float_within(1, random); });
    }
    case kSignedZero:
      return primitive_of(random,
                          [&](std::size_t) { return random.one_in(4) ? float_within(1, random) : any_zero(random); });
    case kSubnormal:
      return primitive_of(random, [&](std::size_t) { return any_tiny_float(random); });
    case kLargestFinite:
      return primitive_of(random, [&](std::size_t) { return any_huge_float(random); });
    case kDegenerateAxis: {
      const std::uint64_t flat = random.below(3);
      const float height = any_finite_float(random);
      return primitive_of(random, [&](std::size_t axis) { return axis == flat ? height : any_finite_float(random); });
    }
    case kThreeEqual: {
      const std::array<float, 3> point = {any_finite_float(random), any_finite_float(random), any_finite_float(random)};
      return primitive_of(random, [&](std::size_t axis) { return point[axis]; });
    }
    case kRandomBits:
      return primitive_of(random, [&](std::size_t) { return any_finite_float(random); });
    case kNotFinite: {
      rtl::Primitive primitive = make_primitive(random.below(kNotFinite), random);
      primitive.vertex[random.below(3)][random.below(3)] = rtl::Float32::of(any_special_float(random));
      return primitive;
    }
    default:
      return primitive_of(random, [&](std::size_t) { return float_of_bits(random.next()); });
  }
}

std::vector<PrimitiveLine> make_primitive_lines(std::size_t case_class, Random& random) {
  const std::uint64_t primitives = number_of_primitives(case_class, random);
  const std::uint64_t lines = (primitives * rtl::kWordsPerPrimitive + rtl::kWordsPerLine - 1) / rtl::kWordsPerLine;
  PrimitiveLine line{rtl::LineAddress(random.below(4096)), rtl::UInt<rtl::kPointerBits + 1>(primitives), {}};
  std::vector<PrimitiveLine> result;
  for (std::uint64_t i = 0; i < lines; ++i) {
    for (auto& word : line.words) word = rtl::UInt<32>::of_raw(random.next());
    result.push_back(line);
  }
  return result;
}

}  // namespace cbvh::vectors
