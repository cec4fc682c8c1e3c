// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "fpga/host/bytes.h"

/// Frames of the board link, for both of its sides: docs/board_protocol.md.
namespace cbvh::host {

constexpr std::uint8_t kProtocolVersion = 1;
constexpr std::uint8_t kMagic[2] = {0xC5, 0xB7};
constexpr std::size_t kHeaderBytes = 16;
constexpr std::size_t kChecksumBytes = 4;

enum class FrameType : std::uint8_t {
  hello = 0x01,
  open = 0x02,
  vectors = 0x03,
  status = 0x04,
  reset = 0x05,
  board_hello = 0x81,
  board_open = 0x82,
  results = 0x83,
  board_status = 0x84,
  board_reset = 0x85,
  credit = 0x86,
  error = 0x87,
};

/// "VECTORS", ..., or "type 7F".
std::string to_string(FrameType type);

struct Header {
  std::uint8_t version = kProtocolVersion;
  FrameType type = FrameType::hello;
  std::uint32_t sequence = 0;
  std::uint32_t length = 0;  ///< of the payload, bytes
  bool operator==(const Header&) const = default;
};

/// Bytes of a frame on the link.
constexpr std::size_t frame_bytes(std::size_t payload) {
  return kHeaderBytes + payload + (payload == 0 ? 0 : kChecksumBytes);
}

void append_header(Bytes& out, const Header& header);
void append_frame(Bytes& out, FrameType type, std::uint32_t sequence, ByteSpan payload = {});
/// The beginning of a frame for finish_frame: kHeaderBytes, and room for so much payload and its checksum.
Bytes begin_frame(std::size_t payload);
/// Makes a frame of kHeaderBytes of anything and a payload: writes the header and appends the checksum.
void finish_frame(Bytes& frame, FrameType type, std::uint32_t sequence);

}  // namespace cbvh::host
