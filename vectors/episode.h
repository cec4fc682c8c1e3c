// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cbvh::vectors {

/// Synthesis parameters of the hardware that a vector set is made for.
struct Parameters {
  int bits = 6;     ///< N, 2..8
  int treelet = 1;  ///< D, 1..8; units without treelets want 1
  bool operator==(const Parameters&) const = default;
};

/// A response, and the cycle in which it must appear when nothing stalls: cycles after the acceptance of the episode's
/// first stimulus.
template <class Response>
struct Expected {
  Response response;
  std::uint32_t latency = 0;
  bool operator==(const Expected&) const = default;
};

/// One case. A unit without state has one stimulus and one response in each.
template <class Stimulus, class Response>
struct Episode {
  std::uint64_t id = 0;
  std::uint16_t case_class = 0;  ///< an index into the unit's list of classes: the corner the case was made for
  std::vector<Stimulus> stimuli;
  std::vector<Expected<Response>> responses;
};

}  // namespace cbvh::vectors
