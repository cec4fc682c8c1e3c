// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/model/model_core.h"

#include <gtest/gtest.h>

#include "talk.h"
#include "vectors/registry.h"

namespace cbvh::testing {
namespace {

using emulator::ModelCore;
using host::ErrorReason;
using host::FrameType;

constexpr vectors::Parameters kParameters{6, 1};

std::uint32_t credit_of(const host::Bytes& payload) { return host::parse_credit(payload).value_or(~0U); }

/// Compares a RESULTS payload with the responses of the set's cases; gives the number of responses compared.
std::size_t expect_golden(const vectors::VectorSet& set, const host::Bytes& payload) {
  const auto& codec = set.response_codec();
  const auto results = host::BatchResults::parse(payload, codec.packed_bytes());
  EXPECT_TRUE(results);
  if (!results) return 0;
  std::size_t compared = 0;
  host::Bytes want(codec.packed_bytes());
  for (const auto& episode : results->episodes) {
    EXPECT_FALSE(episode.hung || episode.more);
    for (std::size_t i = 0; i < episode.responses; ++i, ++compared) {
      if (compared >= set.response_count()) return 0;
      const auto record = episode.records.subspan(i * (4 + want.size()), 4 + want.size());
      codec.pack(set.response_at(compared), want.data());
      EXPECT_TRUE(std::equal(want.begin(), want.end(), record.begin() + 4)) << "response " << compared;
      const std::uint32_t latency = set.latency_at(compared);
      if (latency == vectors::kLatencyNotStated) continue;
      EXPECT_EQ(host::read_at<std::uint32_t>(record, 0), latency);
    }
  }
  return compared;
}

TEST(ModelCore, hello_offers_every_unit_of_the_rtl_backend_with_its_parameters) {
  ModelCore core({.buffers = 3, .greatest_payload_in = 5000, .greatest_payload_out = 7000});
  Talk talk(core);
  talk.send(FrameType::hello);
  const auto hello = host::BoardHello::parse(talk.receive_one(FrameType::board_hello));
  ASSERT_TRUE(hello);
  EXPECT_EQ(hello->credit, 4U);  // one frame taken, three buffers
  EXPECT_EQ(hello->buffers, 3U);
  EXPECT_EQ(hello->greatest_payload_in, 5000U);
  EXPECT_EQ(hello->greatest_payload_out, 7000U);
  ASSERT_EQ(hello->units.size(), vectors::units().size());
  const host::OfferedUnit& axis = hello->units[0];
  EXPECT_EQ(axis.name, "axis_compressor");
  EXPECT_EQ(axis.id, host::unit_id("axis_compressor"));
  unsigned mask = 0;
  for (const int n : vectors::kBuiltBits) mask |= 1U << n;
  EXPECT_EQ(axis.bits_mask, mask);
  EXPECT_EQ(axis.treelet_mask, 1U << 1U);
  EXPECT_FALSE(axis.stateful);
}

TEST(ModelCore, offers_one_unit_with_one_N_when_told_to) {
  ModelCore core({.unit = "scale_estimator", .bits = 4});
  Talk talk(core);
  talk.send(FrameType::hello);
  const auto hello = host::BoardHello::parse(talk.receive_one(FrameType::board_hello));
  ASSERT_TRUE(hello);
  ASSERT_EQ(hello->units.size(), 1U);
  EXPECT_EQ(hello->units[0],
            (host::OfferedUnit{host::unit_id("scale_estimator"), "scale_estimator", 1U << 4U, 2, false}));
  talk.send(FrameType::open, open_payload("axis_compressor", 4, 1));
  talk.expect_error(ErrorReason::unit, 1, host::unit_id("axis_compressor"));
  talk.send(FrameType::open, open_payload("scale_estimator", 6, 1));
  talk.expect_error(ErrorReason::parameters, 2, 6 + 256);
  EXPECT_THROW(ModelCore({.unit = "no_such_unit"}), golden::InputError);
  EXPECT_THROW(ModelCore({.unit = "scale_estimator", .bits = 9}), golden::InputError);
}

TEST(ModelCore, every_unit_gives_the_goldens_responses_and_latencies) {
  std::size_t units = 0;
  for (const vectors::UnitDescription& unit : vectors::units()) {
    const vectors::Parameters parameters{unit.bits.back(), unit.treelets.back()};
    const auto set = vectors::generate_set(unit.name, parameters, 12, 5);
    ModelCore core;
    Talk talk(core);
    const auto opened = host::OpenAnswer::parse(talk.open(unit.name, parameters.bits, parameters.treelet));
    ASSERT_TRUE(opened) << unit.name;
    EXPECT_EQ(opened->stimulus_width, set->stimulus_codec().width);
    EXPECT_EQ(opened->response_width, set->response_codec().width);
    talk.send(FrameType::vectors, PackedBatch(*set).batch.to_payload());
    EXPECT_EQ(expect_golden(*set, talk.receive_one(FrameType::results)), set->response_count()) << unit.name;
    ++units;
  }
  EXPECT_GE(units, 25U);
}

TEST(ModelCore, a_wrong_bit_in_a_stimulus_changes_the_results) {
  const auto set = vectors::generate_set("axis_compressor", kParameters, 64, 5);
  ModelCore core;
  Talk talk(core);
  talk.open("axis_compressor");
  PackedBatch packed(*set);
  packed.packed[0][3] ^= 0x40;
  talk.send(FrameType::vectors, packed.batch.to_payload());
  ModelCore other;
  Talk other_talk(other);
  other_talk.open("axis_compressor");
  other_talk.send(FrameType::vectors, PackedBatch(*set).batch.to_payload());
  EXPECT_NE(talk.receive_one(FrameType::results), other_talk.receive_one(FrameType::results));
}

TEST(ModelCore, bytes_may_come_and_go_one_at_a_time) {
  const auto set = vectors::generate_set("scale_estimator", kParameters, 20, 5);
  ModelCore core;
  Talk talk(core);
  host::Bytes bytes;
  host::append_frame(bytes, FrameType::open, 0, open_payload("scale_estimator", 6, 1));
  host::append_frame(bytes, FrameType::vectors, 1, PackedBatch(*set, 77).batch.to_payload());
  for (const std::uint8_t byte : bytes) talk.send_raw({&byte, 1});
  const auto frames = talk.receive(1);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].header.sequence, 0U);
  EXPECT_EQ(frames[1].header.sequence, 1U);
  EXPECT_EQ(host::read_at<std::uint32_t>(frames[1].payload, 4), 77U);
  EXPECT_EQ(expect_golden(*set, frames[1].payload), 20U);
}

