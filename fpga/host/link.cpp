// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/link.h"

#include <algorithm>

namespace cbvh::host {

std::uint32_t Link::send(FrameType type, ByteSpan payload) {
  Bytes frame = begin_frame(payload.size());
  append(frame, payload);
  return send_in_place(type, std::move(frame));
}

std::uint32_t Link::send_in_place(FrameType type, Bytes frame) {
  const std::uint32_t sequence = next_sequence_++;
  finish_frame(frame, type, sequence);
  ++counters_.frames_sent;
  counters_.bytes_sent += frame.size();
  transport_.send(std::move(frame), timeout_);
  return sequence;
}

void Link::send_zeros(std::size_t bytes) { transport_.send(Bytes(bytes), timeout_); }

std::optional<Link::Frame> Link::take(const FrameReader::Frame& frame) {
  const Header& header = frame.header;
  if (frame.kind == FrameReader::Kind::other_version) {
    fail(LinkFault::protocol_version,
         fmt::format("it speaks version {} of the protocol, this cbvh version {}: load the gateware of this version",
                     header.version, kProtocolVersion));
  }
  if (frame.kind == FrameReader::Kind::too_long) return std::nullopt;
  const auto credit = parse_credit(frame.payload);
  if (static_cast<std::uint8_t>(header.type) < 0x80 || !credit) return std::nullopt;
  if (any_sequence_) {
    tracker_.restart(header.sequence);
  } else {
    const std::uint64_t lost = tracker_.lost();
    if (!tracker_.take(header.sequence)) return std::nullopt;
    gap_ = gap_ || tracker_.lost() != lost;
  }
  credit_ = *credit;
  ++counters_.frames_received;
  counters_.bytes_received += frame_bytes(frame.payload.size());
  return Frame{header.type, header.sequence, frame.payload};
}

std::optional<Link::Frame> Link::receive(Clock::time_point deadline) {
  const Clock::time_point last = transport_.now() + 10 * timeout_;
  for (;;) {
    while (const auto found = reader_.next()) {
      if (const auto frame = take(*found)) return frame;
    }
    const Clock::time_point now = transport_.now();
    if (now >= deadline) {
      if (!reader_.give_up_unfinished()) return std::nullopt;
      continue;
    }
    const auto left = std::chrono::ceil<Milliseconds>(deadline - now);
    const Bytes bytes = transport_.receive(std::max(left, Milliseconds(1)));
    reader_.feed(bytes);
    if (!bytes.empty() && reader_.in_frame()) deadline = std::min(last, std::max(deadline, this->deadline()));
  }
}

LinkCounters Link::counters() const {
  LinkCounters counters = counters_;
  counters.skipped = reader_.counters().skipped;
  counters.corrupted = reader_.counters().corrupted;
  counters.lost = tracker_.lost();
  counters.stale = tracker_.stale();
  return counters;
}

void Link::fail(LinkFault fault, const std::string& what) const { throw LinkError(fault, transport_.device(), what); }

}  // namespace cbvh::host
