// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/timing.h"
#include "vectors/generate/primitives.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Triangles from memory. An episode is the lines that hold them; the responses are the triangles, counted from the
/// cycle in which memory took the first request.
struct PrimitiveReader {
  using Stimulus = PrimitiveLine;
  using Response = rtl::Primitive;
  static constexpr std::string_view kName = "primitive_reader";
  static constexpr std::string_view kSummary = "reads triangles of 40 bytes from memory";
  static constexpr std::string_view kLatencyText = "6, then 1 each";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kPrimitiveLineClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_primitive_lines(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> lines, const Parameters&) {
    std::vector<std::uint64_t> words;
    for (const Stimulus& line : lines) {
      for (const auto& word : line.words) words.push_back(word.value());
    }
    const std::uint64_t count = lines.empty() ? 0 : lines[0].primitives.value();
    if (count == 0 || words.size() < count * rtl::kWordsPerPrimitive) {
      throw golden::InputError("primitives", fmt::format("found {} in {} words", count, words.size()));
    }
    std::vector<Expected<Response>> responses;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t* const word = &words[i * rtl::kWordsPerPrimitive];
      rtl::Primitive primitive;
      for (std::size_t j = 0; j < 9; ++j) primitive.vertex[j / 3][j % 3] = rtl::Float32::of_raw(word[j]);
      primitive.id = rtl::Pointer::of_raw(word[9]);
      primitive.last = rtl::UInt<1>(i + 1 == count);
      responses.push_back({primitive, static_cast<std::uint32_t>(kMemoryLatency + 2 + i)});
    }
    return responses;
  }
};

}  // namespace cbvh::vectors
