// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "vectors/generate/pair_jobs.h"
#include "vectors/line_payloads.h"
#include "vectors/random.h"

namespace cbvh::vectors {

/// Where pair 0 lies, and how many lines the node writer of this unit holds.
constexpr std::uint64_t kWriterFirstLine = 3;
constexpr std::size_t kWriterLines = 4;

/// A request in plain numbers: pairs of one line are written, or one of them is read.
struct PlainWriterStep {
  enum class Kind : std::uint8_t { write, read, end, refused_end };
  Kind kind;
  std::uint32_t line = 0;
  std::uint32_t mask = 0;
};

inline constexpr std::array<std::string_view, 11> kNodeWriterClasses = {
    "single-pair",      "whole-lines",      "pair-by-pair", "backwards",        "eviction", "read-hits-held",
    "read-from-memory", "read-beside-held", "random-walk",  "nothing-to-write", "refused"};
std::vector<PlainWriterStep> make_writer_steps(std::size_t case_class, Random& random);

}  // namespace cbvh::vectors