TEST(ModelCore, a_megabyte_of_stimuli_in_one_batch) {
  const auto set = vectors::generate_set("scale_estimator", kParameters, 40'000, 5);
  ModelCore core({.greatest_payload_out = std::uint32_t{1} << 21U});
  Talk talk(core);
  talk.open("scale_estimator");
  const host::Bytes payload = PackedBatch(*set).batch.to_payload();
  talk.send(FrameType::vectors, payload);
  EXPECT_EQ(expect_golden(*set, talk.receive_one(FrameType::results)), 40'000U);
}

TEST(ModelCore, credit_falls_with_every_queued_batch_and_rises_with_every_result) {
  const auto set = vectors::generate_set("axis_compressor", kParameters, 4, 5);
  const host::Bytes payload = PackedBatch(*set).batch.to_payload();
  ModelCore core({.buffers = 2});
  Talk talk(core);
  EXPECT_EQ(credit_of(talk.open("axis_compressor")), 1U + 2U);
  talk.send(FrameType::vectors, payload);  // 1
  talk.send(FrameType::vectors, payload);  // 2
  talk.send(FrameType::vectors, payload);  // 3: too many
  talk.send(FrameType::status);            // 4
  const auto frames = talk.receive();
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_EQ(credit_of(frames[0].payload), 5U + 1U);  // one of two is still queued
  EXPECT_EQ(credit_of(frames[1].payload), 5U + 2U);
  const auto error = host::BoardError::parse(frames[2].payload);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->reason, ErrorReason::credit);
  EXPECT_EQ(error->sequence, 3U);
  EXPECT_EQ(error->detail, 4U);  // no buffer was free behind frame 3
  EXPECT_EQ(credit_of(frames[3].payload), 5U + 2U);
}

TEST(ModelCore, status_counts_what_was_broken_lost_and_doubled) {
  ModelCore core;
  Talk talk(core);
  talk.open("axis_compressor");  // 0
  talk.send_raw(host::Bytes{1, 2, 3});
  host::Bytes broken;
  host::append_frame(broken, FrameType::open, talk.sequence++, open_payload("axis_compressor", 6, 1));  // 1
  broken.back() ^= 1;
  talk.send_raw(broken);
  talk.sequence += 2;            // 2 and 3 are lost
  talk.send(FrameType::status);  // 4
  --talk.sequence;
  talk.send(FrameType::status);  // 4 again
  const auto frames = talk.receive();
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].header.type, FrameType::credit);
  EXPECT_EQ(credit_of(frames[0].payload), 5U + 4U);
  const auto set = vectors::generate_set("axis_compressor", kParameters, 4, 5);
  talk.send(FrameType::vectors, PackedBatch(*set).batch.to_payload());
  talk.send(FrameType::status);
  const auto more = talk.receive();
  ASSERT_EQ(more.size(), 2U);
  const auto status = host::BoardStatus::parse(more[1].payload);
  ASSERT_TRUE(status);
  EXPECT_EQ(status->taken, 4U);
  EXPECT_EQ(status->skipped, 3U);
  EXPECT_EQ(status->corrupted, 1U);
  EXPECT_EQ(status->lost, 3U);
  EXPECT_EQ(status->stale, 1U);
  EXPECT_EQ(status->batches, 1U);
  EXPECT_EQ(status->cycles, host::BatchResults::parse(more[0].payload, set->response_codec().packed_bytes())->cycles);
}

