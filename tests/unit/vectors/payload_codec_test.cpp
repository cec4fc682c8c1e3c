// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/payload_codec.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "vectors/random.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

/// The field at `bit`, one bit after the other, as the formats say: bit 0 is the lowest of byte 0.
std::uint64_t field_at(const std::vector<std::uint8_t>& bytes, std::size_t bit, int width) {
  std::uint64_t raw = 0;
  for (int i = 0; i < width; ++i, ++bit) raw |= std::uint64_t{(bytes[bit / 8] >> (bit % 8)) & 1U} << i;
  return raw;
}

/// Calls f(codec) for the payloads of every unit and N.
template <class F>
void for_each_codec(F&& f) {
  for (const UnitDescription& unit : units()) {
    SCOPED_TRACE(unit.name);
    for (const int bits : unit.bits) {
      f(unit.stimulus(bits));
      f(unit.response(bits));
    }
  }
}

std::vector<std::uint8_t> random_packed(const PayloadCodec& codec, Random& random) {
  std::vector<std::uint8_t> bytes(codec.packed_bytes());
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  if (codec.width % 8 != 0) bytes.back() = static_cast<std::uint8_t>(bytes.back() & ((1U << codec.width % 8) - 1));
  return bytes;
}

TEST(PayloadCodec, packed_bits_are_the_fields_from_the_lowest_bit_up) {
  Random random(1);
  std::size_t fields = 0;
  for_each_codec([&](const PayloadCodec& codec) {
    for (int repeat = 0; repeat < 8; ++repeat) {
      const std::vector<std::uint8_t> bytes = random_packed(codec, random);
      std::vector<char> object(codec.object_size);
      ASSERT_TRUE(codec.unpack(bytes.data(), object.data()));
      std::size_t bit = 0;
      for (const CodecLeaf& leaf : codec.leaves) {
        std::uint64_t raw = 0;
        std::memcpy(&raw, object.data() + leaf.offset, leaf.size);
        ASSERT_EQ(raw, field_at(bytes, bit, leaf.width)) << leaf.name;
        bit += static_cast<std::size_t>(leaf.width);
        ++fields;
      }
      std::vector<std::uint8_t> packed(bytes.size(), 0xFF);
      codec.pack(object.data(), packed.data());
      ASSERT_EQ(packed, bytes);
    }
  });
  EXPECT_GT(fields, 10000U);
}

TEST(PayloadCodec, a_set_padding_bit_is_refused) {
  Random random(2);
  std::size_t refused = 0;
  for_each_codec([&](const PayloadCodec& codec) {
    std::vector<char> object(codec.object_size);
    for (std::size_t bit = codec.width; bit < 8 * codec.packed_bytes(); ++bit) {
      std::vector<std::uint8_t> bytes = random_packed(codec, random);
      bytes.back() = static_cast<std::uint8_t>(bytes.back() | (1U << bit % 8));
      EXPECT_FALSE(codec.unpack(bytes.data(), object.data()));
      ++refused;
    }
  });
  EXPECT_GT(refused, 0U);
}

}  // namespace
}  // namespace cbvh::vectors
