// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "tests/support/loopback.h"
#include "vectors/registry.h"

namespace {

using namespace cbvh;
using namespace cbvh::host;
using cbvh::testing::FakeBoard;
using cbvh::testing::Fault;
using cbvh::testing::kFaultNames;
using cbvh::testing::kFaults;
using cbvh::testing::Loopback;

/// Compares what comes with the set, response by response.
class Checker final : public ResponseSink {
 public:
  explicit Checker(const vectors::VectorSet& set) : set_(set), object_(set.response_codec().object_size) {}

  void response(const std::uint8_t* packed, std::uint32_t latency) override {
    Bytes want(set_.response_codec().packed_bytes());
    if (next_ < set_.response_count()) set_.response_codec().pack(set_.response_at(next_), want.data());
    const bool equal = next_ < set_.response_count() && std::memcmp(packed, want.data(), want.size()) == 0 &&
                       latency == set_.latency_at(next_);
    (equal ? right : wrong) += 1;
    ++next_;
  }
  void surplus() override { ++surpluses; }
  void end_case(bool hung) override {
    hangs += hung ? 1u : 0u;
    ++cases;
  }

  std::size_t right = 0;
  std::size_t wrong = 0;
  std::size_t surpluses = 0;
  std::size_t hangs = 0;
  std::size_t cases = 0;

 private:
  const vectors::VectorSet& set_;
  std::vector<std::byte> object_;
  std::size_t next_ = 0;
};

struct Rig {
  explicit Rig(std::uint64_t seed = 1)
      : transport(new Loopback(board, seed)), link(std::unique_ptr<Loopback>(transport)) {}

  Session& connect(const SessionOptions& options = {}) {
    session = std::make_unique<Session>(std::move(link), options);
    return *session;
  }
  /// Runs a set; true when every response came and was right.
  bool run(const vectors::VectorSet& set) {
    Checker checker(set);
    session->run(set, {}, checker);
    return checker.right == set.response_count() && checker.wrong == 0 && checker.cases == set.size() &&
           checker.hangs == 0 && checker.surpluses == 0;
  }

