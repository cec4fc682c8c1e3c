// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "vectors/faces/axis.h"
#include "vectors/generate/stack_operations.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Contexts of open subtrees. An episode starts with an empty stack. Nothing depends on N; the parameter is there to be
/// like the others.
template <int N>
struct ContextStack {
  using Stimulus = rtl::StackOperation;
  using Response = rtl::StackReply;
  static constexpr std::string_view kName = "context_stack";
  static constexpr std::string_view kSummary = "traversal contexts of open subtrees: takes up to two, then adds one";
  static constexpr std::string_view kLatencyText = "1";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kStackClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    return make_stack_operations(case_class, random);
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> operations, const Parameters&) {
    std::vector<rtl::Context> held;
    std::vector<Expected<Response>> replies;
    for (const Stimulus& operation : operations) {
      const std::size_t pops = operation.pops.value();
      const bool push = bool(operation.push);
      rtl::StackReply reply;
      rtl::Status status = rtl::Status::ok;
      if (pops > 2 || pops > held.size()) {
        status = rtl::Status::underflow;
      } else if (push && held.size() - pops == rtl::kContextStackDepth) {
        status = rtl::Status::overflow;
      } else {
        for (std::size_t i = 0; i < pops; ++i) {
          reply.popped[i] = held.back();
          held.pop_back();
        }
        if (push) held.push_back(operation.context);
      }
      reply.depth = rtl::UInt<6>(held.size());
      reply.status = rtl::StatusBits(static_cast<std::uint64_t>(status));
      replies.push_back({reply, static_cast<std::uint32_t>(replies.size() + 1)});
    }
    return replies;
  }
};

}  // namespace cbvh::vectors
