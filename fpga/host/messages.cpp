// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "fpga/host/frame.h"

namespace cbvh::host {

namespace {

constexpr std::uint32_t kHung = 1U << 31;
constexpr std::uint32_t kMore = 1U << 30;

void append_name(Bytes& out, std::string_view name) {
  const std::size_t end = out.size() + kNameBytes;
  for (const char c : name.substr(0, kNameBytes)) out.push_back(static_cast<std::uint8_t>(c));
  out.resize(end);
}

std::string take_name(ByteReader& in) {
  const ByteSpan bytes = in.take(kNameBytes);
  return {bytes.begin(), std::find(bytes.begin(), bytes.end(), 0)};
}

template <class Message>
std::optional<Message> if_finished(const ByteReader& in, Message message) {
  if (!in.finished()) return std::nullopt;
  return message;
}

void append_zeros(Bytes& out, std::size_t count) { out.resize(out.size() + count); }

}  // namespace

Bytes OpenRequest::to_payload() const {
  Bytes out;
  append(out, unit);
  append(out, bits);
  append(out, treelet);
  append_zeros(out, 2);
  return out;
}

std::optional<OpenRequest> OpenRequest::parse(ByteSpan payload) {
  ByteReader in(payload);
  OpenRequest request;
  request.unit = in.take<std::uint32_t>();
  request.bits = in.take<std::uint8_t>();
  request.treelet = in.take<std::uint8_t>();
  in.take(2);
  return if_finished(in, request);
}

Bytes Batch::to_payload() const {
  Bytes out;
  std::size_t size = kFixedBytes;
  for (const Episode& episode : episodes) size += kEpisodeBytes + episode.packed.size();
  out.reserve(size);
  append(out, number);
  append(out, hang_cycles);
  append(out, drain_cycles);
  append(out, static_cast<std::uint16_t>(episodes.size()));
  for (const Episode& episode : episodes) {
    append(out, episode.stimuli);
    append(out, episode.wanted);
    append(out, episode.packed);
  }
  return out;
}

std::optional<Batch> Batch::parse(ByteSpan payload, std::size_t stimulus_bytes) {
  ByteReader in(payload);
  Batch batch;
  batch.number = in.take<std::uint32_t>();
  batch.hang_cycles = in.take<std::uint32_t>();
  batch.drain_cycles = in.take<std::uint16_t>();
  const auto count = in.take<std::uint16_t>();
  for (std::size_t i = 0; i < count && in.ok(); ++i) {
    Episode episode;
    episode.stimuli = in.take<std::uint32_t>();
    episode.wanted = in.take<std::uint32_t>();
    episode.packed = in.take(std::uint64_t{episode.stimuli} * stimulus_bytes);
    batch.episodes.push_back(episode);
  }
  return if_finished(in, std::move(batch));
}

std::optional<std::uint32_t> parse_credit(ByteSpan payload) {
  if (payload.size() < 4) return std::nullopt;
  return read_at<std::uint32_t>(payload, 0);
}

Bytes BoardHello::to_payload() const {
  Bytes out;
  append(out, credit);
  append(out, firmware_version);
  append(out, buffers);
  append(out, clock_khz);
  append(out, greatest_payload_in);
  append(out, greatest_payload_out);
  append_name(out, name);
  append(out, static_cast<std::uint16_t>(units.size()));
  append_zeros(out, 2);
  for (const OfferedUnit& unit : units) {
    append(out, unit.id);
    append_name(out, unit.name);
    append(out, unit.bits_mask);
    append(out, unit.treelet_mask);
    append(out, static_cast<std::uint8_t>(unit.stateful ? 1 : 0));
    append_zeros(out, 3);
  }
  return out;
}

std::optional<BoardHello> BoardHello::parse(ByteSpan payload) {
  ByteReader in(payload);
  BoardHello hello;
  hello.credit = in.take<std::uint32_t>();
  hello.firmware_version = in.take<std::uint16_t>();
  hello.buffers = in.take<std::uint16_t>();
  hello.clock_khz = in.take<std::uint32_t>();
  hello.greatest_payload_in = in.take<std::uint32_t>();
  hello.greatest_payload_out = in.take<std::uint32_t>();
  hello.name = take_name(in);
  const auto count = in.take<std::uint16_t>();
  in.take(2);
  for (std::size_t i = 0; i < count && in.ok(); ++i) {
    OfferedUnit unit;
    unit.id = in.take<std::uint32_t>();
    unit.name = take_name(in);
    unit.bits_mask = in.take<std::uint16_t>();
    unit.treelet_mask = in.take<std::uint16_t>();
    unit.stateful = in.take<std::uint8_t>() != 0;
    in.take(3);
    hello.units.push_back(std::move(unit));
  }
  return if_finished(in, std::move(hello));
}

Bytes OpenAnswer::to_payload() const {
  Bytes out;
  append(out, credit);
  append(out, unit);
  append(out, bits);
  append(out, treelet);
  append_zeros(out, 2);
  append(out, stimulus_width);
  append(out, response_width);
  return out;
}

std::optional<OpenAnswer> OpenAnswer::parse(ByteSpan payload) {
  ByteReader in(payload);
  OpenAnswer answer;
  answer.credit = in.take<std::uint32_t>();
  answer.unit = in.take<std::uint32_t>();
  answer.bits = in.take<std::uint8_t>();
  answer.treelet = in.take<std::uint8_t>();
  in.take(2);
  answer.stimulus_width = in.take<std::uint32_t>();
  answer.response_width = in.take<std::uint32_t>();
  return if_finished(in, answer);
}

std::size_t BatchResults::payload_bytes() const {
  std::size_t size = kFixedBytes;
  for (const Episode& episode : episodes) size += kEpisodeBytes + episode.records.size();
  return size;
}

Bytes BatchResults::to_payload() const {
  Bytes out;
  out.reserve(payload_bytes());
  append_payload(out);
  return out;
}

void BatchResults::append_payload(Bytes& out) const {
  append(out, credit);
  append(out, number);
  append(out, cycles);
  append(out, static_cast<std::uint16_t>(episodes.size()));
  append_zeros(out, 2);
  for (const Episode& episode : episodes) {
    append(out, episode.responses | (episode.hung ? kHung : 0) | (episode.more ? kMore : 0));
    append(out, episode.records);
  }
}

std::optional<BatchResults> BatchResults::parse(ByteSpan payload, std::size_t response_bytes) {
  ByteReader in(payload);
  BatchResults results;
  results.credit = in.take<std::uint32_t>();
  results.number = in.take<std::uint32_t>();
  results.cycles = in.take<std::uint32_t>();
  const auto count = in.take<std::uint16_t>();
  in.take(2);
  for (std::size_t i = 0; i < count && in.ok(); ++i) {
    const auto word = in.take<std::uint32_t>();
    Episode episode;
    episode.responses = word & (kMore - 1);
    episode.hung = (word & kHung) != 0;
    episode.more = (word & kMore) != 0;
    episode.records = in.take(std::uint64_t{episode.responses} * record_bytes(response_bytes));
    results.episodes.push_back(episode);
  }
  return if_finished(in, std::move(results));
}

Bytes BoardStatus::to_payload() const {
  Bytes out;
  for (const std::uint32_t value : {credit, taken, skipped, corrupted, lost, stale, batches, cycles})
    append(out, value);
  return out;
}

std::optional<BoardStatus> BoardStatus::parse(ByteSpan payload) {
  ByteReader in(payload);
  BoardStatus status;
  for (std::uint32_t* value : {&status.credit, &status.taken, &status.skipped, &status.corrupted, &status.lost,
                               &status.stale, &status.batches, &status.cycles}) {
    *value = in.take<std::uint32_t>();
  }
  return if_finished(in, status);
}

Bytes BoardCredit::to_payload() const {
  Bytes out;
  append(out, credit);
  return out;
}

std::optional<BoardCredit> BoardCredit::parse(ByteSpan payload) {
  ByteReader in(payload);
  return if_finished(in, BoardCredit{in.take<std::uint32_t>()});
}

Bytes BoardError::to_payload() const {
  Bytes out;
  append(out, credit);
  append(out, static_cast<std::uint16_t>(reason));
  append_zeros(out, 2);
  append(out, sequence);
  append(out, detail);
  return out;
}

std::optional<BoardError> BoardError::parse(ByteSpan payload) {
  ByteReader in(payload);
  BoardError error;
  error.credit = in.take<std::uint32_t>();
  error.reason = static_cast<ErrorReason>(in.take<std::uint16_t>());
  in.take(2);
  error.sequence = in.take<std::uint32_t>();
  error.detail = in.take<std::uint32_t>();
  return if_finished(in, error);
}

std::string describe(const BoardError& error) {
  const std::uint32_t detail = error.detail;
  switch (error.reason) {
    case ErrorReason::version:
      return fmt::format("it speaks version {} of the protocol, this cbvh version {}", detail, kProtocolVersion);
    case ErrorReason::type:
      return fmt::format("it does not know frames of type {:02X}", detail);
    case ErrorReason::length:
      return fmt::format("a payload has the wrong length, it wants {} bytes", detail);
    case ErrorReason::unit:
      return fmt::format("it has no unit of id {:08X}", detail);
    case ErrorReason::parameters:
      return fmt::format("the unit is not there with N = {}, D = {}", detail % 256, detail / 256);
    case ErrorReason::not_open:
      return "no unit is open";
    case ErrorReason::credit:
      return fmt::format("a batch came without credit, which is {}", detail);
    case ErrorReason::responses:
      return fmt::format("the responses wanted do not fit a frame: {} bytes do", detail);
    case ErrorReason::internal:
      return fmt::format("internal failure {}", detail);
  }
  return fmt::format("reason {} (detail {})", static_cast<unsigned>(error.reason), detail);
}

}  // namespace cbvh::host
