// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// A damaged file is refused or says the same: never a crash, a hang or another set.
#include <gtest/gtest.h>

#include "vectors/format/format.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

struct Sample {
  std::unique_ptr<VectorSet> set;
  Format format;
  std::string bytes;
};

std::vector<Sample> samples() {
  std::vector<Sample> all;
  for (const char* unit : {"axis_compressor", "context_stack", "backtrack_unit"}) {
    for (const Format format : {Format::text, Format::hex, Format::binary}) {
      auto set = generate_set(unit, {}, unit == std::string("axis_compressor") ? 18 : 3, 11);
      std::string bytes = serialize(*set, format);
      all.push_back({std::move(set), format, std::move(bytes)});
    }
  }
  return all;
}

/// Whether the bytes were refused; fails the test when they gave another set.
bool refused(const std::string& bytes, const Sample& sample) {
  try {
    const auto set = parse_set(bytes, "damaged");
    EXPECT_TRUE(set->equals(*sample.set)) << "accepted, but another set";
    return false;
  } catch (const golden::InputError&) {
    return true;
  }
}

TEST(Corruption, every_truncation_is_refused) {
  for (const Sample& sample : samples()) {
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      ASSERT_TRUE(refused(sample.bytes.substr(0, size), sample)) << size << " of " << sample.bytes.size();
    }
  }
}

TEST(Corruption, every_changed_byte_is_refused_or_changes_nothing) {
  Random random(1);
  std::size_t accepted = 0;
  std::size_t damaged = 0;
  for (const Sample& sample : samples()) {
    for (std::size_t at = 0; at < sample.bytes.size(); ++at) {
      std::string bytes = sample.bytes;
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 << random.below(8)));
      accepted += !refused(bytes, sample);
      bytes[at] = static_cast<char>(random.next());
      accepted += bytes != sample.bytes && !refused(bytes, sample);
      damaged += 2;
    }
  }
  EXPECT_GT(damaged, 10'000U);
  EXPECT_LT(accepted, damaged / 1000);
}

TEST(Corruption, inserted_removed_and_swapped_pieces_are_refused) {
  Random random(2);
  for (const Sample& sample : samples()) {
    for (int i = 0; i < 300; ++i) {
      std::string bytes = sample.bytes;
      const std::size_t at = random.below(bytes.size());
      const std::size_t size = 1 + random.below(40);
      if (random.flip()) {
        bytes.erase(at, size);
      } else {
        const std::size_t from = random.below(sample.bytes.size());
        bytes.insert(at, sample.bytes.substr(from, size));
      }
      if (bytes != sample.bytes) {
        ASSERT_TRUE(refused(bytes, sample));
      }
    }
  }
}

TEST(Corruption, announced_sizes_beyond_the_file_allocate_nothing) {
  const auto set = generate_set("context_stack", {}, 7, 3);
  std::string text = serialize(*set, Format::text);
  const std::string episode = "random-walk episode ";
  text.insert(text.find(episode) + episode.size(), "42000000");
  EXPECT_THROW(parse_set(text, "f"), golden::InputError);
  std::string binary = serialize(*set, Format::binary);
  binary.replace(24, 4, "\xFF\xFF\xFF\x7F");  // the length of the unit's name
  EXPECT_THROW(parse_set(binary, "f"), golden::InputError);
}

}  // namespace
}  // namespace cbvh::vectors
