// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fpga/host/bytes.h"

/// The payloads of frames, as both sides write and read them. `to_payload` gives the bytes, `parse` reads them:
/// nothing when they are not exactly what the fields say.
namespace cbvh::host {

constexpr std::size_t kNameBytes = 32;

/// The number by which the link names a unit.
inline std::uint32_t unit_id(std::string_view name) { return crc32c(name); }

// Frames of the host.

struct OpenRequest {
  std::uint32_t unit = 0;
  std::uint8_t bits = 0;
  std::uint8_t treelet = 0;
  bool operator==(const OpenRequest&) const = default;
  Bytes to_payload() const;
  static std::optional<OpenRequest> parse(ByteSpan payload);
};

/// VECTORS. Stimuli are packed payloads of equal size, which OPEN has told.
struct Batch {
  struct Episode {
    std::uint32_t stimuli = 0;
    std::uint32_t wanted = 0;  ///< responses
    ByteSpan packed;           ///< the stimuli
  };
  std::uint32_t number = 0;
  std::uint32_t hang_cycles = 0;
  std::uint16_t drain_cycles = 0;
  std::vector<Episode> episodes;  ///< fewer than 65536

  static constexpr std::size_t kFixedBytes = 12;
  static constexpr std::size_t kEpisodeBytes = 8;
  Bytes to_payload() const;
  /// The episodes point into the payload.
  static std::optional<Batch> parse(ByteSpan payload, std::size_t stimulus_bytes);
};

// Frames of the board. All begin with the credit.

/// The credit of any of them.
std::optional<std::uint32_t> parse_credit(ByteSpan payload);

struct OfferedUnit {
  std::uint32_t id = 0;
  std::string name;                ///< at most kNameBytes
  std::uint16_t bits_mask = 0;     ///< bit n: N = n
  std::uint16_t treelet_mask = 0;  ///< bit d: D = d
  bool stateful = false;
  bool operator==(const OfferedUnit&) const = default;
};

struct BoardHello {
  std::uint32_t credit = 0;
  std::uint16_t firmware_version = 0;
  std::uint16_t buffers = 0;  ///< batches that the board holds
  std::uint32_t clock_khz = 0;
  std::uint32_t greatest_payload_in = 0;   ///< to the board, bytes
  std::uint32_t greatest_payload_out = 0;  ///< from it
  std::string name;                        ///< at most kNameBytes
  std::vector<OfferedUnit> units;
  bool operator==(const BoardHello&) const = default;
  Bytes to_payload() const;
  static std::optional<BoardHello> parse(ByteSpan payload);
};

struct OpenAnswer {
  std::uint32_t credit = 0;
  std::uint32_t unit = 0;
  std::uint8_t bits = 0;
  std::uint8_t treelet = 0;
  std::uint32_t stimulus_width = 0;  ///< bits
  std::uint32_t response_width = 0;
  bool operator==(const OpenAnswer&) const = default;
  Bytes to_payload() const;
  static std::optional<OpenAnswer> parse(ByteSpan payload);
};

/// RESULTS. Responses are records of equal size: the latency, then the packed response.
struct BatchResults {
  struct Episode {
    std::uint32_t responses = 0;
    bool hung = false;
    bool more = false;  ///< there were responses for which the buffer had no room
    ByteSpan records;
  };
  std::uint32_t credit = 0;
  std::uint32_t number = 0;
  std::uint32_t cycles = 0;
  std::vector<Episode> episodes;  ///< fewer than 65536

  static constexpr std::size_t kFixedBytes = 16;
  static constexpr std::size_t kEpisodeBytes = 4;
  static constexpr std::size_t record_bytes(std::size_t response_bytes) { return 4 + response_bytes; }
  std::size_t payload_bytes() const;
  void append_payload(Bytes& out) const;
  Bytes to_payload() const;
  /// The episodes point into the payload.
  static std::optional<BatchResults> parse(ByteSpan payload, std::size_t response_bytes);
};

struct BoardStatus {
  std::uint32_t credit = 0;
  std::uint32_t taken = 0;    ///< frames
  std::uint32_t skipped = 0;  ///< bytes
  std::uint32_t corrupted = 0;
  std::uint32_t lost = 0;
  std::uint32_t stale = 0;
  std::uint32_t batches = 0;
  std::uint32_t cycles = 0;
  bool operator==(const BoardStatus&) const = default;
  Bytes to_payload() const;
  static std::optional<BoardStatus> parse(ByteSpan payload);
};

/// RESET and CREDIT.
struct BoardCredit {
  std::uint32_t credit = 0;
  Bytes to_payload() const;
  static std::optional<BoardCredit> parse(ByteSpan payload);
};

enum class ErrorReason : std::uint16_t {
  version = 1,
  type = 2,
  length = 3,
  unit = 4,
  parameters = 5,
  not_open = 6,
  credit = 7,
  responses = 8,
  internal = 9,
};

struct BoardError {
  std::uint32_t credit = 0;
  ErrorReason reason = ErrorReason::internal;
  std::uint32_t sequence = 0;  ///< of the frame that it answers
  std::uint32_t detail = 0;
  bool operator==(const BoardError&) const = default;
  Bytes to_payload() const;
  static std::optional<BoardError> parse(ByteSpan payload);
};

/// "unit unknown (id 0123ABCD)", ...
std::string describe(const BoardError& error);

}  // namespace cbvh::host
