// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/scoreboard/minimise.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "testbench/scoreboard/subtree.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

using vectors::VectorSet;
using Bytes = std::vector<std::uint8_t>;  ///< one stimulus, as the object it is

constexpr std::uint64_t kOne = 0x3F800000;  ///< 1.0

class Minimiser {
 public:
  Minimiser(const VectorSet& set, std::size_t index, const StillFails& still_fails, std::size_t attempts)
      : set_(set),
        head_(set.head(index)),
        codec_(set.stimulus_codec()),
        still_fails_(still_fails),
        attempts_(attempts) {
    const VectorSet::Range range = set.stimulus_range(index);
    for (std::size_t i = 0; i < range.size; ++i) {
      const auto* object = static_cast<const std::uint8_t*>(set.stimulus_at(range.begin + i));
      stimuli_.emplace_back(object, object + codec_.object_size);
    }
  }

  std::unique_ptr<VectorSet> run() {
    if (set_.unit().stateful) {
      drop_groups();
      if (&codec_ == &subtree_codec()) keep_subtree();
    } else {
      simplify_fields();
    }
    return build(stimuli_);
  }

 private:
  std::unique_ptr<VectorSet> build(const std::vector<Bytes>& stimuli) const {
    auto one = vectors::make_set(set_.unit(), set_.parameters(), set_.seed());
    one->begin_case(head_.id, head_.case_class);
    for (const Bytes& bytes : stimuli) std::memcpy(one->add_stimulus(), bytes.data(), bytes.size());
    one->complete_case();
    return one;
  }

  /// Takes the stimuli over if they still fail.
  bool accept(std::vector<Bytes> stimuli) {
    if (attempts_ == 0 || stimuli.empty()) return false;
    --attempts_;
    try {
      if (!still_fails_(*build(stimuli))) return false;
    } catch (const golden::InputError&) {
      return false;
    }
    stimuli_ = std::move(stimuli);
    return true;
  }

  /// Ends of the stretches that must stay together: a tree, or a single stimulus.
  std::vector<std::size_t> group_ends() const {
    const auto root =
        std::find_if(codec_.leaves.begin(), codec_.leaves.end(), [](const auto& leaf) { return leaf.name == "root"; });
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < stimuli_.size(); ++i) {
      const bool ends_group = root == codec_.leaves.end() || read_leaf(*root, stimuli_[i]) != 0;
      if (ends_group || i + 1 == stimuli_.size()) ends.push_back(i + 1);
    }
    return ends;
  }

  /// Drops halves, quarters, ... of the groups, down to single ones.
  void drop_groups() {
    for (std::size_t chunk = std::max<std::size_t>(group_ends().size() / 2, 1);; chunk /= 2) {
      for (std::size_t first = 0;;) {
        const std::vector<std::size_t> ends = group_ends();
        if (first >= ends.size()) break;
        const std::size_t begin = first == 0 ? 0 : ends[first - 1];
        const std::size_t end = ends[std::min(first + chunk, ends.size()) - 1];
        std::vector<Bytes> rest(stimuli_.begin(), stimuli_.begin() + static_cast<std::ptrdiff_t>(begin));
        rest.insert(rest.end(), stimuli_.begin() + static_cast<std::ptrdiff_t>(end), stimuli_.end());
        if (!accept(rest)) first += chunk;
      }
      if (chunk == 1) break;
    }
  }

  /// Of the one tree that is left: the smallest subtree that fails as a tree of its own.
  void keep_subtree() {
    for (const std::vector<Bytes>& subtree : subtrees(stimuli_)) {
      if (accept(subtree)) return;
    }
  }

  void simplify_fields() {
    for (const vectors::CodecLeaf& leaf : codec_.leaves) {
      const bool is_float = leaf.kind == rtl::LeafDescription::Kind::binary32;
      if (!try_value(leaf, 0) && is_float) try_value(leaf, kOne);
    }
  }

  bool try_value(const vectors::CodecLeaf& leaf, std::uint64_t value) {
    if (read_leaf(leaf, stimuli_[0]) == value) return true;
    Bytes bytes = stimuli_[0];
    std::memcpy(bytes.data() + leaf.offset, &value, leaf.size);
    return accept({bytes});
  }

  /// Leaves are stored as machine integers of their size, lowest byte first on every machine we build for.
  static std::uint64_t read_leaf(const vectors::CodecLeaf& leaf, const Bytes& bytes) {
    static_assert(std::endian::native == std::endian::little);
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + leaf.offset, leaf.size);
    return value;
  }

  const VectorSet& set_;
  const VectorSet::Head head_;
  const vectors::PayloadCodec& codec_;
  const StillFails& still_fails_;
  std::size_t attempts_;
  std::vector<Bytes> stimuli_;
};

}  // namespace

std::unique_ptr<VectorSet> minimise(const VectorSet& set, std::size_t index, const StillFails& still_fails,
                                    std::size_t attempts) {
  return Minimiser(set, index, still_fails, attempts).run();
}

}  // namespace cbvh::testbench
