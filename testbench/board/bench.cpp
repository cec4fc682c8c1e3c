// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/board/bench.h"

#include <fmt/format.h>

#include <chrono>

#include "testbench/backend/backend.h"
#include "testbench/board/connection.h"
#include "testbench/progress.h"
#include "testbench/scoreboard/scoreboard.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

/// What a bulk link of USB 2.0 high speed carries in practice, of 53 MB/s in theory; both directions share it.
constexpr double kHighSpeedBytes = 40e6;

double per_cent_over(std::size_t frame, std::size_t payload) {
  return 100.0 * static_cast<double>(frame - payload) / static_cast<double>(frame);
}

/// The part of full batches that is not vectors. The first batch is full when there is a second.
void measure_overhead(const vectors::VectorSet& set, const host::BoardHello& board, BoardSpeed& speed) {
  const host::PlannedBatch batch = host::plan_batches(set, board, speed.device).front();
  const auto range = [&](auto of) {
    const auto last = of(batch.first_case + batch.cases - 1);
    return last.begin + last.size - of(batch.first_case).begin;
  };
  const std::size_t stimuli =
      range([&](std::size_t i) { return set.stimulus_range(i); }) * set.stimulus_codec().packed_bytes();
  const std::size_t responses = range([&](std::size_t i) { return set.response_range(i); }) *
                                host::BatchResults::record_bytes(set.response_codec().packed_bytes());
  const std::size_t episodes = set.unit().stateful ? batch.cases : 1;
  speed.to_board.overhead = per_cent_over(
      host::frame_bytes(stimuli + host::Batch::kFixedBytes + episodes * host::Batch::kEpisodeBytes), stimuli);
  speed.from_board.overhead = per_cent_over(
      host::frame_bytes(responses + host::BatchResults::kFixedBytes + episodes * host::BatchResults::kEpisodeBytes),
      responses);
}

Json share_to_json(const LinkShare& share) {
  return {{"bytes", share.bytes}, {"payload", share.payload}, {"overhead_percent", share.overhead}};
}

}  // namespace

BoardSpeed bench_board(const BoardBench& options) {
  const auto backend = make_backend("board");
  require_unit(*backend, vectors::find_unit(options.unit));
  vectors::Parameters parameters;
  for (const int bits : vectors::find_unit(options.unit).bits) {
    if (!backend->takes(vectors::find_unit(options.unit), parameters)) parameters.bits = bits;
  }
  const auto set = vectors::generate_set(options.unit, parameters, options.cases, 1);
  require_parameters(*backend, *set);
  host::Session& session = BoardConnection::instance().session();
  BoardSpeed speed;
  speed.device = session.device();
  speed.unit = options.unit;
  measure_overhead(*set, session.board(), speed);
  const host::LinkCounters before = session.link_counters();
  const std::uint64_t resent_before = session.counters().resent;
  SetReport report;
  Progress progress("board bench", options.repeat);
  for (unsigned i = 0; i < options.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const Responses found = backend->run(*set, {});
    speed.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    compare(*set, found, {}, report);
    progress.step();
  }
  const host::LinkCounters after = session.link_counters();
  speed.vectors = set->stimulus_count() * options.repeat;
  speed.checks = report.checks;
  speed.failures = report.failures;
  speed.resent = session.counters().resent - resent_before;
  speed.to_board.bytes = after.bytes_sent - before.bytes_sent;
  speed.to_board.payload = speed.vectors * set->stimulus_codec().packed_bytes();
  speed.from_board.bytes = after.bytes_received - before.bytes_received;
  speed.from_board.payload =
      set->response_count() * options.repeat * host::BatchResults::record_bytes(set->response_codec().packed_bytes());
  if (speed.seconds > 0 && speed.vectors > 0) {
    const auto bytes = static_cast<double>(speed.to_board.bytes + speed.from_board.bytes);
    const auto vectors = static_cast<double>(speed.vectors);
    speed.vectors_per_second = vectors / speed.seconds;
    speed.bytes_per_second = bytes / speed.seconds;
    speed.high_speed_vectors = kHighSpeedBytes / (bytes / vectors);
  }
  return speed;
}

std::string to_string(const BoardSpeed& speed) {
  return fmt::format(
      "{}\n{}: {} vectors in {:.3f} s, {} checks, {} failed, {} batches sent again\n"
      "vectors a second        {:.0f}\nbytes a second          {:.1f} MB/s, both directions\n"
      "to the board            {} bytes; full batches: {:.2f} % are frames\n"
      "from the board          {} bytes; full batches: {:.2f} % are frames\n"
      "USB 2.0 high speed      {:.0f} vectors a second, of 40 MB/s for both directions\n",
      speed.device, speed.unit, speed.vectors, speed.seconds, speed.checks, speed.failures, speed.resent,
      speed.vectors_per_second, speed.bytes_per_second / 1e6, speed.to_board.bytes, speed.to_board.overhead,
      speed.from_board.bytes, speed.from_board.overhead, speed.high_speed_vectors);
}

Json to_json(const BoardSpeed& speed) {
  return {{"device", speed.device},
          {"unit", speed.unit},
          {"vectors", speed.vectors},
          {"checks", speed.checks},
          {"failures", speed.failures},
          {"resent", speed.resent},
          {"seconds", speed.seconds},
          {"vectors_per_second", speed.vectors_per_second},
          {"bytes_per_second", speed.bytes_per_second},
          {"to_board", share_to_json(speed.to_board)},
          {"from_board", share_to_json(speed.from_board)},
          {"high_speed_vectors_per_second", speed.high_speed_vectors}};
}

}  // namespace cbvh::testbench
