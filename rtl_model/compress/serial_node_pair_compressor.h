// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/compress/axis_compressor.h"
#include "rtl_model/compress/scale_estimator.h"
#include "rtl_model/datapath/pair_compress.h"

namespace cbvh::rtl {

/// Compresses a node pair with one scale estimator and one axis compressor that take turns over the axes: for small
/// FPGAs. Latency 14, initiation interval 14.
template <class Bits, int N>
class SerialNodePairCompressor {
 public:
  static constexpr int kLatency = 14;

  SerialNodePairCompressor(Channel<PairJob>& jobs, Channel<PairResult<N>>& results) : control_(*this, jobs, results) {}

  auto parts() {
    return std::tie(control_, estimate_jobs_, estimator_, estimates_, axis_jobs_, compressor_, axis_results_);
  }

  /// The channels between the parts (rtl_model/kernel/netlist.h).
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("estimate_jobs", "control", "scale_estimator", estimate_jobs_);
    visit("estimates", "scale_estimator", "control", estimates_);
    visit("axis_jobs", "control", "axis_compressor", axis_jobs_);
    visit("axis_results", "axis_compressor", "control", axis_results_);
  }

 private:
  /// Issues three estimates, then both children on each axis as its estimate comes back, and collects what comes back;
  /// it never lets a channel fill, so nothing inside ever waits.
  class Control {
   public:
    Control(SerialNodePairCompressor& unit, Channel<PairJob>& jobs, Channel<PairResult<N>>& results)
        : unit_(unit), jobs_(jobs), results_(results) {}

    void tick() {
      collect();
      if (!busy_) {
        if (jobs_.can_pop()) start(jobs_.pop());
        return;
      }
      issue();
      if (collected_axes_ == 6 && results_.can_push()) {
        results_.push(assemble_pair<Bits, N>(job_, context_, axes_));
        busy_ = false;
      }
    }
    void commit(CommitKey) {}

   private:
    void start(const PairJob& job) {
      job_ = job;
      busy_ = true;
      issued_ = collected_estimates_ = collected_axes_ = 0;
      issue();
    }
    void collect() {
      if (unit_.estimates_.can_pop()) {
        estimates_[collected_estimates_++] = unit_.estimates_.pop();
        context_ = choose_context<Bits>(job_, estimates_);
      }
      if (unit_.axis_results_.can_pop()) {
        axes_[collected_axes_ % 2][collected_axes_ / 2] = unit_.axis_results_.pop();
        ++collected_axes_;
      }
    }
    void issue() {
      if (issued_ < 3) {
        unit_.estimate_jobs_.push(union_axis<Bits>(job_.pair, issued_, job_.registers));
        ++issued_;
      } else if (const std::size_t turn = issued_ - 3; turn < 6 && collected_estimates_ > turn / 2) {
        unit_.axis_jobs_.push(axis_job(job_, context_, turn % 2, turn / 2));
        ++issued_;
      }
    }

    SerialNodePairCompressor& unit_;
    Channel<PairJob>& jobs_;
    Channel<PairResult<N>>& results_;
    PairJob job_;
    Context context_;
    std::array<EstimateResult, 3> estimates_;
    std::array<std::array<AxisResult<N>, 3>, 2> axes_;
    bool busy_ = false;
    std::size_t issued_ = 0;
    std::size_t collected_estimates_ = 0;
    std::size_t collected_axes_ = 0;
  };

  Control control_;
  Channel<EstimateJob> estimate_jobs_;
  Channel<EstimateResult> estimates_;
  Channel<AxisJob> axis_jobs_;
  Channel<AxisResult<N>> axis_results_;
  ScaleEstimator<Bits, N> estimator_{estimate_jobs_, estimates_};
  AxisCompressor<Bits, N> compressor_{axis_jobs_, axis_results_};
};

}  // namespace cbvh::rtl
