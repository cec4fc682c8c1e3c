// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>

#include "golden/tree/node_pair_format.h"
#include "vectors/vector_set.h"

namespace cbvh::vectors {

namespace detail {
/// The first difference between a stored response and the golden's, as text.
std::string describe_difference(const PayloadCodec& codec, const void* found, const void* want);
/// Counts a case that differs and keeps the first few.
void note_mismatch(Verification& verification, Mismatch mismatch);
}  // namespace detail

/// Cases of one unit.
template <VectorUnit U>
class TypedVectorSet final : public VectorSet {
 public:
  using Stimulus = typename U::Stimulus;
  using Response = typename U::Response;

  TypedVectorSet(const UnitDescription& unit, const Parameters& parameters, std::uint64_t seed)
      : VectorSet(unit, parameters, seed) {}

  /// Of all cases, one after the other.
  std::span<const Stimulus> stimuli() const { return stimuli_; }
  std::span<const Expected<Response>> responses() const { return responses_; }
  /// Of one case.
  std::span<const Stimulus> stimuli(std::size_t index) const {
    const Range range = stimulus_range(index);
    return stimuli().subspan(range.begin, range.size);
  }
  std::span<const Expected<Response>> responses(std::size_t index) const {
    const Range range = response_range(index);
    return responses().subspan(range.begin, range.size);
  }
  Episode<Stimulus, Response> episode(std::size_t index) const {
    const auto s = stimuli(index);
    const auto r = responses(index);
    return {head(index).id, head(index).case_class, {s.begin(), s.end()}, {r.begin(), r.end()}};
  }

  /// Adds a case with the responses given.
  void add(const Episode<Stimulus, Response>& episode) {
    begin_case(episode.id, episode.case_class);
    stimuli_.insert(stimuli_.end(), episode.stimuli.begin(), episode.stimuli.end());
    responses_.insert(responses_.end(), episode.responses.begin(), episode.responses.end());
  }
  /// Adds a case with the golden's responses.
  void add(std::uint64_t id, std::uint16_t case_class, const std::vector<Stimulus>& case_stimuli) {
    begin_case(id, case_class);
    stimuli_.insert(stimuli_.end(), case_stimuli.begin(), case_stimuli.end());
    append_golden(case_stimuli);
  }

  void clear() override {
    clear_heads();
    stimuli_.clear();
    responses_.clear();
  }
  void* add_stimulus() override { return &stimuli_.emplace_back(); }
  ResponseSlot add_response() override {
    Expected<Response>& expected = responses_.emplace_back();
    return {&expected.response, &expected.latency};
  }
  const void* stimulus_at(std::size_t index) const override { return &stimuli_[index]; }
  const void* response_at(std::size_t index) const override { return &responses_[index].response; }
  std::uint32_t latency_at(std::size_t index) const override { return responses_[index].latency; }
  std::size_t stimulus_count() const override { return stimuli_.size(); }
  std::size_t response_count() const override { return responses_.size(); }

  void add_golden_responses() override {
    const auto last = stimuli(size() - 1);
    append_golden({last.begin(), last.end()});
  }

  void generate_case(std::uint64_t id) override {
    Random random(mix(seed(), id));
    const std::size_t case_class = id % unit().generated_classes();
    begin_case(id, static_cast<std::uint16_t>(case_class));
    if constexpr (U::kStateful) {
      const std::vector<Stimulus> made = U::generate(case_class, random, parameters());
      stimuli_.insert(stimuli_.end(), made.begin(), made.end());
      append_golden(made);
    } else {
      stimuli_.push_back(U::generate_one(case_class, random, parameters()));
      append_golden({&stimuli_.back(), 1});
    }
  }

  void complete_case() override {
    const auto last = stimuli(size() - 1);
    append_golden(std::vector<Stimulus>(last.begin(), last.end()));
  }

  Verification verify() const override {
    Verification verification;
    verification.counts = counts();
    for (std::size_t index = 0; index < size(); ++index) {
      if constexpr (U::kStateful) {
        compare(index, respond_in_place(index), verification);
      } else {
        const Expected<Response> want[] = {{U::respond_one(stimuli_[index], parameters()), U::kLatency}};
        compare(index, want, verification);
      }
    }
    return verification;
  }

