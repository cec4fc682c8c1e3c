// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/frame.h"

#include <fmt/format.h>

#include <algorithm>

namespace cbvh::host {

std::string to_string(FrameType type) {
  switch (type) {
    case FrameType::hello:
    case FrameType::board_hello:
      return "HELLO";
    case FrameType::open:
    case FrameType::board_open:
      return "OPEN";
    case FrameType::vectors:
      return "VECTORS";
    case FrameType::status:
    case FrameType::board_status:
      return "STATUS";
    case FrameType::reset:
    case FrameType::board_reset:
      return "RESET";
    case FrameType::results:
      return "RESULTS";
    case FrameType::credit:
      return "CREDIT";
    case FrameType::error:
      return "ERROR";
  }
  return fmt::format("type {:02X}", static_cast<unsigned>(type));
}

void append_header(Bytes& out, const Header& header) {
  const std::size_t begin = out.size();
  append(out, kMagic);
  append(out, header.version);
  append(out, static_cast<std::uint8_t>(header.type));
  append(out, header.sequence);
  append(out, header.length);
  append(out, crc32c(ByteSpan(out).subspan(begin)));
}

void append_frame(Bytes& out, FrameType type, std::uint32_t sequence, ByteSpan payload) {
  append_header(out, {kProtocolVersion, type, sequence, static_cast<std::uint32_t>(payload.size())});
  if (payload.empty()) return;
  append(out, payload);
  append(out, crc32c(payload));
}

Bytes begin_frame(std::size_t payload) {
  Bytes frame;
  frame.reserve(frame_bytes(payload));
  frame.resize(kHeaderBytes);
  return frame;
}

void finish_frame(Bytes& frame, FrameType type, std::uint32_t sequence) {
  const ByteSpan payload = ByteSpan(frame).subspan(kHeaderBytes);
  Bytes header;
  append_header(header, {kProtocolVersion, type, sequence, static_cast<std::uint32_t>(payload.size())});
  const std::uint32_t checksum = crc32c(payload);
  std::copy(header.begin(), header.end(), frame.begin());
  if (frame.size() > kHeaderBytes) append(frame, checksum);
}

}  // namespace cbvh::host
