// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/model/batch_runner.h"

#include <algorithm>

#include "vectors/registry.h"

namespace cbvh::emulator {

using host::Batch;
using host::BatchResults;

std::uint64_t result_bytes(const Batch& batch, const OpenUnit& unit) {
  std::uint64_t bytes = BatchResults::kFixedBytes;
  for (const Batch::Episode& episode : batch.episodes) {
    bytes += BatchResults::kEpisodeBytes + std::uint64_t{episode.wanted} * unit.record_bytes();
  }
  return bytes;
}

/// The stimuli of an episode: one case of a unit with state, as many cases as stimuli of one without.
const vectors::VectorSet& BatchRunner::make_episode(const Batch::Episode& episode, const OpenUnit& unit) {
  if (!episode_ || &episode_->unit() != unit.unit || !(episode_->parameters() == unit.parameters)) {
    episode_ = vectors::make_set(*unit.unit, unit.parameters, 0);
  }
  vectors::VectorSet& set = *episode_;
  set.clear();
  const vectors::PayloadCodec& codec = set.stimulus_codec();
  const std::size_t bytes = codec.packed_bytes();
  if (unit.unit->stateful) set.begin_case(0, 0);
  for (std::size_t i = 0; i < episode.stimuli; ++i) {
    if (!unit.unit->stateful) set.begin_case(i, 0);
    codec.unpack(episode.packed.data() + i * bytes, set.add_stimulus());  // where padding is, there are no wires
  }
  for (std::size_t i = 0; unit.unit->stateful && i < episode.wanted; ++i) set.add_response();
  return set;
}

BatchOutcome BatchRunner::run(const Batch& batch, const OpenUnit& unit, std::size_t most) {
  const vectors::PayloadCodec& codec = unit.unit->response(unit.parameters.bits);
  const std::size_t record_bytes = unit.record_bytes();
  std::size_t surplus_room = (most - static_cast<std::size_t>(result_bytes(batch, unit))) / record_bytes;
  testbench::RunOptions options;
  options.hang_cycles = batch.hang_cycles;
  options.drain_cycles = batch.drain_cycles;
  std::uint64_t cycles = 0;
  BatchOutcome outcome;
  outcome.results.number = batch.number;
  outcome.records.resize(batch.episodes.size());
  for (std::size_t e = 0; e < batch.episodes.size(); ++e) {
    const Batch::Episode& wanted = batch.episodes[e];
    const testbench::Responses given = backend_->run(make_episode(wanted, unit), options);
    cycles += given.cycles;
    BatchResults::Episode episode;
    std::size_t responses = 0;
    for (std::size_t c = 0; c < given.cases(); ++c) {
      responses += given.at_case(c).size;
      episode.hung = episode.hung || given.at_case(c).hung;
    }
    const std::size_t surplus = responses - std::min<std::size_t>(responses, wanted.wanted);
    episode.more = surplus > surplus_room;
    const std::size_t kept = responses - surplus + std::min(surplus, surplus_room);
    surplus_room -= std::min(surplus, surplus_room);
    episode.responses = static_cast<std::uint32_t>(kept);
    host::Bytes& records = outcome.records[e];
    records.resize(kept * record_bytes);
    for (std::size_t i = 0; i < kept; ++i) {
      std::uint8_t* const record = records.data() + i * record_bytes;
      for (unsigned b = 0; b < 4; ++b) record[b] = static_cast<std::uint8_t>(given.latency(i) >> (8 * b));
      codec.pack(given.response(i), record + 4);
    }
    episode.records = records;
    outcome.results.episodes.push_back(episode);
  }
  outcome.results.cycles = static_cast<std::uint32_t>(cycles);
  return outcome;
}

}  // namespace cbvh::emulator
