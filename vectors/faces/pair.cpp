// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/pair.h"

#include <algorithm>

namespace cbvh::vectors {

using rtl::Status;

golden::Box union_box(const rtl::FloatPair& pair) {
  golden::Box box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int component = static_cast<int>(axis);
    box.lower[component] = std::min(pair.box[0].lower[axis].value(), pair.box[1].lower[axis].value());
    box.upper[component] = std::max(pair.box[0].upper[axis].value(), pair.box[1].upper[axis].value());
  }
  return box;
}

PairAnswer compress_pair(const rtl::FloatPair& pair, const std::optional<golden::Context<Index>>& given,
                         const rtl::SceneRegisters& registers, int bits) {
  PairAnswer answer;
  const auto note = [&answer](Status status) {
    if (status != Status::ok && (answer.status == Status::ok || status < answer.status)) answer.status = status;
  };
  const auto interval = [&](std::size_t child, std::size_t axis) {
    return std::array<float, 2>{pair.box[child].lower[axis].value(), pair.box[child].upper[axis].value()};
  };
  if (!given) {  // without a valid box there is no estimate, and nothing else can refuse
    for (std::size_t child = 0; child < 2; ++child) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [lower, upper] = interval(child, axis);
        note(interval_status(lower, upper, registers));
      }
    }
    if (answer.status != Status::ok) return answer;
  }
  answer.context = given ? *given : golden::root_context<Index>(union_box(pair), rules_of(registers, bits));
  for (std::size_t child = 0; child < 2; ++child) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lower, upper] = interval(child, axis);
      const AxisAnswer compressed = compress_axis(lower, upper, answer.context[axis].scale, registers, bits);
      note(compressed.status);
      answer.cells[child][axis] = compressed.cells;
      answer.child_context[child][axis] = compressed.own;
    }
  }
  if (answer.status != Status::ok) return {answer.status};
  return answer;
}

golden::CompressedPair stored_pair(const rtl::FloatPair& pair, const PairAnswer& answer,
                                   const rtl::SceneRegisters& registers, int bits) {
  golden::CompressedPair stored{};
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      stored.child[c].codes[axis] =
          golden::encode_codes(answer.cells[c][axis], answer.context[axis].lower, code_of(registers), bits);
    }
    stored.child[c].leaf = bool(pair.leaf[c]);
    stored.child[c].pointer = static_cast<std::uint32_t>(pair.pointer[c].raw());
  }
  return stored;
}

bool is_invalidated(const golden::Context<Index>& before, const golden::Context<Index>& after, golden::Code code) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (before[axis].scale != after[axis].scale) return true;
    if (code == golden::Code::relative && before[axis].lower != after[axis].lower) return true;
  }
  return false;
}

}  // namespace cbvh::vectors
