// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The Verilog frame engine says, byte for byte, what the model core says to the same conversation.
#include "fpga/emulator/gateware/gateware_core.h"

#include <gtest/gtest.h>

#include <set>

#include "golden/input_error.h"
#include "testbench/gateware/simulator.h"
#include "testbench/unavailable.h"
#include "transcript.h"

namespace cbvh::testing {
namespace {

using emulator::GatewareCore;
using emulator::ModelCore;
using host::Bytes;
using host::FrameType;

class GatewareCoreTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string why = testbench::why_no_simulator();
    if (!why.empty()) GTEST_SKIP() << why;
  }
};

TEST_F(GatewareCoreTest, gives_the_models_responses_and_latencies_for_every_unit) {
  struct Built {
    const char* unit;
    int bits;
    int treelet;
    std::uint64_t cases = 24;
  };
  const Built all[] = {{"axis_compressor", 6, 1},      {"axis_compressor", 2, 1},
                       {"axis_compressor", 8, 1},      {"scale_estimator", 6, 1},
                       {"context_stack", 6, 1, 8},     {"node_pair_compressor", 6, 1},
                       {"node_pair_compressor", 4, 1}, {"node_pair_compressor_serial", 6, 1},
                       {"backtrack_unit", 6, 1, 8},    {"backtrack_unit", 8, 1, 8},
                       {"treelet_collector", 6, 1, 8}, {"treelet_collector", 4, 3, 8},
                       {"stream_compressor", 6, 1, 8}, {"stream_compressor", 4, 2, 8},
                       {"box_decoder", 6, 1},          {"box_decoder", 2, 1},
                       {"box_decoder", 8, 1}};
  std::set<std::string> seen;
  for (const auto& [unit, bits, treelet, cases] : all) {
    GatewareCore gateware({.unit = unit, .bits = bits, .treelet = treelet});
    ModelCore model = model_core(unit, bits, treelet);
    const Transcript found = run_vectors(gateware, unit, bits, cases, treelet);
    EXPECT_TRUE(found == run_vectors(model, unit, bits, cases, treelet))
        << unit << " N = " << bits << " D = " << treelet;
    EXPECT_GE(found.frames, 4U) << unit;
    seen.insert(unit);
  }
  for (const vectors::UnitDescription& unit : vectors::units())
    EXPECT_EQ(seen.count(std::string(unit.name)), testbench::has_twin(unit) ? 1U : 0U) << unit.name;
}

TEST_F(GatewareCoreTest, streams_that_stall_change_nothing) {
  for (const std::uint32_t seed : {1U, 2U}) {
    GatewareCore gateware({.stalls = seed});
    ModelCore model = model_core("axis_compressor", 6);
    EXPECT_TRUE(run_vectors(gateware, "axis_compressor", 6, 40) == run_vectors(model, "axis_compressor", 6, 40));
    EXPECT_TRUE(run_errors(gateware) == run_errors(model));
  }
}

TEST_F(GatewareCoreTest, says_the_same_through_the_pins_of_a_serial_line) {
  for (const std::uint32_t seed : {1U, 2U}) {  // the other end's clock is slow, fast
    GatewareCore gateware({.pins = true, .stalls = seed});
    ModelCore model = model_core("axis_compressor", 6);
    const Transcript found = run_vectors(gateware, "axis_compressor", 6, 12);
    EXPECT_GE(found.frames, 4U);
    EXPECT_TRUE(found == run_vectors(model, "axis_compressor", 6, 12));
  }
}

TEST_F(GatewareCoreTest, refuses_what_the_model_refuses_with_the_same_words) {
  GatewareCore gateware;
  ModelCore model = model_core("axis_compressor", 6);
  const Transcript found = run_errors(gateware);
  const Transcript wanted = run_errors(model);
  EXPECT_GE(found.frames, 40U);
  EXPECT_EQ(found.skipped, 0U);
  ASSERT_EQ(found.turns.size(), wanted.turns.size());
  for (std::size_t i = 0; i < found.turns.size(); ++i) EXPECT_EQ(found.turns[i], wanted.turns[i]) << "turn " << i;
}

TEST_F(GatewareCoreTest, finds_frames_among_noise_as_the_model_does) {
  GatewareCore gateware;
  ModelCore model = model_core("axis_compressor", 6);
  for (const std::uint64_t seed : {1U, 2U}) {
    const Transcript found = run_noise(gateware, seed);
    const Transcript wanted = run_noise(model, seed);
    EXPECT_GE(found.frames, 150U);
    for (std::size_t i = 0; i < found.turns.size(); ++i) ASSERT_EQ(found.turns[i], wanted.turns[i]) << "turn " << i;
    gateware.reset();
    model.reset();
  }
}

