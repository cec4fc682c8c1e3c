// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "fpga/host/bytes.h"
#include "fpga/host/messages.h"
#include "vectors/vector_set.h"

namespace cbvh::host {

/// How long the board waits, in cycles of the unit.
struct RunLimits {
  std::uint32_t hang_cycles = 20000;  ///< without any progress, until a case is given up
  std::uint16_t drain_cycles = 64;    ///< after the last wanted response, in which a surplus one is seen
};

/// Consecutive cases that travel in one frame.
struct PlannedBatch {
  std::size_t first_case = 0;
  std::size_t cases = 0;
};

/// Cuts a set into batches, each as large as the board takes: payloads of VECTORS and of the RESULTS with all wanted
/// responses are no longer than its limits. Cases of a unit without state are one stream cut anywhere; an episode stays
/// whole. Throws LinkError (too_large, naming `device` and the case) when one does not fit.
std::vector<PlannedBatch> plan_batches(const vectors::VectorSet& set, const BoardHello& board,
                                       const std::string& device);

/// Bytes of the payload of VECTORS.
std::size_t batch_bytes(const vectors::VectorSet& set, const PlannedBatch& batch);
/// Appends that payload.
void append_batch(Bytes& out, const vectors::VectorSet& set, const PlannedBatch& batch, std::uint32_t number,
                  const RunLimits& limits);

/// Takes the responses of a set, in its order.
class ResponseSink {
 public:
  ResponseSink() = default;
  virtual ~ResponseSink() = default;
  ResponseSink(const ResponseSink&) = delete;
  ResponseSink& operator=(const ResponseSink&) = delete;

  virtual void response(const std::uint8_t* packed, std::uint32_t latency) = 0;
  /// A response of which nothing is known but that it came, and should not have.
  virtual void surplus() = 0;
  virtual void end_case(bool hung) = 0;
};

/// Whether these can be the results of the batch: as many episodes, and no response left out but surplus ones.
bool fits(const BatchResults& results, const vectors::VectorSet& set, const PlannedBatch& batch);

/// Hands over results that fit.
void deliver(const BatchResults& results, const vectors::VectorSet& set, const PlannedBatch& batch, ResponseSink& sink);

}  // namespace cbvh::host
