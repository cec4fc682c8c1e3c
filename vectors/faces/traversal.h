// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "vectors/faces/ray.h"

/// The golden's answer for a ray through a whole tree, in plain numbers.
namespace cbvh::vectors {

struct PlainRay {
  std::array<float, 3> origin;
  std::array<float, 3> direction;
  float t_min;
  float t_max;
};

/// A tree in memory. Entries of the ID array carry golden::kLastOfLeaf.
struct PlainRayTree {
  std::function<golden::CompressedPair(std::uint32_t)> pair;
  std::function<std::uint32_t(std::uint32_t)> entry;
  bool leaf;
  std::uint32_t root;
  std::array<PlainDistances, 3> box;  ///< lower and upper edges of the root's cells
  std::array<PlainGridAxis, 3> grid;
  rtl::SceneRegisters registers;
};

struct PlainCandidate {
  std::uint32_t entry_index;
  std::uint32_t primitive;
  bool last_of_leaf;
  float entry;
};

/// What the primitives of a leaf did.
struct PlainReply {
  float t = std::numeric_limits<float>::infinity();
  bool stop = false;
};

struct TraversedRay {
  rtl::Status status = rtl::Status::ok;
  std::uint32_t place = 0;
  std::uint32_t pairs = 0;
  std::uint32_t leaves = 0;
  std::uint32_t lines = 0;
  float t_max = 0;
};

/// Nodes that may wait for a ray.
constexpr std::size_t kMostWaiting = 32;

/// Leads a ray through the tree: the child it enters first, then the other if it still reaches it. meet(candidate)
/// hears of every primitive of the leaves it reaches, reply() answers for a leaf whose last one it was. Lines are those
/// read for pairs, four to a line, if the last one is kept.
TraversedRay traverse(const PlainRay& ray, const PlainRayTree& tree, int bits,
                      const std::function<void(const PlainCandidate&)>& meet, const std::function<PlainReply()>& reply);

}  // namespace cbvh::vectors
