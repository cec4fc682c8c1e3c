// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/pipeline.h"

namespace cbvh::rtl {

/// A pure function spread over a pipeline: a job a clock in, its result `Latency` clocks after it was taken. The last
/// of the registers is the channel's own. When the channel is full the whole pipe holds.
template <class Job, class Result, int Latency, auto function>
class StagePipeline {
 public:
  static constexpr int kLatency = Latency;

  StagePipeline(Channel<Job>& jobs, Channel<Result>& results) : jobs_(jobs), results_(results) {}

  void tick() {
    if (!results_.can_push()) return;
    if (pipe_.output_valid()) results_.push(pipe_.output());
    if (jobs_.can_pop()) {
      pipe_.shift(function(jobs_.pop()));
    } else {
      pipe_.bubble();
    }
  }
  void commit(CommitKey key) { pipe_.commit(key); }

 private:
  Channel<Job>& jobs_;
  Channel<Result>& results_;
  Pipeline<Result, Latency - 1> pipe_;
};

}  // namespace cbvh::rtl
