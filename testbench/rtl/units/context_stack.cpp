// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/compress/context_stack.h"

#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"

namespace cbvh::testbench {

UnitDriver context_stack_driver() {
  return {"context_stack", [](const vectors::VectorSet& set, const RunOptions& options) {
            return run_episodes<rtl::StackOperation, rtl::StackReply>(
                [](auto& operations, auto& replies) { return rtl::ContextStack<CountingBits>(operations, replies); },
                set, options);
          }};
}

}  // namespace cbvh::testbench
