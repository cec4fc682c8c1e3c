// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "vectors/format/payload_codec.h"

namespace cbvh::testbench {

/// The codec of the stimuli that subtrees() understands: a stream of float pairs.
const vectors::PayloadCodec& subtree_codec();

/// Every proper subtree of one tree, given and returned as the objects of its stream, smallest first. Emission is depth
/// first, so a subtree is a stretch of the stream; its pointers are moved and its last pair becomes the root. Of
/// several trees in one stream, none.
std::vector<std::vector<std::vector<std::uint8_t>>> subtrees(const std::vector<std::vector<std::uint8_t>>& tree);

}  // namespace cbvh::testbench
