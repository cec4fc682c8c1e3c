// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "rtl_model/bits/fields.h"
#include "rtl_model/kernel/channel.h"

/// A port to external memory: requests one way, answers the other. The memory takes a port's requests in order, and
/// its content is defined by the order in which it takes them: a read returns what all requests taken before it, at any
/// port, have written. A port's answers come in the order of its requests.
namespace cbvh::rtl {

constexpr int kWordsPerLine = 16;     ///< 32-bit words of a line
constexpr int kBytesPerLine = 64;     ///< the smallest access
constexpr int kLineAddressBits = 28;  ///< 16 GiB

using LineAddress = UInt<kLineAddressBits>;
using LineWords = std::array<UInt<32>, kWordsPerLine>;

/// One 64-byte access. Reads are answered with the line, writes only when they ask for an acknowledgement.
struct LineRequest {
  UInt<1> write;
  UInt<1> acknowledge;  ///< of a write: answer (with zeros) once it is taken, so that later reads at any port see it
  LineAddress line;
  UInt<kWordsPerLine> mask;  ///< of a write: the words it changes, lowest address in bit 0
  LineWords words;           ///< of a write; little-endian in memory
  static constexpr auto fields() {
    return field_list("write", &LineRequest::write, "acknowledge", &LineRequest::acknowledge, "line",
                      &LineRequest::line, "mask", &LineRequest::mask, "words", &LineRequest::words);
  }
  bool operator==(const LineRequest&) const = default;
};

/// The answer to a read, or to a write that wants one.
struct LineData {
  LineWords words;
  static constexpr auto fields() { return field_list("words", &LineData::words); }
  bool operator==(const LineData&) const = default;
};

/// The two channels of one client of a memory.
struct LinePort {
  Channel<LineRequest>* requests;
  Channel<LineData>* answers;
};

}  // namespace cbvh::rtl
