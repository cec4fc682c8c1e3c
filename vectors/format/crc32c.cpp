// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/crc32c.h"

#include <array>
#include <bit>
#include <cstring>

#if defined(__x86_64__)
#include <nmmintrin.h>
#endif

namespace cbvh::vectors {
namespace {

static_assert(std::endian::native == std::endian::little);

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0x82F63B78U : 0);
    tables[0][byte] = crc;
  }
  for (std::size_t byte = 0; byte < 256; ++byte) {
    for (std::size_t table = 1; table < 8; ++table) {
      const std::uint32_t before = tables[table - 1][byte];
      tables[table][byte] = (before >> 8) ^ tables[0][before & 0xFF];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

std::uint32_t update_by_tables(std::uint32_t crc, const char* p, std::size_t left) {
  for (; left >= 8; p += 8, left -= 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, p, 8);
    word ^= crc;
    crc = 0;
    for (std::size_t byte = 0; byte < 8; ++byte) crc ^= kTables[7 - byte][(word >> (8 * byte)) & 0xFF];
  }
  for (; left > 0; ++p, --left) crc = (crc >> 8) ^ kTables[0][(crc ^ static_cast<std::uint8_t>(*p)) & 0xFF];
  return crc;
}

#if defined(__x86_64__)
/// By the processor's own instruction: four times as fast.
__attribute__((target("sse4.2"))) std::uint32_t update_by_instruction(std::uint32_t crc, const char* p,
                                                                      std::size_t left) {
  std::uint64_t wide = crc;
  for (; left >= 8; p += 8, left -= 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, p, 8);
    wide = _mm_crc32_u64(wide, word);
  }
  crc = static_cast<std::uint32_t>(wide);
  for (; left > 0; ++p, --left) crc = _mm_crc32_u8(crc, static_cast<std::uint8_t>(*p));
  return crc;
}
bool has_instruction() {
  static const bool has = __builtin_cpu_supports("sse4.2") != 0;
  return has;
}
#else
constexpr auto& update_by_instruction = update_by_tables;
bool has_instruction() { return false; }
#endif

}  // namespace

void Crc32c::update(std::string_view bytes, Crc32cMethod method) {
  const bool instruction = method == Crc32cMethod::fastest && has_instruction();
  state_ = (instruction ? update_by_instruction : update_by_tables)(state_, bytes.data(), bytes.size());
}

}  // namespace cbvh::vectors
