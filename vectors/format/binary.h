// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "vectors/format/format.h"
#include "vectors/format/output.h"

/// Little-endian. Header: "cbvh-vec", u32 version, u16 bits, u16 treelet, u64 seed, then unit, fields and classes
/// (joined by ':'), each a u32 length and that many characters. A case: 'C', u64 id, u16 class, u32 stimuli, u32
/// responses, the packed stimuli, then each response as u32 latency (0: not stated) and the packed payload. End: 'E',
/// u64 cases, u64 checks, u32 CRC-32C of all before it. A payload is padded to whole bytes; its first field has its
/// lowest bits.
namespace cbvh::vectors {

constexpr std::string_view kBinaryMagic = "cbvh-vec";

void write_binary(const VectorSet& set, Output& output);
std::unique_ptr<SetReader> read_binary(std::string_view bytes, const std::string& name);

}  // namespace cbvh::vectors
