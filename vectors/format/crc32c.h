// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace cbvh::vectors {

enum class Crc32cMethod : std::uint8_t {
  fastest,  ///< the processor's instruction where there is one
  tables
};

/// CRC-32C (Castagnoli; RFC 3720, appendix B.4), eight bytes a step. Boost.CRC goes byte by byte: too slow beside the
/// parser.
class Crc32c {
 public:
  void update(std::string_view bytes, Crc32cMethod method = Crc32cMethod::fastest);
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = ~std::uint32_t{0};
};

}  // namespace cbvh::vectors
