// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/session.h"

#include <algorithm>
#include <utility>

#include "fpga/host/batch_run.h"

namespace cbvh::host {

namespace {

constexpr std::size_t kUnknownGreatestPayload = 65536;
/// The high byte changes with what a host must know; the low byte counts releases.
constexpr std::uint16_t kFirmwareGeneration = 0;

std::string first_unit_names(const BoardHello& board) {
  std::string names;
  for (const OfferedUnit& unit : board.units) names += (names.empty() ? "" : ", ") + unit.name;
  return names.empty() ? "none" : names;
}

}  // namespace

Session::Session(std::unique_ptr<Transport> transport, const SessionOptions& options)
    : options_(options), transport_(std::move(transport)), link_(*transport_, options.timeout) {
  for (unsigned attempt = 1;; ++attempt) {
    try {
      start();
      return;
    } catch (const LinkError& error) {  // a timeout has been tried often enough
      if (error.fault() == LinkFault::timeout || !may_pass(error.fault()) || attempt > options_.recoveries) throw;
      if (error.fault() == LinkFault::gone && !transport_->reconnect(options_.reconnect_timeout)) throw;
    }
  }
}

const OfferedUnit* Session::find(std::string_view unit) const {
  const auto found = std::find_if(board_.units.begin(), board_.units.end(), [&](const OfferedUnit& offered) {
    return offered.id == unit_id(unit) && offered.name == unit.substr(0, kNameBytes);
  });
  return found == board_.units.end() ? nullptr : &*found;
}

/// Errors that no resending cures.
void Session::check_error(ByteSpan payload) const {
  const auto error = BoardError::parse(payload);
  if (!error) return;
  switch (error->reason) {
    case ErrorReason::version:
      link_.fail(LinkFault::protocol_version, describe(*error) + ": load the gateware of this version");
    case ErrorReason::unit:
      link_.fail(LinkFault::unknown_unit, fmt::format("{}, only: {}", describe(*error), first_unit_names(board_)));
    case ErrorReason::parameters:
      link_.fail(LinkFault::parameters, describe(*error) + ": 'cbvh board info' lists what is");
    case ErrorReason::type:
    case ErrorReason::length:
    case ErrorReason::responses:
      link_.fail(LinkFault::refused, "refused a frame: " + describe(*error));
    case ErrorReason::not_open:
    case ErrorReason::credit:
    case ErrorReason::internal:
      return;
  }
}

std::optional<Link::Frame> Session::wait_for(FrameType answer) {
  const Clock::time_point deadline = link_.deadline();
  while (const auto frame = link_.receive(deadline)) {
    if (frame->type == answer) return frame;
    if (frame->type == FrameType::error) check_error(frame->payload);
  }
  return std::nullopt;
}

std::optional<Link::Frame> Session::ask(FrameType request, const Bytes& payload, FrameType answer) {
  for (unsigned attempt = 0; attempt < options_.tries; ++attempt) {
    link_.send(request, payload);
    if (auto frame = wait_for(answer)) return frame;
  }
  return std::nullopt;
}

void Session::start() {
  link_.take_any_sequence(true);
  const std::size_t greatest = board_.greatest_payload_in == 0 ? kUnknownGreatestPayload : board_.greatest_payload_in;
  bool reset = false;
  for (unsigned attempt = 0; attempt < options_.tries && !reset; ++attempt) {
    transport_->restart();
    link_.forget_received();
    link_.send_zeros(frame_bytes(greatest));
    link_.send(FrameType::reset);
    reset = wait_for(FrameType::board_reset).has_value();
  }
  if (!reset) {
    link_.fail(LinkFault::timeout,
               fmt::format("no answer to RESET, {} times within {} ms: is the gateware loaded, and is "
                           "this the board's device? unplug it and plug it in again",
                           options_.tries, options_.timeout.count()));
  }
  const auto frame = ask(FrameType::hello, {}, FrameType::board_hello);
  if (!frame) link_.fail(LinkFault::timeout, fmt::format("answers RESET, but {} times not HELLO", options_.tries));
  auto hello = BoardHello::parse(frame->payload);
  if (!hello) link_.fail(LinkFault::refused, "HELLO has a wrong length: load the gateware of this version");
  link_.take_any_sequence(false);
  if (hello->firmware_version >> 8 != kFirmwareGeneration) {
    link_.fail(LinkFault::firmware_version,
               fmt::format("its firmware is version {}.{}, this cbvh wants {}.x: load the gateware of this version",
                           hello->firmware_version >> 8, hello->firmware_version & 0xFF, kFirmwareGeneration));
  }
  board_ = std::move(*hello);
  link_.set_greatest_payload(std::max<std::size_t>(board_.greatest_payload_out, 4096));
}

void Session::open(const Open& what) {
  open_.reset();
  const vectors::UnitDescription& unit = *what.unit;
  const OfferedUnit* offered = find(unit.name);
  if (offered == nullptr) {
    link_.fail(LinkFault::unknown_unit, fmt::format("has no unit '{}', only: {}", unit.name, first_unit_names(board_)));
  }
  const OpenRequest request{offered->id, static_cast<std::uint8_t>(what.parameters.bits),
                            static_cast<std::uint8_t>(what.parameters.treelet)};
  const auto frame = ask(FrameType::open, request.to_payload(), FrameType::board_open);
  if (!frame) link_.fail(LinkFault::timeout, fmt::format("no answer to OPEN, {} times", options_.tries));
  const auto answer = OpenAnswer::parse(frame->payload);
  if (!answer) link_.fail(LinkFault::refused, "OPEN has a wrong length: load the gateware of this version");
  const std::size_t stimulus = unit.stimulus(what.parameters.bits).width;
  const std::size_t response = unit.response(what.parameters.bits).width;
  if (answer->unit != request.unit || answer->bits != request.bits || answer->treelet != request.treelet ||
      answer->stimulus_width != stimulus || answer->response_width != response) {
    link_.fail(
        LinkFault::parameters,
        fmt::format("opened unit {:08X} N = {} D = {} with {} and {} bits, want {:08X} N = {} D = {} with {} and "
                    "{}: load the gateware of this version",
                    answer->unit, answer->bits, answer->treelet, answer->stimulus_width, answer->response_width,
                    request.unit, request.bits, request.treelet, stimulus, response));
  }
  open_ = what;
}

void Session::recover(const Open& wanted) {
  const BoardHello board = board_;
  start();
  if (board_.name != board.name || board_.greatest_payload_in != board.greatest_payload_in ||
      board_.greatest_payload_out != board.greatest_payload_out) {
    link_.fail(LinkFault::gone, fmt::format("after a reset '{}' answers, not '{}'", board_.name, board.name));
  }
  open(wanted);
}

void Session::prepare(const Open& wanted) {
  if (std::exchange(broken_, true)) return recover(wanted);
  if (!open_ || open_->unit != wanted.unit || !(open_->parameters == wanted.parameters)) open(wanted);
}

std::uint64_t Session::run(const vectors::VectorSet& set, const RunLimits& limits, ResponseSink& sink) {
  if (set.empty()) return 0;
  BatchRun run(*this, set, limits, sink);
  try {
    run.complete();
  } catch (const LinkError& error) {
    throw LinkError(error.fault(), error.place(),
                    fmt::format("{}; {} of {} cases were done", error.message(), run.cases_done(), set.size()));
  }
  broken_ = false;
  return run.cycles();
}

BoardStatus Session::status() {
  const auto frame = ask(FrameType::status, {}, FrameType::board_status);
  if (!frame) link_.fail(LinkFault::timeout, fmt::format("no answer to STATUS, {} times", options_.tries));
  const auto status = BoardStatus::parse(frame->payload);
  if (!status) link_.fail(LinkFault::refused, "STATUS has a wrong length: load the gateware of this version");
  return *status;
}

}  // namespace cbvh::host
