// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fpga/host/frame_reader.h"
#include "vectors/random.h"

namespace {

using namespace cbvh::host;
using cbvh::vectors::Random;

Bytes random_bytes(Random& random, std::size_t count) {
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  return bytes;
}

struct Got {
  Header header;
  Bytes payload;
  bool operator==(const Got&) const = default;
};

std::vector<Got> take_all(FrameReader& reader) {
  std::vector<Got> all;
  while (const auto frame = reader.next()) {
    EXPECT_EQ(frame->kind, FrameReader::Kind::whole);
    all.push_back({frame->header, {frame->payload.begin(), frame->payload.end()}});
  }
  return all;
}

/// Three frames of 0, 1 and 5 bytes, of sequences 7, 8, 9.
Bytes three_frames() {
  Bytes bytes;
  append_frame(bytes, FrameType::status, 7);
  append_frame(bytes, FrameType::results, 8, Bytes{0xAA});
  append_frame(bytes, FrameType::vectors, 9, Bytes{1, 2, 3, 4, 5});
  return bytes;
}
constexpr std::size_t kSizes[] = {16, 21, 25};

TEST(Frame, has_the_bytes_that_the_protocol_states) {
  Bytes bytes;
  append_frame(bytes, FrameType::vectors, 0x04030201, Bytes{'1', '2', '3', '4', '5', '6', '7', '8', '9'});
  ASSERT_EQ(bytes.size(), 16u + 9u + 4u);
  const Bytes start = {0xC5, 0xB7, 1, 3, 1, 2, 3, 4, 9, 0, 0, 0};
  EXPECT_TRUE(std::equal(start.begin(), start.end(), bytes.begin()));
  const Bytes checksum = {0x83, 0x92, 0x06, 0xE3};  // the check value of CRC-32C, E3069283
  EXPECT_TRUE(std::equal(checksum.begin(), checksum.end(), bytes.end() - 4));
  EXPECT_EQ(read_at<std::uint32_t>(bytes, 12), crc32c(start));
}

TEST(FrameReader, finds_every_frame_however_the_bytes_are_cut) {
  Bytes bytes = three_frames();
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    FrameReader reader(5);
    std::vector<Got> got;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      reader.feed(ByteSpan(bytes).subspan(at, std::min(piece, bytes.size() - at)));
      for (Got& frame : take_all(reader)) got.push_back(std::move(frame));
    }
    ASSERT_EQ(got.size(), 3u) << "pieces of " << piece;
    EXPECT_EQ(got[0], (Got{{1, FrameType::status, 7, 0}, {}}));
    EXPECT_EQ(got[1], (Got{{1, FrameType::results, 8, 1}, {0xAA}}));
    EXPECT_EQ(got[2], (Got{{1, FrameType::vectors, 9, 5}, {1, 2, 3, 4, 5}}));
    EXPECT_EQ(reader.counters(), FrameReader::Counters());
  }
}

TEST(FrameReader, gives_no_frame_before_its_last_byte) {
  const Bytes bytes = three_frames();
  std::size_t checks = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    FrameReader reader(5);
    reader.feed(ByteSpan(bytes).first(length));
    const std::size_t whole = (length >= 16 ? 1u : 0u) + (length >= 37 ? 1u : 0u);
    EXPECT_EQ(take_all(reader).size(), whole) << length;
    ++checks;
  }
  EXPECT_EQ(checks, 62u);
}

TEST(FrameReader, loses_exactly_the_frame_in_which_a_bit_is_wrong) {
  const Bytes good = three_frames();
  std::size_t checks = 0;
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit, ++checks) {
      Bytes bytes = good;
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 << bit));
      const std::size_t broken = at < 16 ? 0 : at < 37 ? 1 : 2;
      const std::size_t begin = broken == 0 ? 0 : broken == 1 ? 16 : 37;
      append_frame(bytes, FrameType::credit, 10);
      FrameReader reader(5);
      reader.feed(bytes);
      const std::vector<Got> got = take_all(reader);
      ASSERT_EQ(got.size(), 3u) << "byte " << at << " bit " << bit;
      std::vector<std::uint32_t> sequences;
      for (const Got& frame : got) sequences.push_back(frame.header.sequence);
      std::vector<std::uint32_t> expected = {7, 8, 9, 10};
      expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(broken));
      EXPECT_EQ(sequences, expected);
      const bool in_payload = at - begin >= kHeaderBytes;
      EXPECT_EQ(reader.counters().corrupted, in_payload ? 1u : 0u);
      EXPECT_EQ(reader.counters().skipped, in_payload ? 0u : kSizes[broken]);
    }
  }
  EXPECT_EQ(checks, 62u * 8);
}

TEST(FrameReader, counts_what_lies_between_frames_and_is_not_fooled_by_magics) {
  Bytes bytes = {0xC5, 0xC5, 0xB7, 1, 2, 0xC5};
  for (int i = 0; i < 40; ++i) bytes.push_back(i % 2 == 0 ? 0xC5 : 0xB7);
  const std::size_t noise = bytes.size();
  append_frame(bytes, FrameType::hello, 1);
  FrameReader reader(16);
  reader.feed(bytes);
  EXPECT_EQ(take_all(reader).size(), 1u);
  EXPECT_EQ(reader.counters().skipped, noise);
}