TEST_F(GatewareCoreTest, batches_without_credit_are_refused_and_the_others_answered_in_order) {
  const auto set = vectors::generate_set("axis_compressor", {6, 1}, 100, 5);
  GatewareCore core;
  Talk talk(core);
  talk.send(FrameType::open, open_payload("axis_compressor", 6, 1));
  EXPECT_EQ(host::parse_credit(talk.receive_one(FrameType::board_open)), 1U + 2U);
  const Bytes payload = PackedBatch(*set).batch.to_payload();
  for (unsigned i = 1; i <= 3; ++i) talk.send(FrameType::vectors, payload);
  talk.send(FrameType::status);  // 4
  const auto frames = talk.receive();
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_EQ(frames[0].header.type, FrameType::results);
  EXPECT_EQ(frames[1].header.type, FrameType::results);
  const auto error = host::BoardError::parse(frames[2].payload);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->reason, host::ErrorReason::credit);
  EXPECT_EQ(error->sequence, 3U);
  EXPECT_EQ(host::BoardStatus::parse(frames[3].payload)->batches, 2U);
}

TEST_F(GatewareCoreTest, an_episode_that_lacks_responses_is_hung_and_reset_ends_one_that_runs) {
  const auto set = vectors::generate_set("axis_compressor", {6, 1}, 5, 5);
  GatewareCore core;
  Talk talk(core);
  talk.send(FrameType::open, open_payload("axis_compressor", 6, 1));
  talk.receive();
  PackedBatch packed(*set);
  packed.batch.episodes[0].wanted = 6;
  packed.batch.hang_cycles = 100;
  talk.send(FrameType::vectors, packed.batch.to_payload());
  const Bytes payload = talk.receive_one(FrameType::results);
  const auto results = host::BatchResults::parse(payload, set->response_codec().packed_bytes());
  ASSERT_TRUE(results);
  EXPECT_TRUE(results->episodes[0].hung);
  EXPECT_EQ(results->episodes[0].responses, 5U);
  EXPECT_GE(results->cycles, 100U + 5U);
  EXPECT_LT(results->cycles, 100U + 15U);
  packed.batch.hang_cycles = ~0U;
  talk.send(FrameType::vectors, packed.batch.to_payload());
  EXPECT_TRUE(talk.receive().empty());  // it runs and runs
  talk.send(FrameType::reset);
  talk.receive_one(FrameType::board_reset);
  talk.send(FrameType::status);
  EXPECT_EQ(host::BoardStatus::parse(talk.receive_one(FrameType::board_status))->batches, 0U);
}

TEST_F(GatewareCoreTest, surplus_responses_are_sent_as_far_as_they_fit_behind_those_wanted) {
  const auto set = vectors::generate_set("axis_compressor", {6, 1}, 5, 5);
  for (const int result_bits : {12, 8}) {
    GatewareCore core({.result_bits = result_bits});
    Talk talk(core);
    talk.send(FrameType::open, open_payload("axis_compressor", 6, 1));
    talk.receive();
    PackedBatch packed(*set);
    packed.batch.episodes[0].wanted = 2;
    packed.batch.episodes.push_back(packed.batch.episodes[0]);
    packed.batch.episodes[1].wanted = 5;
    talk.send(FrameType::vectors, packed.batch.to_payload());
    const Bytes payload = talk.receive_one(FrameType::results);
    const auto results = host::BatchResults::parse(payload, set->response_codec().packed_bytes());
    ASSERT_TRUE(results);
    // 256 bytes: two heads of 16 and 4 + 4, seven records of 19 wanted, and room for five more.
    EXPECT_EQ(results->episodes[0].responses, 5U);
    EXPECT_FALSE(results->episodes[0].more);
    EXPECT_EQ(results->episodes[1].responses, 5U);
    packed.batch.episodes[1].wanted = result_bits == 12 ? 5 : 10;  // now room for none
    packed.batch.hang_cycles = 10;
    talk.send(FrameType::vectors, packed.batch.to_payload());
    const Bytes second = talk.receive_one(FrameType::results);
    const auto full = host::BatchResults::parse(second, set->response_codec().packed_bytes());
    ASSERT_TRUE(full);
    EXPECT_EQ(full->episodes[0].responses, result_bits == 12 ? 5U : 2U);
    EXPECT_EQ(full->episodes[0].more, result_bits != 12);
    EXPECT_EQ(full->episodes[1].hung, result_bits != 12);
  }
}

TEST_F(GatewareCoreTest, power_on_forgets_even_half_a_frame) {
  GatewareCore core;
  Talk talk(core);
  Bytes bytes;
  host::append_frame(bytes, FrameType::status, 5);
  talk.send_raw(host::ByteSpan(bytes).first(10));
  EXPECT_TRUE(talk.receive().empty());
  core.reset();
  talk.send(FrameType::status);
  EXPECT_EQ(host::BoardStatus::parse(talk.receive_one(FrameType::board_status))->skipped, 0U);
}

TEST_F(GatewareCoreTest, other_units_cannot_be_had) {
  EXPECT_THROW(GatewareCore({.unit = "no_such_unit"}), golden::InputError);
  EXPECT_THROW(GatewareCore({.unit = "run_sorter"}), testbench::Unavailable);
}

}  // namespace
}  // namespace cbvh::testing
