// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/board/connection.h"

#include <algorithm>

#include "testbench/unavailable.h"

namespace cbvh::testbench {

void add_board_options(const Command& command) {
  BoardSettings& settings = BoardConnection::instance().settings;
  command
      .add_option("--device", settings.device,
                  "of backend board: usb:VVVV:PPPP, serial=TEXT or BUS:ADDRESS; the only board there is")
      .envname("CBVH_BOARD")
      .type_name("WHICH");
  command.add_option("--baud", settings.baud, "of a board behind a UART").capture_default_str();
  command
      .add_option("--link-timeout", settings.timeout_ms,
                  "milliseconds of a board's silence, after which it is asked; more than the longest batch takes")
      .range(1, 3600000)
      .capture_default_str();
}

BoardConnection& BoardConnection::instance() {
  static BoardConnection connection;
  return connection;
}

void BoardConnection::open() {
  if (session_) return;
  if (failure_) throw *failure_;
  const std::string reason = host::why_no_usb();
  if (!reason.empty()) throw Unavailable(reason);
  const host::BoardChoice choice = host::BoardChoice::parse("--device", settings.device);
  host::SessionOptions options;
  options.timeout = host::Milliseconds(settings.timeout_ms);
  options.reconnect_timeout = std::min(options.reconnect_timeout, 10 * options.timeout);
  try {
    host::OpenOptions how;
    how.baud = settings.baud;
    session_ = std::make_unique<host::Session>(host::open_board(choice, how), options);
  } catch (const host::LinkError& error) {
    if (error.fault() == host::LinkFault::no_device) throw Unavailable(error.what());
    failure_ = error;
    throw;
  }
}

std::string BoardConnection::why_unavailable() {
  const std::lock_guard lock(mutex_);
  try {
    open();
  } catch (const Unavailable& reason) {
    return reason.what();
  }
  return {};
}

const host::OfferedUnit* BoardConnection::find(std::string_view unit) {
  const std::lock_guard lock(mutex_);
  return session_ ? session_->find(unit) : nullptr;
}

bool BoardConnection::takes(const vectors::UnitDescription& unit, const vectors::Parameters& parameters) {
  const host::OfferedUnit* offered = find(unit.name);
  return offered != nullptr && (offered->bits_mask >> parameters.bits & 1) != 0 &&
         (offered->treelet_mask >> parameters.treelet & 1) != 0;
}

std::uint64_t BoardConnection::run(const vectors::VectorSet& set, const host::RunLimits& limits,
                                   host::ResponseSink& sink) {
  const std::lock_guard lock(mutex_);
  open();
  if (failure_) throw *failure_;
  const std::uint64_t before = session_->counters().cases_done;
  try {
    return session_->run(set, limits, sink);
  } catch (const host::LinkError& error) {
    if (error.fault() == host::LinkFault::too_large) throw;
    failure_ = before == 0 ? error
                           : host::LinkError(error.fault(), error.place(),
                                             fmt::format("{}, and {} before", error.message(), before));
    throw *failure_;
  }
}

host::Session& BoardConnection::session() {
  const std::lock_guard lock(mutex_);
  open();
  return *session_;
}

}  // namespace cbvh::testbench
