// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "fpga/host/boards.h"
#include "fpga/host/session.h"
#include "testbench/command.h"

namespace cbvh::testbench {

/// Which board, and how to talk to it.
struct BoardSettings {
  std::string device;  ///< as host::BoardChoice reads it
  std::uint32_t baud = host::OpenOptions().baud;
  std::uint32_t timeout_ms = static_cast<std::uint32_t>(host::SessionOptions().timeout.count());
};

/// Adds --device, whose default is CBVH_BOARD of the environment, --baud and --link-timeout; they set
/// BoardConnection::settings.
void add_board_options(const Command& command);

/// This process's conversation with its board. It is begun when it is first needed, and ends with the process.
class BoardConnection {
 public:
  static BoardConnection& instance();

  BoardSettings settings;  ///< to be set before the first use

  /// Empty, or why there is no board. Opens it. Throws LinkError when there is one that cannot be used.
  std::string why_unavailable();
  /// What the board has; null when it has not been opened, or lacks the unit.
  const host::OfferedUnit* find(std::string_view unit);
  bool takes(const vectors::UnitDescription& unit, const vectors::Parameters& parameters);

  /// Runs a set, one thread at a time. After a run that could not be completed every other throws its error, too.
  std::uint64_t run(const vectors::VectorSet& set, const host::RunLimits& limits, host::ResponseSink& sink);

  /// For the commands that ask the board itself. Opens it. Throws Unavailable when there is none, LinkError.
  host::Session& session();

 private:
  void open();

  std::mutex mutex_;
  std::unique_ptr<host::Session> session_;
  std::optional<host::LinkError> failure_;
};

}  // namespace cbvh::testbench
