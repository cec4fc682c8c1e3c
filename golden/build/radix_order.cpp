// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/radix_order.h"

#include <array>
#include <bit>
#include <utility>

namespace cbvh::golden {
namespace {

struct Item {
  std::uint32_t key;
  std::uint32_t index;
};

/// Unsigned integers in the order of the floats.
std::uint32_t ordered_bits(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x + 0.0F);  // -0 + 0 is 0
  return (bits >> 31) != 0 ? ~bits : bits | (1U << 31);
}

}  // namespace

std::vector<std::uint32_t> radix_order(std::span<const float> keys) {
  constexpr unsigned kDigitBits = 11;
  constexpr std::uint32_t kDigits = 1U << kDigitBits;
  std::array<std::array<std::uint32_t, kDigits>, 3> next{};
  std::vector<Item> from(keys.size());
  std::vector<Item> to(keys.size());
  const auto digit = [](std::uint32_t key, std::size_t pass) { return key >> (pass * kDigitBits) & (kDigits - 1); };
  for (std::uint32_t i = 0; i < from.size(); ++i) {
    from[i] = {ordered_bits(keys[i]), i};
    for (std::size_t pass = 0; pass < next.size(); ++pass) ++next[pass][digit(from[i].key, pass)];
  }
  for (std::size_t pass = 0; pass < next.size(); ++pass) {
    std::uint32_t sum = 0;
    for (std::uint32_t& n : next[pass]) sum += std::exchange(n, sum);
    for (const Item& item : from) to[next[pass][digit(item.key, pass)]++] = item;
    from.swap(to);
  }
  std::vector<std::uint32_t> order(keys.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = from[i].index;
  return order;
}

}  // namespace cbvh::golden
