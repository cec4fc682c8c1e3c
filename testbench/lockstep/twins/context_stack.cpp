// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/context_stack.h"

#include "rtl_model/bits/machine_bits.h"
#include "testbench/lockstep/in_out.h"

namespace cbvh::testbench {

LockstepTwin context_stack_twin() {
  return {
      "context_stack",
      {vectors::Parameters()},
      verilog_nothing,
      [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
        return record_cases<rtl::StackOperation, rtl::StackReply>(
            [](auto& operations, auto& replies) { return rtl::ContextStack<rtl::MachineBits>(operations, replies); },
            "context_stack", parameters, 60, options, seed, "operations", "replies");
      }};
}

}  // namespace cbvh::testbench
