// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/messages.h"

#include <gtest/gtest.h>

#include "fpga/host/frame.h"
#include "vectors/random.h"

namespace {

using namespace cbvh::host;

/// Every shorter and every longer payload is refused.
template <class Parse>
void expect_exact_length(const Bytes& payload, Parse&& parse) {
  EXPECT_TRUE(parse(ByteSpan(payload)));
  for (std::size_t length = 0; length < payload.size(); ++length) {
    EXPECT_FALSE(parse(ByteSpan(payload).first(length))) << length;
  }
  Bytes longer = payload;
  longer.push_back(0);
  EXPECT_FALSE(parse(ByteSpan(longer)));
}

BoardHello example_hello() {
  BoardHello hello;
  hello.credit = 8;
  hello.firmware_version = 0x0102;
  hello.buffers = 8;
  hello.clock_khz = 48000;
  hello.greatest_payload_in = 65536;
  hello.greatest_payload_out = 32768;
  hello.name = "cbvh board";
  hello.units = {{unit_id("axis_compressor"), "axis_compressor", 0x1FC, 0x2, false},
                 {unit_id("a_unit_with_a_name_as_long_as_32"), "a_unit_with_a_name_as_long_as_32", 0x40, 0x1E, true}};
  return hello;
}

TEST(Messages, hello_has_the_bytes_that_the_protocol_states) {
  const Bytes payload = example_hello().to_payload();
  ASSERT_EQ(payload.size(), 56u + 2 * 44u);
  const Bytes start = {8, 0, 0, 0, 2, 1, 8, 0, 0x80, 0xBB, 0, 0, 0, 0, 1, 0, 0, 0x80, 0, 0, 'c', 'b', 'v', 'h'};
  EXPECT_TRUE(std::equal(start.begin(), start.end(), payload.begin()));
  EXPECT_EQ(read_at<std::uint16_t>(payload, 52), 2u);
  EXPECT_EQ(read_at<std::uint32_t>(payload, 56), unit_id("axis_compressor"));
  EXPECT_EQ(payload[60], 'a');
  EXPECT_EQ(read_at<std::uint16_t>(payload, 92), 0x1FCu);
  EXPECT_EQ(read_at<std::uint16_t>(payload, 94), 2u);
  EXPECT_EQ(payload[96], 0);
  EXPECT_EQ(payload[140], 1);
}

TEST(Messages, hello_reads_back_and_no_other_length_is_taken) {
  const Bytes payload = example_hello().to_payload();
  EXPECT_EQ(BoardHello::parse(payload), example_hello());
  expect_exact_length(payload, [](ByteSpan bytes) { return BoardHello::parse(bytes).has_value(); });
}

TEST(Messages, batch_has_the_bytes_that_the_protocol_states_and_reads_back) {
  const Bytes one = {1, 2, 3};
  const Bytes two = {4, 5, 6, 7, 8, 9};
  Batch batch{0x11223344, 20000, 64, {{1, 1, one}, {2, 7, two}, {0, 0, {}}}};
  const Bytes payload = batch.to_payload();
  const Bytes expected = {0x44, 0x33, 0x22, 0x11, 0x20, 0x4E, 0, 0, 64, 0, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 3,
                          2,    0,    0,    0,    7,    0,    0, 0, 4,  5, 6, 7, 8, 9, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(payload, expected);
  const auto read = Batch::parse(payload, 3);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->number, batch.number);
  EXPECT_EQ(read->hang_cycles, 20000u);
  EXPECT_EQ(read->drain_cycles, 64u);
  ASSERT_EQ(read->episodes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read->episodes[i].stimuli, batch.episodes[i].stimuli);
    EXPECT_EQ(read->episodes[i].wanted, batch.episodes[i].wanted);
    EXPECT_TRUE(std::equal(read->episodes[i].packed.begin(), read->episodes[i].packed.end(),
                           batch.episodes[i].packed.begin(), batch.episodes[i].packed.end()));
  }
  expect_exact_length(payload, [](ByteSpan bytes) { return Batch::parse(bytes, 3).has_value(); });
}

