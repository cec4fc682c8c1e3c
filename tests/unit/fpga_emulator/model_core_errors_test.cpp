// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What the model core answers to frames that are wrong, and to batches that end otherwise than was wanted.
#include <gtest/gtest.h>

#include "fpga/emulator/model/model_core.h"
#include "talk.h"
#include "vectors/registry.h"

namespace cbvh::testing {
namespace {

using emulator::ModelCore;
using host::ErrorReason;
using host::FrameType;

constexpr vectors::Parameters kParameters{6, 1};

class ModelCoreErrors : public ::testing::Test {
 protected:
  void open_axis() { ASSERT_FALSE(talk.open("axis_compressor").empty()); }
  host::Bytes axis_batch(std::uint64_t cases) {
    set = vectors::generate_set("axis_compressor", kParameters, cases, 5);
    return PackedBatch(*set).batch.to_payload();
  }

  ModelCore core{{.buffers = 4, .greatest_payload_in = 2000, .greatest_payload_out = 1000}};
  Talk talk{core};
  std::unique_ptr<vectors::VectorSet> set;
};

TEST_F(ModelCoreErrors, version) {
  host::Bytes bytes;
  host::append_header(bytes, {2, FrameType::hello, 17, 0});
  talk.send_raw(bytes);
  talk.expect_error(ErrorReason::version, 17, 1);
}

TEST_F(ModelCoreErrors, type) {
  talk.send(static_cast<FrameType>(0x42));
  talk.expect_error(ErrorReason::type, 0, 0x42);
  talk.send(FrameType::results);  // a board's
  talk.expect_error(ErrorReason::type, 1, 0x83);
}

TEST_F(ModelCoreErrors, length_above_the_greatest_payload_of_which_the_bytes_are_skipped) {
  open_axis();
  talk.send(FrameType::vectors, host::Bytes(2001));
  talk.expect_error(ErrorReason::length, 1, 2000);
  talk.send(FrameType::status);
  EXPECT_EQ(host::BoardStatus::parse(talk.receive_one(FrameType::board_status))->skipped, 2001U + 4U);
}

TEST_F(ModelCoreErrors, length_that_is_not_what_the_frame_needs) {
  open_axis();
  for (const FrameType type : {FrameType::hello, FrameType::status, FrameType::reset}) {
    talk.send(type, host::Bytes(1));
    talk.expect_error(ErrorReason::length, talk.sequence - 1, 0);
  }
  host::Bytes payload = axis_batch(3);
  const auto size = static_cast<std::uint32_t>(payload.size());
  payload.push_back(0);
  talk.send(FrameType::vectors, payload);
  talk.expect_error(ErrorReason::length, talk.sequence - 1, size);
  payload.resize(size - 1);
  talk.send(FrameType::vectors, payload);
  talk.expect_error(ErrorReason::length, talk.sequence - 1, size);
  payload.resize(15);  // within the episode's head
  talk.send(FrameType::vectors, payload);
  talk.expect_error(ErrorReason::length, talk.sequence - 1, 20);
  talk.send(FrameType::vectors, host::Bytes(11));
  talk.expect_error(ErrorReason::length, talk.sequence - 1, 12);
  talk.send(FrameType::open, host::Bytes(7));
  talk.expect_error(ErrorReason::length, talk.sequence - 1, 8);
}

TEST_F(ModelCoreErrors, unit) {
  talk.send(FrameType::open, open_payload("no_such_unit", 6, 1));
  talk.expect_error(ErrorReason::unit, 0, host::unit_id("no_such_unit"));
}

TEST_F(ModelCoreErrors, parameters) {
  talk.send(FrameType::open, open_payload("axis_compressor", 9, 1));
  talk.expect_error(ErrorReason::parameters, 0, 9 + 256);
  talk.send(FrameType::open, open_payload("axis_compressor", 6, 2));
  talk.expect_error(ErrorReason::parameters, 1, 6 + 512);
}

TEST_F(ModelCoreErrors, no_unit_is_open_not_even_the_last_after_an_open_that_failed) {
  const host::Bytes payload = axis_batch(3);
  talk.send(FrameType::vectors, payload);
  talk.expect_error(ErrorReason::not_open, 0, 0);
  open_axis();
  talk.send(FrameType::open, open_payload("no_such_unit", 6, 1));
  talk.expect_error(ErrorReason::unit, 2, host::unit_id("no_such_unit"));
  talk.send(FrameType::vectors, payload);
  talk.expect_error(ErrorReason::not_open, 3, 0);
}

TEST_F(ModelCoreErrors, surplus_responses_are_sent_as_far_as_they_fit) {
  ASSERT_FALSE(talk.open("context_stack").empty());
  set = vectors::generate_set("context_stack", kParameters, 1, 5);
  PackedBatch packed(*set);
  packed.batch.episodes[0].wanted = 1;
  talk.send(FrameType::vectors, packed.batch.to_payload());
  const std::size_t bytes = set->response_codec().packed_bytes();
  const host::Bytes payload = talk.receive_one(FrameType::results);
  const auto results = host::BatchResults::parse(payload, bytes);
  ASSERT_TRUE(results);
  const std::size_t fit = (1000 - 16 - 4) / (4 + bytes);
  EXPECT_EQ(results->episodes[0].responses, std::min(fit, set->response_count()));
  EXPECT_EQ(results->episodes[0].more, set->response_count() > fit);
}

TEST_F(ModelCoreErrors, an_episode_that_lacks_responses_is_hung) {
  ASSERT_FALSE(talk.open("context_stack").empty());
  set = vectors::generate_set("context_stack", kParameters, 1, 5);
  PackedBatch packed(*set);
  packed.batch.episodes[0].stimuli = 1;
  packed.packed[0].resize(set->stimulus_codec().packed_bytes());
  packed.batch.episodes[0].packed = packed.packed[0];
  packed.batch.episodes[0].wanted = 3;
  packed.batch.hang_cycles = 100;
  talk.send(FrameType::vectors, packed.batch.to_payload());
  const host::Bytes payload = talk.receive_one(FrameType::results);
  const auto results = host::BatchResults::parse(payload, set->response_codec().packed_bytes());
  ASSERT_TRUE(results);
  EXPECT_TRUE(results->episodes[0].hung);
  EXPECT_LT(results->episodes[0].responses, 3U);
}

TEST_F(ModelCoreErrors, an_episode_drains_for_as_many_cycles_as_the_batch_says) {
  open_axis();
  set = vectors::generate_set("axis_compressor", kParameters, 20, 5);
  PackedBatch packed(*set);
  std::vector<std::uint32_t> cycles;
  for (const std::uint16_t drain : std::initializer_list<std::uint16_t>{0, 1, 1000}) {
    packed.batch.drain_cycles = drain;
    talk.send(FrameType::vectors, packed.batch.to_payload());
    const host::Bytes payload = talk.receive_one(FrameType::results);
    const auto results = host::BatchResults::parse(payload, set->response_codec().packed_bytes());
    ASSERT_TRUE(results);
    cycles.push_back(results->cycles);
  }
  EXPECT_EQ(cycles[1], cycles[0] + 1);
  EXPECT_EQ(cycles[2], cycles[0] + 1000);
}

TEST_F(ModelCoreErrors, batches_without_stimuli_or_episodes_give_empty_results) {
  open_axis();
  host::Batch batch;
  batch.number = 5;
  talk.send(FrameType::vectors, batch.to_payload());
  batch.episodes.push_back({});
  batch.hang_cycles = 100;
  talk.send(FrameType::vectors, batch.to_payload());
  const auto frames = talk.receive();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].payload.size(), 16U);
  EXPECT_EQ(frames[1].payload.size(), 20U);
}

}  // namespace
}  // namespace cbvh::testing