TEST(FrameReader, tells_a_header_of_another_version_and_goes_on_behind_it) {
  Bytes bytes;
  append_header(bytes, {2, FrameType::vectors, 5, 1000000});
  append_frame(bytes, FrameType::hello, 6);
  FrameReader reader(16);
  reader.feed(bytes);
  const auto other = reader.next();
  ASSERT_TRUE(other);
  EXPECT_EQ(other->kind, FrameReader::Kind::other_version);
  EXPECT_EQ(other->header, (Header{2, FrameType::vectors, 5, 1000000}));
  EXPECT_EQ(take_all(reader).size(), 1u);
}

TEST(FrameReader, does_not_wait_for_a_payload_that_is_too_long) {
  Bytes bytes;
  append_header(bytes, {1, FrameType::vectors, 5, 17});
  append_frame(bytes, FrameType::vectors, 6, Bytes(16));
  FrameReader reader(16);
  reader.feed(bytes);
  const auto other = reader.next();
  ASSERT_TRUE(other);
  EXPECT_EQ(other->kind, FrameReader::Kind::too_long);
  EXPECT_EQ(take_all(reader).size(), 1u);
}

TEST(FrameReader, finds_what_an_unfinished_frame_has_swallowed_once_it_is_given_up) {
  Bytes cut;
  append_frame(cut, FrameType::vectors, 1, Bytes(100));
  cut.resize(50);
  append_frame(cut, FrameType::status, 2);
  FrameReader reader(100);
  reader.feed(cut);
  EXPECT_TRUE(take_all(reader).empty());
  EXPECT_TRUE(reader.give_up_unfinished());
  const std::vector<Got> got = take_all(reader);
  ASSERT_EQ(got.size(), 1u);
  EXPECT_EQ(got[0].header.sequence, 2u);
  EXPECT_EQ(reader.counters().skipped, 50u);
  EXPECT_FALSE(reader.give_up_unfinished());
}

TEST(FrameReader, zeros_of_the_greatest_frame_end_whatever_was_unfinished) {
  const Bytes whole = three_frames();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    FrameReader reader(5);
    reader.feed(ByteSpan(whole).first(length));
    take_all(reader);
    Bytes more(frame_bytes(5));
    append_frame(more, FrameType::reset, 0);
    reader.feed(more);
    const std::vector<Got> got = take_all(reader);
    ASSERT_EQ(got.size(), 1u) << length;
    EXPECT_EQ(got[0].header.type, FrameType::reset);
  }
}

/// Random frames, with noise between and bits turned: what comes out was sent, in order, and every frame that no
/// change and no noise has touched comes out.
TEST(FrameReader, never_gives_a_frame_that_was_not_sent) {
  std::size_t frames = 0;
  std::size_t changed = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    std::vector<Got> sent;
    std::vector<bool> touched;
    Bytes bytes;
    for (std::uint32_t i = 0; i < 30; ++i) {
      const Bytes payload = random_bytes(random, random.below(64));
      sent.push_back({{1, FrameType::results, i, static_cast<std::uint32_t>(payload.size())}, payload});
      const std::size_t begin = bytes.size();
      append_frame(bytes, FrameType::results, i, payload);
      touched.push_back(random.below(4) == 0);
      if (touched.back()) {
        const std::size_t at = begin + random.below(bytes.size() - begin);
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 << random.below(8)));
        ++changed;
      }
    }
    FrameReader reader(64);
    std::vector<Got> got;
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t piece = std::min<std::size_t>(1 + random.below(200), bytes.size() - at);
      reader.feed(ByteSpan(bytes).subspan(at, piece));
      for (Got& frame : take_all(reader)) got.push_back(std::move(frame));
      at += piece;
    }
    std::vector<Got> expected;
    for (std::size_t i = 0; i < sent.size(); ++i) {
      if (!touched[i]) expected.push_back(sent[i]);
    }
    EXPECT_EQ(got, expected) << "seed " << seed;
    frames += got.size();
  }
  EXPECT_GT(changed, 1000u);
  EXPECT_EQ(frames + changed, 9000u);
}

TEST(FrameReader, takes_any_bytes_without_a_frame) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    FrameReader reader(1000);
    std::uint64_t fed = 0;
    for (int i = 0; i < 50; ++i) {
      Bytes bytes = random_bytes(random, random.below(100));
      if (random.below(2) == 0) bytes.insert(bytes.end(), {0xC5, 0xB7, 1});
      fed += bytes.size();
      reader.feed(bytes);
      EXPECT_TRUE(take_all(reader).empty());
    }
    EXPECT_GT(reader.counters().skipped + kHeaderBytes, fed);
  }
}

TEST(SequenceTracker, counts_gaps_as_lost_and_drops_what_is_behind_across_the_wrap) {
  SequenceTracker tracker;
  tracker.restart(0xFFFFFFFD);
  EXPECT_TRUE(tracker.take(0xFFFFFFFE));
  EXPECT_FALSE(tracker.take(0xFFFFFFFE));
  EXPECT_TRUE(tracker.take(1));
  EXPECT_EQ(tracker.lost(), 2u);
  EXPECT_FALSE(tracker.take(0));
  EXPECT_FALSE(tracker.take(0x80000002));
  EXPECT_TRUE(tracker.take(2));
  EXPECT_EQ(tracker.lost(), 2u);
  EXPECT_EQ(tracker.stale(), 3u);
  EXPECT_EQ(tracker.next(), 3u);
}

}  // namespace
