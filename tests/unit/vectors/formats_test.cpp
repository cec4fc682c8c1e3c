// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Every unit's sets in every format.
#include <gtest/gtest.h>

#include <algorithm>

#include "vectors/format/crc32c.h"
#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

constexpr Format kFormats[] = {Format::text, Format::hex, Format::binary};

/// A small set of each unit for the smallest, the default and the largest parameters.
std::vector<std::unique_ptr<VectorSet>> small_sets() {
  std::vector<std::unique_ptr<VectorSet>> sets;
  for (const UnitDescription& unit : units()) {
    for (const int bits : {2, 6, 8}) {
      if (std::find(unit.bits.begin(), unit.bits.end(), bits) == unit.bits.end()) continue;
      for (const int treelet : {1, 3}) {
        if (unit.treelets.size() == 1 && treelet != 1) continue;
        const std::uint64_t cases = (unit.stateful ? 1 : 20) * unit.generated_classes();
        sets.push_back(generate_set(unit.name, {bits, treelet}, cases, 5));
      }
    }
  }
  return sets;
}

TEST(Crc32c, known_answers_of_both_methods) {
  for (const Crc32cMethod method : {Crc32cMethod::fastest, Crc32cMethod::tables}) {
    const auto crc_of = [method](std::string_view bytes) {
      Crc32c crc;
      crc.update(bytes, method);
      return crc.value();
    };
    EXPECT_EQ(crc_of("123456789"), 0xE3069283U);
    EXPECT_EQ(crc_of(""), 0U);
    EXPECT_EQ(crc_of(std::string(32, '\0')), 0x8A9136AAU);  // RFC 3720, B.4
    EXPECT_EQ(crc_of(std::string(32, '\xFF')), 0x62A8AB43U);
  }
}

TEST(Crc32c, does_not_depend_on_how_the_bytes_are_cut) {
  std::string bytes;
  for (int i = 0; i < 100; ++i) bytes += static_cast<char>(i * 37);
  Crc32c whole;
  whole.update(bytes);
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    Crc32c parts;
    parts.update(std::string_view(bytes).substr(0, cut));
    parts.update(std::string_view(bytes).substr(cut));
    ASSERT_EQ(parts.value(), whole.value()) << cut;
  }
}

TEST(Formats, every_conversion_is_lossless_both_ways) {
  std::size_t checks = 0;
  for (const auto& set : small_sets()) {
    for (const Format format : kFormats) {
      const std::string bytes = serialize(*set, format);
      const auto read = parse_set(bytes, "file");
      ASSERT_TRUE(read->equals(*set)) << set->unit().name;
      EXPECT_EQ(read->counts(), set->counts());
      for (const Format other : kFormats) {
        ASSERT_EQ(serialize(*parse_set(serialize(*read, other), "file"), format), bytes) << set->unit().name;
        ++checks;
      }
    }
  }
  EXPECT_GE(checks, 9 * units().size());
}

TEST(Formats, batches_together_are_the_whole_set) {
  for (const auto& set : small_sets()) {
    for (const Format format : kFormats) {
      const std::string bytes = serialize(*set, format);
      for (const std::size_t most : {std::size_t{1}, std::size_t{7}, set->size()}) {
        const auto reader = open_bytes(bytes, "file");
        const auto batch = reader->empty_set();
        const auto whole = reader->empty_set();
        while (reader->next(*batch, most)) {
          ASSERT_LE(batch->size(), most);
          for (std::size_t i = 0; i < batch->size(); ++i) whole->copy_case(*batch, i);
        }
        ASSERT_TRUE(whole->equals(*set)) << set->unit().name << " in batches of " << most;
      }
    }
  }
}

TEST(Formats, the_golden_verifies_what_was_read) {
  for (const auto& set : small_sets()) {
    const Verification verification = parse_set(serialize(*set, Format::text), "file")->verify();
    EXPECT_EQ(verification.mismatches, 0U) << set->unit().name;
    EXPECT_GT(verification.counts.checks, 0U) << set->unit().name;
  }
}

}  // namespace
}  // namespace cbvh::vectors
