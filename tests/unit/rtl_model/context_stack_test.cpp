// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/context_stack.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/unit_run.h"

namespace cbvh::rtl {
namespace {

std::vector<StackOperation> random_walk(std::size_t count) {
  SplitMix64 random(3);
  std::vector<StackOperation> operations;
  for (std::size_t i = 0; i < count; ++i) {
    StackOperation operation;
    const bool rising = (i / 60) % 2 == 0;
    operation.pops = UInt<2>(random.below(rising ? 2 : 4));
    operation.push = UInt<1>(random.below(4) != 0);
    for (auto& axis : operation.context)
      axis = {Scale(static_cast<std::int64_t>(i % 50)), CellIndex(static_cast<std::int64_t>(i))};
    operations.push_back(operation);
  }
  return operations;
}

std::vector<StackReply> expected(const std::vector<StackOperation>& operations) {
  std::vector<Context> stack;
  std::vector<StackReply> replies;
  for (const auto& operation : operations) {
    StackReply reply;
    const std::size_t pops = operation.pops.value();
    if (pops == 3 || pops > stack.size()) {
      reply.status = StatusBits(static_cast<std::uint64_t>(Status::underflow));
    } else if (operation.push && stack.size() - pops == 32) {
      reply.status = StatusBits(static_cast<std::uint64_t>(Status::overflow));
    } else {
      for (std::size_t i = 0; i < pops; ++i, stack.pop_back()) reply.popped[i] = stack.back();
      if (operation.push) stack.push_back(operation.context);
    }
    reply.depth = UInt<6>(stack.size());
    replies.push_back(reply);
  }
  return replies;
}

TEST(ContextStack, behaves_as_a_stack_of_32_and_refuses_without_a_trace_under_every_stall) {
  const auto operations = random_walk(4000);
  const auto want = expected(operations);
  int refused[2] = {};
  for (const auto& reply : want) {
    refused[0] += reply.status.value() == static_cast<std::uint64_t>(Status::overflow);
    refused[1] += reply.status.value() == static_cast<std::uint64_t>(Status::underflow);
  }
  ASSERT_GT(refused[0], 10);
  ASSERT_GT(refused[1], 10);
  for (const auto& disturbance : testing::stall_matrix()) {
    const auto observed = testing::run_unit<StackOperation, StackReply>(
        operations, disturbance,
        [](auto& in, auto& out) { return std::make_unique<ContextStack<MachineBits>>(in, out); });
    EXPECT_EQ(observed.responses, want);
    if (!disturbance.source_stalls && !disturbance.sink_stalls) {
      for (const auto latency : observed.latencies()) ASSERT_EQ(latency, 1u);
    }
  }
}

}  // namespace
}  // namespace cbvh::rtl
