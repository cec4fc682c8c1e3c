// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "fpga/host/messages.h"
#include "testbench/backend/backend.h"

namespace cbvh::emulator {

/// A unit with its parameters, as OPEN chooses it.
struct OpenUnit {
  const vectors::UnitDescription* unit;
  vectors::Parameters parameters;

  std::size_t stimulus_bytes() const { return unit->stimulus(parameters.bits).packed_bytes(); }
  std::size_t record_bytes() const {
    return host::BatchResults::record_bytes(unit->response(parameters.bits).packed_bytes());
  }
};

/// What a batch has given; the results point into `records`.
struct BatchOutcome {
  host::BatchResults results;
  std::vector<host::Bytes> records;  ///< of each episode
};

/// Bytes of the RESULTS payload that has all the responses wanted.
std::uint64_t result_bytes(const host::Batch& batch, const OpenUnit& unit);

/// Runs batches through the C++ modules, without stalls.
class BatchRunner {
 public:
  BatchRunner() : backend_(testbench::make_backend("rtl")) {}

  const testbench::Backend& backend() const { return *backend_; }
  /// Every episode, as many responses as fit `most` bytes of payload; those wanted must fit. Throws what the modules
  /// throw.
  BatchOutcome run(const host::Batch& batch, const OpenUnit& unit, std::size_t most);

 private:
  const vectors::VectorSet& make_episode(const host::Batch::Episode& episode, const OpenUnit& unit);

  std::unique_ptr<testbench::Backend> backend_;
  std::unique_ptr<vectors::VectorSet> episode_;  ///< the last one
};

}  // namespace cbvh::emulator
