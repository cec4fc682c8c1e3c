// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/vector_set.h"

#include <algorithm>
#include <cassert>

#include "vectors/typed_vector_set.h"

namespace cbvh::vectors {

VectorSet::Range VectorSet::stimulus_range(std::size_t index) const {
  if (!unit_->stateful) return {index, 1};
  const std::size_t begin = starts_[index].first;
  return {begin, (index + 1 < starts_.size() ? starts_[index + 1].first : stimulus_count()) - begin};
}

VectorSet::Range VectorSet::response_range(std::size_t index) const {
  if (!unit_->stateful) return {index, 1};
  const std::size_t begin = starts_[index].second;
  return {begin, (index + 1 < starts_.size() ? starts_[index + 1].second : response_count()) - begin};
}

std::size_t VectorSet::find(std::uint64_t id) const {
  const auto below = [](const Head& head, std::uint64_t wanted) { return head.id < wanted; };
  const auto found = std::lower_bound(heads_.begin(), heads_.end(), id, below);
  return found != heads_.end() && found->id == id ? static_cast<std::size_t>(found - heads_.begin()) : size();
}

Counts VectorSet::counts() const {
  Counts counts{size(), stimulus_count(), response_count(), response_count() * response_codec().leaves.size(), 0, 0};
  for (std::size_t i = 0; i < response_count(); ++i) counts.latencies += latency_at(i) != kLatencyNotStated;
  counts.latencies_unstated = counts.responses - counts.latencies;
  return counts;
}

void VectorSet::begin_case(std::uint64_t id, std::uint16_t case_class) {
  assert(heads_.empty() || heads_.back().id < id);
  assert(case_class < unit_->classes.size());
  heads_.push_back({id, case_class});
  if (unit_->stateful) starts_.emplace_back(stimulus_count(), response_count());
}

void VectorSet::copy_case(const VectorSet& from, std::size_t index) {
  assert(unit_ == from.unit_ && parameters_ == from.parameters_);
  begin_case(from.head(index).id, from.head(index).case_class);
  const Range stimuli = from.stimulus_range(index);
  for (std::size_t i = 0; i < stimuli.size; ++i) {
    std::memcpy(add_stimulus(), from.stimulus_at(stimuli.begin + i), stimulus_codec().object_size);
  }
  const Range responses = from.response_range(index);
  for (std::size_t i = 0; i < responses.size; ++i) {
    const ResponseSlot slot = add_response();
    std::memcpy(slot.response, from.response_at(responses.begin + i), response_codec().object_size);
    *slot.latency = from.latency_at(responses.begin + i);
  }
}

bool VectorSet::equals(const VectorSet& other) const {
  if (unit_ != other.unit_ || !(parameters_ == other.parameters_) || seed_ != other.seed_) return false;
  if (size() != other.size() || stimulus_count() != other.stimulus_count()) return false;
  if (response_count() != other.response_count()) return false;
  const auto same_text = [](const PayloadCodec& codec, const void* a, const void* b) {
    std::string texts[2] = {std::string(codec.text_length, ' '), std::string(codec.text_length, ' ')};
    codec.print_text(a, texts[0].data());
    codec.print_text(b, texts[1].data());
    return texts[0] == texts[1];
  };
  for (std::size_t i = 0; i < size(); ++i) {
    const auto same_range = [](Range a, Range b) { return a.begin == b.begin && a.size == b.size; };
    if (head(i).id != other.head(i).id || head(i).case_class != other.head(i).case_class ||
        !same_range(stimulus_range(i), other.stimulus_range(i)) ||
        !same_range(response_range(i), other.response_range(i))) {
      return false;
    }
  }
  for (std::size_t i = 0; i < stimulus_count(); ++i) {
    if (!same_text(stimulus_codec(), stimulus_at(i), other.stimulus_at(i))) return false;
  }
  for (std::size_t i = 0; i < response_count(); ++i) {
    if (latency_at(i) != other.latency_at(i)) return false;
    if (!same_text(response_codec(), response_at(i), other.response_at(i))) return false;
  }
  return true;
}

namespace detail {

std::string describe_difference(const PayloadCodec& codec, const void* found, const void* want) {
  std::string texts[2] = {std::string(codec.text_length, ' '), std::string(codec.text_length, ' ')};
  codec.print_text(found, texts[0].data());
  codec.print_text(want, texts[1].data());
  std::size_t begin = 0;
  for (const auto& leaf : codec.leaves) {
    const auto digits = static_cast<std::size_t>(hex_digits(leaf.width));
    const std::string parts[2] = {texts[0].substr(begin, digits), texts[1].substr(begin, digits)};
    if (parts[0] != parts[1]) return fmt::format("field '{}': found {}, want {}", leaf.name, parts[0], parts[1]);
    begin += digits + 1;
  }
  return "no difference";
}

void note_mismatch(Verification& verification, Mismatch mismatch) {
  constexpr std::size_t kKept = 16;
  ++verification.mismatches;
  if (verification.first.size() < kKept) verification.first.push_back(std::move(mismatch));
}

}  // namespace detail

}  // namespace cbvh::vectors