TEST(Messages, results_have_the_bytes_that_the_protocol_states_and_read_back) {
  const Bytes records = {3, 0, 0, 0, 0xAB, 4, 0, 0, 0, 0xCD};
  BatchResults results{9, 2, 70, {{2, false, false, records}, {0, true, false, {}}, {2, false, true, records}}};
  const Bytes payload = results.to_payload();
  const Bytes expected = {9,    0, 0, 0, 2, 0,    0, 0, 70, 0,    0, 0, 3, 0,    0, 0, 2, 0, 0,    0, 3, 0, 0, 0,
                          0xAB, 4, 0, 0, 0, 0xCD, 0, 0, 0,  0x80, 2, 0, 0, 0x40, 3, 0, 0, 0, 0xAB, 4, 0, 0, 0, 0xCD};
  EXPECT_EQ(payload, expected);
  const auto read = BatchResults::parse(payload, 1);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->credit, 9u);
  EXPECT_EQ(read->number, 2u);
  EXPECT_EQ(read->cycles, 70u);
  ASSERT_EQ(read->episodes.size(), 3u);
  EXPECT_EQ(read->episodes[0].responses, 2u);
  EXPECT_EQ(Bytes(read->episodes[0].records.begin(), read->episodes[0].records.end()), records);
  EXPECT_TRUE(read->episodes[1].hung && !read->episodes[1].more);
  EXPECT_TRUE(!read->episodes[2].hung && read->episodes[2].more);
  expect_exact_length(payload, [](ByteSpan bytes) { return BatchResults::parse(bytes, 1).has_value(); });
}

TEST(Messages, counts_that_no_frame_can_hold_are_refused_without_reading_on) {
  const Batch batch{0, 0, 0, {{0xFFFFFFFF, 0, {}}}};
  EXPECT_FALSE(Batch::parse(batch.to_payload(), 16));
  const BatchResults results{0, 0, 0, {{0x3FFFFFFF, false, false, {}}}};
  EXPECT_FALSE(BatchResults::parse(results.to_payload(), 16));
}

TEST(Messages, small_payloads_read_back_and_no_other_length_is_taken) {
  const OpenRequest open{0xDEADBEEF, 6, 4};
  EXPECT_EQ(open.to_payload(), (Bytes{0xEF, 0xBE, 0xAD, 0xDE, 6, 4, 0, 0}));
  EXPECT_EQ(OpenRequest::parse(open.to_payload()), open);
  expect_exact_length(open.to_payload(), [](ByteSpan bytes) { return OpenRequest::parse(bytes).has_value(); });

  const OpenAnswer answer{5, 0xDEADBEEF, 6, 4, 73, 68};
  EXPECT_EQ(answer.to_payload().size(), 20u);
  EXPECT_EQ(OpenAnswer::parse(answer.to_payload()), answer);
  expect_exact_length(answer.to_payload(), [](ByteSpan bytes) { return OpenAnswer::parse(bytes).has_value(); });

  const BoardStatus status{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(status.to_payload().size(), 32u);
  EXPECT_EQ(BoardStatus::parse(status.to_payload()), status);
  expect_exact_length(status.to_payload(), [](ByteSpan bytes) { return BoardStatus::parse(bytes).has_value(); });

  const BoardError error{1, ErrorReason::responses, 3, 4};
  EXPECT_EQ(error.to_payload(), (Bytes{1, 0, 0, 0, 8, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0}));
  EXPECT_EQ(BoardError::parse(error.to_payload()), error);
  expect_exact_length(error.to_payload(), [](ByteSpan bytes) { return BoardError::parse(bytes).has_value(); });

  const BoardCredit credit{0x01020304};
  EXPECT_EQ(credit.to_payload(), (Bytes{4, 3, 2, 1}));
  EXPECT_EQ(parse_credit(credit.to_payload()), 0x01020304u);
  EXPECT_FALSE(parse_credit(Bytes{1, 2, 3}));
  expect_exact_length(credit.to_payload(), [](ByteSpan bytes) { return BoardCredit::parse(bytes).has_value(); });
}

TEST(Messages, each_error_says_what_the_board_refused) {
  EXPECT_EQ(describe({0, ErrorReason::version, 0, 7}), "it speaks version 7 of the protocol, this cbvh version 1");
  EXPECT_EQ(describe({0, ErrorReason::unit, 0, 0xAB}), "it has no unit of id 000000AB");
  EXPECT_EQ(describe({0, ErrorReason::parameters, 0, 6 + 256 * 4}), "the unit is not there with N = 6, D = 4");
  EXPECT_EQ(describe({0, static_cast<ErrorReason>(77), 0, 5}), "reason 77 (detail 5)");
}

TEST(Messages, random_payloads_are_read_without_harm) {
  std::size_t taken = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    cbvh::vectors::Random random(seed);
    Bytes payload(random.below(120));
    for (std::uint8_t& byte : payload) byte = random.below(3) == 0 ? static_cast<std::uint8_t>(random.next()) : 0;
    taken += Batch::parse(payload, 1 + random.below(9)).has_value() ? 1u : 0u;
    taken += BatchResults::parse(payload, 1 + random.below(9)).has_value() ? 1u : 0u;
    taken += BoardHello::parse(payload).has_value() ? 1u : 0u;
  }
  EXPECT_GT(taken, 0u);
}

}  // namespace
