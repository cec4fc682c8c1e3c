// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "fpga/host/batch_plan.h"
#include "fpga/host/link.h"
#include "vectors/vector_set.h"

namespace cbvh::host {

struct SessionOptions {
  Milliseconds timeout{2000};            ///< of silence, until the board is asked; must cover the run of one batch
  Milliseconds reconnect_timeout{5000};  ///< for a device that went to come back
  unsigned tries = 3;                    ///< of STATUS, RESET, HELLO and OPEN
  unsigned resends = 16;                 ///< of one batch
  unsigned recoveries = 8;               ///< by RESET or by connecting again, without a batch done between
};

struct SessionCounters {
  std::uint64_t batches = 0;  ///< sent, with those sent again
  std::uint64_t resent = 0;
  std::uint64_t probes = 0;      ///< STATUS sent
  std::uint64_t recoveries = 0;  ///< RESET in the middle of a run
  std::uint64_t reconnects = 0;
  std::uint64_t cases_done = 0;
};

/// A conversation with one board: docs/board_protocol.md, the host's side. Whatever the link does, a run ends with the
/// responses of every case or with a LinkError which says how many were done.
class Session {
 public:
  /// Resets the board and asks what it has. Throws LinkError: protocol_version, firmware_version, timeout, gone.
  explicit Session(std::unique_ptr<Transport> transport, const SessionOptions& options = {});

  const BoardHello& board() const { return board_; }
  std::string device() const { return transport_->device(); }
  /// What the board says of a unit; null when it does not have it.
  const OfferedUnit* find(std::string_view unit) const;

  /// Runs every case of a set and hands over the responses, in the set's order. Returns the cycles that the board
  /// counted. Throws LinkError.
  std::uint64_t run(const vectors::VectorSet& set, const RunLimits& limits, ResponseSink& sink);

  /// Asks for the board's counters. Throws LinkError.
  BoardStatus status();

  SessionCounters counters() const { return counters_; }
  LinkCounters link_counters() const { return link_.counters(); }

 private:
  friend class BatchRun;
  struct Open {
    const vectors::UnitDescription* unit;
    vectors::Parameters parameters;
  };

  void start();
  void open(const Open& what);
  /// Has a unit open for a run.
  void prepare(const Open& wanted);
  /// RESET, and a unit open again.
  void recover(const Open& wanted);
  std::optional<Link::Frame> ask(FrameType request, const Bytes& payload, FrameType answer);
  std::optional<Link::Frame> wait_for(FrameType answer);
  void check_error(ByteSpan payload) const;

  SessionOptions options_;
  std::unique_ptr<Transport> transport_;
  Link link_;
  BoardHello board_;
  std::optional<Open> open_;
  bool broken_ = false;  ///< the last run was not completed
  std::uint32_t next_batch_ = 0;
  SessionCounters counters_;
};

}  // namespace cbvh::host
