// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <tuple>

#include "testbench/lockstep/in_out.h"
#include "vectors/payloads.h"

namespace cbvh::testbench {

namespace {

/// Moves what it can from one channel to another: a wire in the Verilog.
template <class T>
class Wire {
 public:
  Wire(rtl::Channel<T>& from, rtl::Channel<T>& to) : from_(from), to_(to) {}
  void tick() {
    if (from_.can_pop() && to_.can_push()) to_.push(from_.pop());
  }
  void commit(rtl::CommitKey) {}

 private:
  rtl::Channel<T>& from_;
  rtl::Channel<T>& to_;
};

/// The C++ skid buffer is rtl::Channel itself.
template <class T>
class SkidBuffer {
 public:
  SkidBuffer(rtl::Channel<T>& in, rtl::Channel<T>& out) : into_(in, buffer_), out_of_(buffer_, out) {}
  auto parts() { return std::tie(into_, buffer_, out_of_); }

 private:
  rtl::Channel<T> buffer_;
  Wire<T> into_;
  Wire<T> out_of_;
};

}  // namespace

LockstepTwin skid_buffer_twin() {
  return {"skid_buffer",
          {vectors::Parameters()},
          [](const vectors::Parameters&) {
            return fmt::format("#(.WIDTH({}))", vectors::payload_codec<rtl::AxisJob>().width);
          },
          [](const vectors::Parameters& parameters, const RunOptions& options, std::uint64_t seed) {
            const auto set = vectors::generate_set("axis_compressor", parameters, 1000, seed);
            const std::span<const rtl::AxisJob> items(static_cast<const rtl::AxisJob*>(set->stimulus_at(0)),
                                                      set->stimulus_count());
            return std::vector<Episode>{record_in_out<rtl::AxisJob, rtl::AxisJob>(
                [](auto& in, auto& out) { return SkidBuffer<rtl::AxisJob>(in, out); }, items, options, 0, "in", "out")};
          }};
}

}  // namespace cbvh::testbench