  FakeBoard board;
  Loopback* transport;
  std::unique_ptr<Loopback> link;
  std::unique_ptr<Session> session;
};

std::unique_ptr<vectors::VectorSet> axis(std::uint64_t cases) {
  return vectors::generate_set("axis_compressor", {}, cases, 1);
}
std::unique_ptr<vectors::VectorSet> stack(std::uint64_t cases) {
  return vectors::generate_set("context_stack", {}, cases, 1);
}

template <class F>
void expect_fault(LinkFault fault, const std::string& text, F&& f) {
  try {
    f();
    FAIL() << "no error, want '" << text << "'";
  } catch (const LinkError& error) {
    EXPECT_EQ(error.fault(), fault) << error.what();
    EXPECT_EQ(error.place(), "loopback");
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

TEST(Session, runs_every_case_of_units_with_and_without_state) {
  Rig rig;
  Session& session = rig.connect();
  EXPECT_EQ(session.board().name, "cbvh fake");
  EXPECT_TRUE(rig.run(*axis(5000)));
  EXPECT_TRUE(rig.run(*stack(200)));
  EXPECT_TRUE(rig.run(*axis(1)));
  EXPECT_TRUE(rig.run(*vectors::generate_set("axis_compressor", {8, 1}, 77, 3)));
  EXPECT_EQ(session.counters().cases_done, 5000u + 200u + 1u + 77u);
  EXPECT_EQ(session.counters().resent, 0u);
  EXPECT_EQ(session.counters().recoveries, 0u);
  EXPECT_EQ(rig.board.without_credit, 0u);
  EXPECT_EQ(session.counters().batches, rig.board.batches_run);
}

TEST(Session, batches_are_as_large_as_the_board_takes_and_never_larger) {
  BoardHello board;
  std::size_t checks = 0;
  for (const auto& set : {axis(3000), stack(300)}) {
    for (const std::uint32_t in : {2000u, 4096u, 65536u}) {
      for (const std::uint32_t out : {2000u, 4096u, 65536u}) {
        board.greatest_payload_in = in;
        board.greatest_payload_out = out;
        std::size_t next = 0;
        std::size_t full = 0;
        const auto plan = plan_batches(*set, board, "loopback");
        for (const PlannedBatch& batch : plan) {
          EXPECT_EQ(batch.first_case, next);
          next += batch.cases;
          const auto sizes = [&](std::size_t cases) {
            Bytes payload;
            append_batch(payload, *set, {batch.first_case, cases}, 0, {});
            const auto read = Batch::parse(payload, set->stimulus_codec().packed_bytes());
            std::size_t answer = BatchResults::kFixedBytes;
            for (const Batch::Episode& episode : read->episodes) {
              answer += 4 + episode.wanted * (4 + set->response_codec().packed_bytes());
            }
            return std::pair(payload.size(), answer);
          };
          const auto [to, from] = sizes(batch.cases);
          EXPECT_LE(to, in);
          EXPECT_LE(from, out);
          if (next == set->size()) continue;
          const auto [more_to, more_from] = sizes(batch.cases + 1);
          EXPECT_TRUE(more_to > in || more_from > out);
          ++full;
        }
        EXPECT_EQ(next, set->size());
        EXPECT_EQ(full + 1, plan.size());
        checks += full;
      }
    }
  }
  EXPECT_GT(checks, 100u);
}

TEST(Session, says_which_case_does_not_fit_the_board) {
  Rig rig;
  rig.board.hello.greatest_payload_in = 64;
  Session& session = rig.connect();
  const auto set = stack(50);
  Checker checker(*set);
  expect_fault(LinkFault::too_large, "none of 50 cases was run", [&] { session.run(*set, {}, checker); });
  EXPECT_EQ(checker.cases, 0u);
}

TEST(Session, errors_of_the_beginning_are_distinct_and_say_what_to_do) {
  const auto connect = [](auto&& change, LinkFault fault, const std::string& text) {
    Rig rig;
    change(rig);
    expect_fault(fault, text, [&] { rig.connect(); });
  };
  connect([](Rig& rig) { rig.board.mute = true; }, LinkFault::timeout, "no answer to RESET, 3 times within 2000 ms");
  connect([](Rig& rig) { rig.board.version = 2; }, LinkFault::protocol_version, "version 2 of the protocol");
  connect([](Rig& rig) { rig.board.hello.firmware_version = 0x0305; }, LinkFault::firmware_version, "version 3.5");
  connect(
      [](Rig& rig) {
        rig.transport->unplug();
        rig.transport->comes_back = false;
      },
      LinkFault::gone, "unplugged");
  Rig rig;
  rig.transport->unplug();
  EXPECT_NO_THROW(rig.connect());  // it comes back
}

TEST(Session, units_and_parameters_that_the_board_has_not_are_named) {
  Rig rig;
  rig.board.hello.units[0].bits_mask = 0x40;
  rig.connect();
  EXPECT_EQ(rig.session->find("stream_compressor"), nullptr);
  ASSERT_NE(rig.session->find("context_stack"), nullptr);
  EXPECT_TRUE(rig.session->find("context_stack")->stateful);
  expect_fault(LinkFault::unknown_unit, "has no unit 'scale_estimator', only: axis_compressor, context_stack",
               [&] { rig.run(*vectors::generate_set("scale_estimator", {}, 3, 1)); });
  expect_fault(LinkFault::parameters, "N = 8, D = 1", [&] {
    rig.run(*vectors::generate_set("axis_compressor", {8, 1}, 3, 1));
  });
  EXPECT_TRUE(rig.run(*axis(3)));
}

TEST(Session, a_board_that_never_answers_vectors_ends_the_run_with_the_count) {
  Rig rig;
  Session& session = rig.connect();
  rig.board.deaf_to_vectors = true;
  expect_fault(LinkFault::timeout, "sent 17 times and never answered: check cable and power; 0 of 2000 cases were done",
               [&] { rig.run(*axis(2000)); });
  rig.board.deaf_to_vectors = false;
  EXPECT_TRUE(rig.run(*axis(2000)));
  EXPECT_GT(session.counters().resent, 0u);
}

TEST(Session, a_board_that_falls_silent_in_the_middle_ends_the_run_with_the_count) {
  Rig rig;
  rig.connect();
  rig.board.tamper = [&](BatchResults&) {
    if (rig.board.batches_run == 5) rig.board.mute = true;
  };
  const auto set = axis(2000);
  const std::size_t in_batch = plan_batches(*set, rig.board.hello, "")[0].cases;
  Checker checker(*set);
  expect_fault(LinkFault::timeout, "; " + std::to_string(8 * in_batch) + " of 2000 cases were done",
               [&] { rig.session->run(*set, {}, checker); });
  EXPECT_EQ(checker.right, 8 * in_batch);
}

TEST(Session, a_board_that_goes_and_does_not_come_back_ends_the_run_with_the_count) {
  Rig rig;
  rig.connect();
  rig.transport->comes_back = false;
  rig.board.tamper = [&](BatchResults&) {
    if (rig.board.batches_run == 3) rig.transport->unplug();
  };
  expect_fault(LinkFault::gone, " of 2000 cases were done", [&] { rig.run(*axis(2000)); });
}

TEST(Session, a_board_that_refuses_vectors_is_asked_only_so_often) {
  for (const ErrorReason reason : {ErrorReason::credit, ErrorReason::internal, ErrorReason::not_open,
                                   ErrorReason::length, ErrorReason::responses}) {
    Rig rig;
    rig.connect();
    rig.board.refuse_vectors = reason;
    EXPECT_THROW(rig.run(*axis(2000)), LinkError) << static_cast<int>(reason);
    rig.board.refuse_vectors.reset();
    EXPECT_TRUE(rig.run(*axis(2000)));
  }
}

TEST(Session, results_that_are_not_those_of_the_batch_are_refused) {
  const auto tamper = [](auto&& change) {
    Rig rig;
    rig.connect();
    rig.board.tamper = change;
    expect_fault(LinkFault::refused, "; 0 of 20 cases were done", [&] { rig.run(*axis(20)); });
  };
  tamper([](BatchResults& results) { results.episodes.clear(); });
  tamper([](BatchResults& results) { results.episodes.push_back({0, false, false, {}}); });
  tamper([](BatchResults& results) { results.episodes[0] = {0, false, false, {}}; });
  tamper([](BatchResults& results) { results.episodes[0] = {0, false, true, {}}; });
  tamper([](BatchResults& results) { ++results.episodes[0].responses; });
}

TEST(Session, wrong_missing_and_surplus_responses_reach_the_sink) {
  const auto run = [](auto&& change) {
    Rig rig;
    rig.connect();
    rig.board.tamper = change;
    const auto set = axis(20);
    Checker checker(*set);
    rig.session->run(*set, {}, checker);
    EXPECT_EQ(checker.cases, 20u);
    return std::array<std::size_t, 4>{checker.right, checker.wrong, checker.surpluses, checker.hangs};
  };
  const std::size_t record = BatchResults::record_bytes(axis(1)->response_codec().packed_bytes());
  using Counts = std::array<std::size_t, 4>;
  Bytes changed;
  EXPECT_EQ(run([&](BatchResults& results) {
              changed.assign(results.episodes[0].records.begin(), results.episodes[0].records.end());
              changed[3 * record + 4] ^= 1;
              changed[5 * record] ^= 1;
              results.episodes[0].records = changed;
            }),
            (Counts{18, 2, 0, 0}));
  EXPECT_EQ(run([&](BatchResults& results) { results.episodes[0].more = true; }), (Counts{20, 0, 1, 0}));
  EXPECT_EQ(run([&](BatchResults& results) { results.episodes[0].hung = true; }), (Counts{20, 0, 0, 1}));
  EXPECT_EQ(run([&](BatchResults& results) {
              results.episodes[0] = {17, true, false, results.episodes[0].records.first(17 * record)};
            }),
            (Counts{17, 0, 0, 3}));
  EXPECT_EQ(run([&](BatchResults& results) {
              changed.assign(results.episodes[0].records.begin(), results.episodes[0].records.end());
              changed.resize(21 * record);
              results.episodes[0] = {21, false, false, changed};
            }),
            (Counts{20, 1, 0, 0}));
}

/// Calls change for the first transfer that begins with a frame of this type.
std::function<void(Bytes&)> first_of(FrameType type, std::function<void(Bytes&)> change) {
  return [=, done = false](Bytes& bytes) mutable {
    if (done || bytes.size() < kHeaderBytes || bytes[3] != static_cast<std::uint8_t>(type)) return;
    done = true;
    change(bytes);
  };
}

TEST(Session, a_lost_batch_is_sent_again_as_soon_as_a_later_one_is_answered) {
  for (const bool to_board : {true, false}) {
    Rig rig;
    rig.connect();
    const auto lose = [](Bytes& bytes) { bytes.clear(); };
    (to_board ? rig.transport->to_board : rig.transport->to_host) =
        first_of(to_board ? FrameType::vectors : FrameType::results, lose);
    const Clock::time_point start = rig.transport->now();
    EXPECT_TRUE(rig.run(*axis(2000)));
    EXPECT_LT(rig.transport->now() - start, Milliseconds(100)) << "it waited for a timeout";
    EXPECT_EQ(rig.session->counters().resent, 1u);
    EXPECT_EQ(rig.session->counters().recoveries, 0u);
  }
}

TEST(Session, frames_that_come_twice_are_dropped_and_nothing_is_sent_again) {
  Rig rig;
  rig.connect();
  rig.transport->rates[static_cast<std::size_t>(Fault::duplicate)] = 1000;
  EXPECT_TRUE(rig.run(*axis(2000)));
  EXPECT_EQ(rig.session->counters().resent, 0u);
  EXPECT_GE(rig.session->link_counters().stale, rig.session->counters().batches);
  EXPECT_EQ(rig.session->link_counters().frames_received, 3 + rig.session->counters().batches) << "RESET, HELLO, OPEN";
  EXPECT_EQ(rig.board.batches_run, rig.session->counters().batches);
  EXPECT_EQ(rig.board.without_credit, 0u);
}

TEST(Session, a_board_that_waits_for_the_end_of_a_cut_frame_is_reset) {
  Rig rig;
  rig.connect();
  rig.transport->to_board = first_of(FrameType::vectors, [](Bytes& bytes) { bytes.resize(200); });
  EXPECT_TRUE(rig.run(*axis(100)));
  EXPECT_EQ(rig.session->counters().recoveries, 1u);
}

TEST(Session, a_cut_answer_is_given_up_and_asked_for_again_without_a_reset) {
  Rig rig;
  rig.connect();
  rig.transport->to_host = first_of(FrameType::results, [](Bytes& bytes) { bytes.resize(200); });
  EXPECT_TRUE(rig.run(*axis(50)));
  EXPECT_EQ(rig.session->counters().recoveries, 0u);
  EXPECT_EQ(rig.session->counters().resent, 1u);
}

struct Tally {
  std::uint64_t runs = 0;
  std::uint64_t completed = 0;
  std::uint64_t failed = 0;
  std::uint64_t happened = 0;
};

/// One run under faults: it completes and is right, or says that it could not.
void faulted_run(std::uint64_t seed, const std::array<unsigned, kFaults>& rates, Tally& tally) {
  Rig rig(seed);
  ++tally.runs;
  const auto set = seed % 2 == 0 ? axis(2000) : stack(200);
  try {
    rig.connect();
    rig.transport->rates = rates;
    ASSERT_TRUE(rig.run(*set)) << "seed " << seed;
    ++tally.completed;
  } catch (const LinkError& error) {
    ASSERT_NE(std::string(error.what()).find("cases were done"), std::string::npos) << error.what();
    ++tally.failed;
  }
  for (const std::uint64_t count : rig.transport->happened) tally.happened += count;
}

TEST(Session, every_run_under_rare_faults_of_each_kind_completes_and_is_right) {
  for (std::size_t fault = 0; fault < kFaults; ++fault) {
    Tally tally;
    std::array<unsigned, kFaults> rates{};
    rates[fault] = fault == static_cast<std::size_t>(Fault::disconnect) ? 10 : 30;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) faulted_run(seed, rates, tally);
    EXPECT_EQ(tally.completed, tally.runs) << kFaultNames[fault];
    EXPECT_GT(tally.happened, 20u) << kFaultNames[fault];
  }
}

TEST(Session, every_run_under_heavy_faults_is_right_or_says_that_it_is_not_complete) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    vectors::Random random(seed);
    std::array<unsigned, kFaults> rates{};
    for (unsigned& rate : rates) rate = random.one_in(3) ? static_cast<unsigned>(random.below(150)) : 0;
    faulted_run(seed, rates, tally);
  }
  EXPECT_GT(tally.completed, 200u);
  EXPECT_GT(tally.happened, 5000u);
  RecordProperty("completed", static_cast<int>(tally.completed));
  RecordProperty("failed", static_cast<int>(tally.failed));
  std::printf("%d runs: %d complete and right, %d failed cleanly, %d faults\n", static_cast<int>(tally.runs),
              static_cast<int>(tally.completed), static_cast<int>(tally.failed), static_cast<int>(tally.happened));
}

}  // namespace
