// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "fpga/host/session.h"

namespace cbvh::host {

/// One run of a set on a board: which batches are to be sent, are under way, and are done. Every wait is bounded: the
/// board is asked after a timeout, reset after so many questions, and given up after so many resets without a batch
/// done; a batch is sent only so many times.
class BatchRun {
 public:
  BatchRun(Session& session, const vectors::VectorSet& set, const RunLimits& limits, ResponseSink& sink);

  /// Throws LinkError when it cannot.
  void complete();

  std::size_t cases_done() const { return cases_done_; }
  std::uint64_t cycles() const { return cycles_; }

 private:
  struct State {
    bool done = false;
    unsigned lost = 0;  ///< times sent without an answer
    Bytes results;      ///< payload of RESULTS, until all before it are delivered
  };
  /// A frame that awaits its answer.
  struct Sent {
    std::uint32_t sequence;
    std::size_t batch;  ///< or kProbe
  };
  static constexpr std::size_t kProbe = ~std::size_t{0};

  void step();
  void send_batches();
  void send_batch(std::size_t batch);
  void probe();
  void silence();
  void recover();
  void repair(const LinkError& error);
  void note_recovery(const std::string& why);

  void handle(const Link::Frame& frame);
  void handle_results(ByteSpan payload);
  void handle_status();
  void handle_error(ByteSpan payload);
  /// The frame at `position` has been answered: those before it are lost.
  void answered(std::size_t position);
  void send_again(std::size_t batch);
  void deliver_in_order();
  bool awaits_batch() const;

  Session& session_;
  Link& link_;
  const vectors::VectorSet& set_;
  Session::Open wanted_;
  RunLimits limits_;
  ResponseSink& sink_;
  std::vector<PlannedBatch> plan_;
  std::vector<State> states_;
  std::uint32_t first_number_;
  std::deque<std::size_t> to_send_;
  std::deque<Sent> sent_;
  Clock::time_point deadline_;
  unsigned probes_ = 0;      ///< without an answer that helped
  unsigned recoveries_ = 0;  ///< without a batch done
  bool given_up_ = false;
  std::size_t batches_done_ = 0;
  std::size_t delivered_ = 0;
  std::size_t cases_done_ = 0;
  std::uint64_t cycles_ = 0;
};

}  // namespace cbvh::host
