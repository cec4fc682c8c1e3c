// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/batch_plan.h"

#include <algorithm>

#include "fpga/host/link_error.h"

namespace cbvh::host {

namespace {

constexpr std::size_t kMostEpisodes = 65535;

struct Size {
  std::size_t in;   ///< bytes to the board
  std::size_t out;  ///< from it
};

/// Bytes of an episode in the two payloads.
Size episode_size(const vectors::VectorSet& set, std::size_t stimuli, std::size_t responses) {
  return {Batch::kEpisodeBytes + stimuli * set.stimulus_codec().packed_bytes(),
          BatchResults::kEpisodeBytes + responses * BatchResults::record_bytes(set.response_codec().packed_bytes())};
}

[[noreturn]] void too_large(const vectors::VectorSet& set, std::size_t index, Size size, Size room,
                            const std::string& device) {
  throw LinkError(
      LinkFault::too_large, device,
      fmt::format("case {} of {} needs {} bytes to the board and {} from it, room is for {} and {}: none of "
                  "{} cases was run; take shorter cases",
                  set.head(index).id, set.unit().name, size.in, size.out, room.in, room.out, set.size()));
}

std::vector<PlannedBatch> plan_stream(const vectors::VectorSet& set, Size room, const std::string& device) {
  const Size empty = episode_size(set, 0, 0);
  const Size one = episode_size(set, 1, 1);
  if (one.in > room.in || one.out > room.out) too_large(set, 0, one, room, device);
  const std::size_t most =
      std::min((room.in - empty.in) / (one.in - empty.in), (room.out - empty.out) / (one.out - empty.out));
  std::vector<PlannedBatch> batches;
  for (std::size_t first = 0; first < set.size(); first += most) {
    batches.push_back({first, std::min(most, set.size() - first)});
  }
  return batches;
}

std::vector<PlannedBatch> plan_episodes(const vectors::VectorSet& set, Size room, const std::string& device) {
  std::vector<PlannedBatch> batches;
  Size left{0, 0};
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Size size = episode_size(set, set.stimulus_range(i).size, set.response_range(i).size);
    if (size.in > room.in || size.out > room.out) too_large(set, i, size, room, device);
    if (batches.empty() || size.in > left.in || size.out > left.out || batches.back().cases == kMostEpisodes) {
      batches.push_back({i, 0});
      left = room;
    }
    ++batches.back().cases;
    left = {left.in - size.in, left.out - size.out};
  }
  return batches;
}

void append_episode(Bytes& out, const vectors::VectorSet& set, vectors::VectorSet::Range stimuli, std::size_t wanted) {
  const vectors::PayloadCodec& codec = set.stimulus_codec();
  append(out, static_cast<std::uint32_t>(stimuli.size));
  append(out, static_cast<std::uint32_t>(wanted));
  std::size_t at = out.size();
  out.resize(at + stimuli.size * codec.packed_bytes());
  for (std::size_t i = 0; i < stimuli.size; ++i, at += codec.packed_bytes()) {
    codec.pack(set.stimulus_at(stimuli.begin + i), out.data() + at);
  }
}

/// Responses wanted of each episode of a batch.
template <class F>
void each_episode(const vectors::VectorSet& set, const PlannedBatch& batch, F&& f) {
  if (!set.unit().stateful) {
    f(vectors::VectorSet::Range{batch.first_case, batch.cases}, batch.cases);
    return;
  }
  for (std::size_t i = batch.first_case; i < batch.first_case + batch.cases; ++i) {
    f(set.stimulus_range(i), set.response_range(i).size);
  }
}

void deliver_response(const BatchResults::Episode& episode, std::size_t index, std::size_t record, ResponseSink& sink) {
  const ByteSpan bytes = episode.records.subspan(index * record, record);
  sink.response(bytes.data() + 4, read_at<std::uint32_t>(bytes, 0));
}

}  // namespace

std::vector<PlannedBatch> plan_batches(const vectors::VectorSet& set, const BoardHello& board,
                                       const std::string& device) {
  const auto room_of = [](std::uint32_t payload, std::size_t fixed) {
    return std::size_t{payload} > fixed ? std::size_t{payload} - fixed : 0;
  };
  const Size room{room_of(board.greatest_payload_in, Batch::kFixedBytes),
                  room_of(board.greatest_payload_out, BatchResults::kFixedBytes)};
  return set.unit().stateful ? plan_episodes(set, room, device) : plan_stream(set, room, device);
}

std::size_t batch_bytes(const vectors::VectorSet& set, const PlannedBatch& batch) {
  std::size_t bytes = Batch::kFixedBytes;
  each_episode(set, batch, [&](vectors::VectorSet::Range stimuli, std::size_t wanted) {
    bytes += episode_size(set, stimuli.size, wanted).in;
  });
  return bytes;
}

void append_batch(Bytes& out, const vectors::VectorSet& set, const PlannedBatch& batch, std::uint32_t number,
                  const RunLimits& limits) {
  append(out, number);
  append(out, limits.hang_cycles);
  append(out, limits.drain_cycles);
  append(out, static_cast<std::uint16_t>(set.unit().stateful ? batch.cases : 1));
  each_episode(set, batch, [&](vectors::VectorSet::Range stimuli, std::size_t wanted) {
    append_episode(out, set, stimuli, wanted);
  });
}

bool fits(const BatchResults& results, const vectors::VectorSet& set, const PlannedBatch& batch) {
  std::size_t index = 0;
  bool good = true;
  each_episode(set, batch, [&](vectors::VectorSet::Range, std::size_t wanted) {
    if (index < results.episodes.size()) {
      const BatchResults::Episode& episode = results.episodes[index];
      good = good && (episode.responses >= wanted || (episode.hung && !episode.more));
    }
    ++index;
  });
  return good && index == results.episodes.size();
}

void deliver(const BatchResults& results, const vectors::VectorSet& set, const PlannedBatch& batch,
             ResponseSink& sink) {
  const std::size_t record = BatchResults::record_bytes(set.response_codec().packed_bytes());
  if (set.unit().stateful) {
    for (const BatchResults::Episode& episode : results.episodes) {
      for (std::size_t i = 0; i < episode.responses; ++i) deliver_response(episode, i, record, sink);
      if (episode.more) sink.surplus();
      sink.end_case(episode.hung);
    }
    return;
  }
  const BatchResults::Episode& episode = results.episodes.front();
  for (std::size_t i = 0; i < batch.cases; ++i) {
    if (i < episode.responses) deliver_response(episode, i, record, sink);
    if (i + 1 == batch.cases) {  // a surplus response is the last case's
      for (std::size_t j = batch.cases; j < episode.responses; ++j) deliver_response(episode, j, record, sink);
      if (episode.more) sink.surplus();
    }
    sink.end_case(episode.hung && (i >= episode.responses || i + 1 == batch.cases));
  }
}

}  // namespace cbvh::host
