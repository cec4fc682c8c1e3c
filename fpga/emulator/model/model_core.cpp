// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/model/model_core.h"

#include <algorithm>
#include <exception>

#include "vectors/registry.h"

namespace cbvh::emulator {

namespace {

using host::ByteSpan;
using host::ErrorReason;

constexpr std::uint16_t kFirmwareVersion = 1;
constexpr std::uint32_t kClockKhz = 100'000;
constexpr std::size_t kOpenBytes = 8;

/// The bytes that a VECTORS payload must have, as far as its fields tell.
std::uint64_t wanted_bytes(ByteSpan payload, std::size_t stimulus_bytes) {
  std::uint64_t bytes = host::Batch::kFixedBytes;
  if (payload.size() < bytes) return bytes;
  const auto episodes = host::read_at<std::uint16_t>(payload, 10);
  for (unsigned i = 0; i < episodes; ++i) {
    const std::uint64_t head = bytes;
    bytes += host::Batch::kEpisodeBytes;
    if (payload.size() < bytes) return bytes;
    bytes += std::uint64_t{host::read_at<std::uint32_t>(payload, static_cast<std::size_t>(head))} * stimulus_bytes;
  }
  return bytes;
}

std::uint32_t clamp_to_32_bits(std::uint64_t value) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(value, UINT32_MAX));
}

bool contains(const std::vector<int>& values, int value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

std::uint16_t mask_of(const std::vector<int>& values) {
  unsigned mask = 0;
  for (const int value : values) mask |= 1U << static_cast<unsigned>(value);
  return static_cast<std::uint16_t>(mask);
}

std::vector<vectors::UnitDescription> offered_units(const testbench::Backend& backend, const CoreOptions& options) {
  std::vector<vectors::UnitDescription> units;
  for (const vectors::UnitDescription& unit : vectors::units()) {
    if (!backend.has(unit) || (!options.unit.empty() && unit.name != options.unit)) continue;
    if (options.bits && !contains(unit.bits, *options.bits)) continue;
    if (options.treelet && !contains(unit.treelets, *options.treelet)) continue;
    units.push_back(unit);
    if (options.bits) units.back().bits = {*options.bits};
    if (options.treelet) units.back().treelets = {*options.treelet};
  }
  if (units.empty()) {
    if (!options.unit.empty()) vectors::find_unit(options.unit);  // throws for a name that does not exist
    const auto found = [](const std::optional<int>& value) { return value ? fmt::format("{}", *value) : "any"; };
    throw golden::InputError("parameters", fmt::format("found N = {}, D = {}: no unit has these", found(options.bits),
                                                       found(options.treelet)));
  }
  return units;
}

}  // namespace

ModelCore::ModelCore(const CoreOptions& options)
    : options_(options), units_(offered_units(runner_.backend(), options)), reader_(options.greatest_payload_in) {}

void ModelCore::reset() {
  reader_ = host::FrameReader(options_.greatest_payload_in);
  sending_.clear();
  sent_ = 0;
  forget();
}

void ModelCore::forget() {
  open_.reset();
  worker_.forget();
  queue_.clear();
  batches_queued_ = 0;
  sequence_ = {};
  next_sequence_ = 0;
  taken_ = batches_ = cycles_ = 0;
  counted_before_ = reader_.counters();
}

void ModelCore::receive(std::span<const std::uint8_t> bytes) {
  reader_.feed(bytes);
  while (const auto frame = reader_.next()) take(*frame);
}

void ModelCore::take(const host::FrameReader::Frame& frame) {
  const std::uint32_t sequence = frame.header.sequence;
  if (frame.kind == host::FrameReader::Kind::other_version) {
    return refuse(sequence, ErrorReason::version, host::kProtocolVersion);
  }
  if (frame.kind == host::FrameReader::Kind::whole && frame.header.type == FrameType::reset && frame.payload.empty()) {
    return restart(sequence);
  }
  const std::uint64_t lost = sequence_.lost();
  if (!sequence_.take(sequence)) return;
  ++taken_;
  if (sequence_.lost() != lost) answer(FrameType::credit, host::BoardCredit());
  if (frame.kind == host::FrameReader::Kind::too_long) {
    return refuse(sequence, ErrorReason::length, options_.greatest_payload_in);
  }
  take_whole(frame.header, frame.payload);
}

void ModelCore::take_whole(const host::Header& header, ByteSpan payload) {
  const bool empty =
      header.type == FrameType::hello || header.type == FrameType::status || header.type == FrameType::reset;
  if (empty && !payload.empty()) return refuse(header.sequence, ErrorReason::length, 0);
  switch (header.type) {
    case FrameType::hello:
      return answer(FrameType::board_hello, hello());
    case FrameType::status:
      return answer(FrameType::board_status, status());
    case FrameType::open:
      return take_open(header.sequence, payload);
    case FrameType::vectors:
      return take_vectors(header.sequence, payload);
    default:
      return refuse(header.sequence, ErrorReason::type, static_cast<std::uint32_t>(header.type));
  }
}

void ModelCore::restart(std::uint32_t sequence) {
  if (sent_ == 0) sending_.clear();  // of a frame that has begun the rest still goes out
  forget();
  sequence_.restart(sequence);
  answer(FrameType::board_reset, host::BoardCredit());
}

void ModelCore::refuse(std::uint32_t sequence, ErrorReason reason, std::uint32_t detail) {
  answer(FrameType::error, host::BoardError{0, reason, sequence, detail});
}