 private:
  void append_golden(std::span<const Stimulus> case_stimuli) {
    if constexpr (U::kStateful) {
      const auto golden = U::respond(case_stimuli, parameters());
      responses_.insert(responses_.end(), golden.begin(), golden.end());
    } else {
      for (const Stimulus& stimulus : case_stimuli) {
        responses_.push_back({U::respond_one(stimulus, parameters()), U::kLatency});
      }
    }
  }

  /// The golden's responses; what it cannot make sense of is bad input, and gets the case's place.
  std::vector<Expected<Response>> respond_in_place(std::size_t index) const {
    try {
      return U::respond(stimuli(index), parameters());
    } catch (const golden::InputError& error) {
      throw golden::InputError(fmt::format("{} case {}", unit().name, head(index).id), error.what());
    }
  }

  void compare(std::size_t index, std::span<const Expected<Response>> want, Verification& verification) const {
    const auto found = responses(index);
    const auto mismatch = [&](std::size_t response, std::string what) {
      detail::note_mismatch(verification, {head(index).id, std::string(class_name(index)), response, std::move(what)});
    };
    for (std::size_t i = 0; i < std::min(found.size(), want.size()); ++i) {
      if (!(found[i].response == want[i].response)) {
        return mismatch(i, detail::describe_difference(response_codec(), &found[i].response, &want[i].response));
      }
      if (found[i].latency != want[i].latency && found[i].latency != kLatencyNotStated) {
        return mismatch(i, fmt::format("latency: found {}, want {}", found[i].latency, want[i].latency));
      }
    }
    if (found.size() != want.size()) {
      mismatch(std::min(found.size(), want.size()), fmt::format("{} responses, want {}", found.size(), want.size()));
    }
  }

  std::vector<Stimulus> stimuli_;
  std::vector<Expected<Response>> responses_;
};

namespace detail {
/// What the description of a unit says without its types. `Any` is the unit, for some N.
template <class Any>
UnitDescription describe_texts() {
  UnitDescription unit;
  unit.name = Any::kName;
  unit.summary = Any::kSummary;
  unit.latency_text = Any::kLatencyText;
  unit.stateful = Any::kStateful;
  unit.classes.assign(Any::kClasses.begin(), Any::kClasses.end());
  unit.classes.push_back(kCaptured);
  unit.treelets = Any::kTreelet ? std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8} : std::vector<int>{1};
  return unit;
}
}  // namespace detail

/// The description of a family of units, one for each N.
template <template <int> class UnitOf>
UnitDescription describe_unit_of_bits() {
  UnitDescription unit = detail::describe_texts<UnitOf<6>>();
  unit.bits.assign(kBuiltBits.begin(), kBuiltBits.end());
  unit.stimulus = [](int bits) -> const PayloadCodec& {
    return with_bits(bits, [](auto n) -> const PayloadCodec& {
      return payload_codec<typename UnitOf<decltype(n)::value>::Stimulus>();
    });
  };
  unit.response = [](int bits) -> const PayloadCodec& {
    return with_bits(bits, [](auto n) -> const PayloadCodec& {
      return payload_codec<typename UnitOf<decltype(n)::value>::Response>();
    });
  };
  unit.empty_set = [](const UnitDescription& self, const Parameters& parameters, std::uint64_t seed) {
    return with_bits(parameters.bits, [&](auto n) -> std::unique_ptr<VectorSet> {
      return std::make_unique<TypedVectorSet<UnitOf<decltype(n)::value>>>(self, parameters, seed);
    });
  };
  return unit;
}

/// The description of a family of units whose pairs lie packed in memory: wider codes have no packed form.
template <template <int> class UnitOf>
UnitDescription describe_unit_of_packed_bits() {
  UnitDescription unit = describe_unit_of_bits<UnitOf>();
  std::erase_if(unit.bits, [](int bits) { return bits > golden::kMostPackedBits; });
  return unit;
}

/// The description of a unit in which nothing depends on N.
template <class U>
UnitDescription describe_unit() {
  UnitDescription unit = detail::describe_texts<U>();
  unit.bits = {6};
  unit.stimulus = [](int) -> const PayloadCodec& { return payload_codec<typename U::Stimulus>(); };
  unit.response = [](int) -> const PayloadCodec& { return payload_codec<typename U::Response>(); };
  unit.empty_set = [](const UnitDescription& self, const Parameters& parameters, std::uint64_t seed) {
    return std::unique_ptr<VectorSet>(std::make_unique<TypedVectorSet<U>>(self, parameters, seed));
  };
  return unit;
}

}  // namespace cbvh::vectors