TEST(ModelCore, reset_forgets_unit_batches_and_counters_and_counts_from_its_own_sequence) {
  const auto set = vectors::generate_set("axis_compressor", kParameters, 4, 5);
  const host::Bytes payload = PackedBatch(*set).batch.to_payload();
  ModelCore core;
  Talk talk(core);
  talk.open("axis_compressor");
  talk.send(FrameType::vectors, payload);
  talk.send_raw(host::Bytes{9});
  talk.sequence = 0;  // behind
  talk.send(FrameType::reset);
  talk.send(FrameType::vectors, payload);
  talk.send(FrameType::status);
  const auto frames = talk.receive();
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].header.type, FrameType::board_reset);
  EXPECT_EQ(frames[0].header.sequence, 0U);
  EXPECT_EQ(credit_of(frames[0].payload), 3U + 4U);
  EXPECT_EQ(host::BoardError::parse(frames[1].payload)->reason, ErrorReason::not_open);
  const auto status = host::BoardStatus::parse(frames[2].payload);
  ASSERT_TRUE(status);
  EXPECT_EQ(*status, (host::BoardStatus{7, 2, 0, 0, 0, 0, 0, 0}));
}

TEST(ModelCore, power_on_forgets_even_half_a_frame) {
  ModelCore core;
  Talk talk(core);
  host::Bytes bytes;
  host::append_frame(bytes, FrameType::status, 5);
  talk.send_raw(host::ByteSpan(bytes).first(10));
  core.reset();
  talk.send(FrameType::status);
  EXPECT_EQ(host::BoardStatus::parse(talk.receive_one(FrameType::board_status))->skipped, 0U);
}

TEST(ModelCore, as_many_responses_as_fit_exactly_and_not_one_more) {
  constexpr std::uint32_t kFit = 40;
  const auto record = static_cast<std::uint32_t>(4 + vectors::find_unit("axis_compressor").response(6).packed_bytes());
  const std::uint32_t greatest = 16 + 4 + kFit * record;
  ModelCore core({.greatest_payload_out = greatest});
  Talk talk(core);
  talk.open("axis_compressor");
  const auto set = vectors::generate_set("axis_compressor", kParameters, kFit, 5);
  talk.send(FrameType::vectors, PackedBatch(*set).batch.to_payload());
  EXPECT_EQ(expect_golden(*set, talk.receive_one(FrameType::results)), kFit);
  const auto more = vectors::generate_set("axis_compressor", kParameters, kFit + 1, 5);
  talk.send(FrameType::vectors, PackedBatch(*more).batch.to_payload());
  talk.expect_error(ErrorReason::responses, 2, greatest);
}

TEST(ModelCore, bits_above_a_stimulus_mean_nothing) {
  const auto set = vectors::generate_set("axis_compressor", kParameters, 20, 5);
  const std::size_t bytes = set->stimulus_codec().packed_bytes();
  const std::size_t width = set->stimulus_codec().width;
  ASSERT_NE(width % 8, 0U);
  PackedBatch packed(*set);
  for (std::size_t i = bytes - 1; i < packed.packed[0].size(); i += bytes) {
    packed.packed[0][i] = static_cast<std::uint8_t>(packed.packed[0][i] | (0xFFU << width % 8));
  }
  ModelCore core;
  Talk talk(core);
  talk.open("axis_compressor");
  talk.send(FrameType::vectors, packed.batch.to_payload());
  EXPECT_EQ(expect_golden(*set, talk.receive_one(FrameType::results)), 20U);
}

}  // namespace
}  // namespace cbvh::testing