void ModelCore::take_open(std::uint32_t sequence, ByteSpan payload) {
  open_.reset();  // no batch may run in a unit that the host believes to be another
  const auto request = host::OpenRequest::parse(payload);
  if (!request) return refuse(sequence, ErrorReason::length, kOpenBytes);
  const auto unit = std::find_if(units_.begin(), units_.end(),
                                 [&](const auto& offered) { return host::unit_id(offered.name) == request->unit; });
  if (unit == units_.end()) return refuse(sequence, ErrorReason::unit, request->unit);
  if (!contains(unit->bits, request->bits) || !contains(unit->treelets, request->treelet)) {
    return refuse(sequence, ErrorReason::parameters, request->bits + 256U * request->treelet);
  }
  open_ = OpenUnit{&*unit, {request->bits, request->treelet}};
  answer(FrameType::board_open, host::OpenAnswer{0, request->unit, request->bits, request->treelet,
                                                 static_cast<std::uint32_t>(unit->stimulus(request->bits).width),
                                                 static_cast<std::uint32_t>(unit->response(request->bits).width)});
}

void ModelCore::take_vectors(std::uint32_t sequence, ByteSpan payload) {
  if (!open_) return refuse(sequence, ErrorReason::not_open, 0);
  if (batches_queued_ == options_.buffers) return refuse(sequence, ErrorReason::credit, credit());
  const auto batch = host::Batch::parse(payload, open_->stimulus_bytes());
  if (!batch) {
    const std::uint64_t wanted = wanted_bytes(payload, open_->stimulus_bytes());
    return refuse(sequence, ErrorReason::length, clamp_to_32_bits(wanted));
  }
  if (result_bytes(*batch, *open_) > options_.greatest_payload_out) {
    return refuse(sequence, ErrorReason::responses, options_.greatest_payload_out);
  }
  ++batches_queued_;
  auto compute = [this, unit = *open_, bytes = Bytes(payload.begin(), payload.end())] {
    const auto parsed = host::Batch::parse(bytes, unit.stimulus_bytes());
    const BatchOutcome outcome = runner_.run(*parsed, unit, options_.greatest_payload_out);
    Bytes frame = host::begin_frame(outcome.results.payload_bytes());
    outcome.results.append_payload(frame);
    return ComputedBatch{std::move(frame), outcome.results.cycles};
  };
  answer(FrameType::results, QueuedBatch{worker_.start(std::move(compute)), batch->number, sequence});
}

std::uint32_t ModelCore::credit() const { return sequence_.next() + (options_.buffers - batches_queued_); }

host::BoardStatus ModelCore::status() const {
  host::BoardStatus status;
  status.taken = taken_;
  status.skipped = static_cast<std::uint32_t>(reader_.counters().skipped - counted_before_.skipped);
  status.corrupted = static_cast<std::uint32_t>(reader_.counters().corrupted - counted_before_.corrupted);
  status.lost = static_cast<std::uint32_t>(sequence_.lost());
  status.stale = static_cast<std::uint32_t>(sequence_.stale());
  return status;
}

host::BoardHello ModelCore::hello() const {
  host::BoardHello hello;
  hello.firmware_version = kFirmwareVersion;
  hello.buffers = options_.buffers;
  hello.clock_khz = kClockKhz;
  hello.greatest_payload_in = options_.greatest_payload_in;
  hello.greatest_payload_out = options_.greatest_payload_out;
  hello.name = "cbvh model core";
  for (const vectors::UnitDescription& unit : units_) {
    hello.units.push_back(
        {host::unit_id(unit.name), std::string(unit.name), mask_of(unit.bits), mask_of(unit.treelets), unit.stateful});
  }
  return hello;
}

std::vector<std::uint8_t> ModelCore::send(std::size_t most) {
  Bytes bytes;
  while (bytes.size() < most) {
    if (sent_ == sending_.size()) {
      sending_.clear();
      sent_ = 0;
      if (queue_.empty()) break;
      send_next();
    }
    const std::size_t count = std::min(most - bytes.size(), sending_.size() - sent_);
    const auto begin = sending_.begin() + static_cast<std::ptrdiff_t>(sent_);
    bytes.insert(bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    sent_ += count;
  }
  return bytes;
}

void ModelCore::send_next() {
  Queued next = std::move(queue_.front());
  queue_.pop_front();
  if (auto* const batch = std::get_if<QueuedBatch>(&next.answer)) {
    --batches_queued_;
    return send_batch(*batch);
  }
  std::visit(
      [&]<class Message>(Message& message) {
        if constexpr (!std::is_same_v<Message, QueuedBatch>) {
          message.credit = credit();
          if constexpr (std::is_same_v<Message, host::BoardStatus>) {
            message.batches = batches_;
            message.cycles = cycles_;
          }
          append_frame(next.type, message.to_payload());
        }
      },
      next.answer);
}

void ModelCore::send_batch(QueuedBatch& queued) {
  try {
    ComputedBatch computed = queued.computed.get();
    ++batches_;
    cycles_ += computed.cycles;
    Bytes credit_bytes;
    host::append(credit_bytes, credit());
    std::copy(credit_bytes.begin(), credit_bytes.end(), computed.frame.begin() + host::kHeaderBytes);
    host::finish_frame(computed.frame, FrameType::results, next_sequence_++);
    sending_ = std::move(computed.frame);  // all before it has been sent
  } catch (const std::exception&) {
    const host::BoardError error{credit(), ErrorReason::internal, queued.sequence, queued.number};
    append_frame(FrameType::error, error.to_payload());
  }
}

void ModelCore::append_frame(FrameType type, const Bytes& payload) {
  host::append_frame(sending_, type, next_sequence_++, payload);
}

}  // namespace cbvh::emulator
