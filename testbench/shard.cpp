// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/shard.h"

#include <charconv>

#include "golden/input_error.h"

namespace cbvh::testbench {

Shard parse_shard(const std::string& text) {
  const char* const end = text.data() + text.size();
  Shard shard;
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = slash ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!slash || count.ec != std::errc() || count.ptr != end || shard.count == 0 || shard.index > shard.count) {
    throw golden::InputError("--shard",
                             fmt::format("found '{}', want i/n with 0 <= i <= n and n > 0 (n/n is 0/n)", text));
  }
  shard.index %= shard.count;
  return shard;
}

std::string to_string(const Shard& shard) { return fmt::format("{}/{}", shard.index, shard.count); }

}  // namespace cbvh::testbench
