// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "testbench/report/json.h"

namespace cbvh::testbench {

struct BoardBench {
  std::string unit = "axis_compressor";
  std::uint64_t cases = 100000;
  unsigned repeat = 5;
};

/// Bytes of one direction. The payload is what the vectors are: packed stimuli, or responses with their latencies.
struct LinkShare {
  std::uint64_t bytes = 0;    ///< in frames
  std::uint64_t payload = 0;  ///< of them
  double overhead = 0;        ///< of frames and batches, per cent of the bytes, when every batch is full
};

struct BoardSpeed {
  std::string device;
  std::string unit;
  std::uint64_t vectors = 0;  ///< stimuli
  std::uint64_t checks = 0;
  std::uint64_t failures = 0;
  double seconds = 0;  ///< of the link alone: nothing is compared meanwhile
  LinkShare to_board;
  LinkShare from_board;
  double vectors_per_second = 0;
  double bytes_per_second = 0;    ///< both directions
  double high_speed_vectors = 0;  ///< a second, that 40 MB/s for both directions together would allow
  std::uint64_t resent = 0;       ///< batches
};

/// Runs one set several times, compares all of it, and measures. Throws Unavailable, LinkError, InputError.
BoardSpeed bench_board(const BoardBench& options);

std::string to_string(const BoardSpeed& speed);
Json to_json(const BoardSpeed& speed);

}  // namespace cbvh::testbench
