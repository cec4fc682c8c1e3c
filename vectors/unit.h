// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "golden/input_error.h"
#include "vectors/episode.h"
#include "vectors/format/payload_codec.h"
#include "vectors/random.h"

namespace cbvh::vectors {

/// The latency of a response whose cycle is not stated: written `@-`, counted as unchecked.
constexpr std::uint32_t kLatencyNotStated = 0;

/// A unit, as vectors/units/ defines one struct (or one template over N) for each:
///   kName, kSummary, kLatencyText    texts
///   kStateful                        false: one stimulus, one response a case
///   kTreelet                         whether Parameters::treelet matters
///   kClasses                         names of the corners its generator makes
///   Stimulus, Response               payloads
///   generate(case_class, random, parameters) -> vector<Stimulus>
///   respond(stimuli, parameters) -> vector<Expected<Response>>      the golden face
/// and, without state: kLatency, generate_one(...) -> Stimulus, respond_one(stimulus, parameters) -> Response.
template <class U>
concept VectorUnit = requires(std::span<const typename U::Stimulus> stimuli, Random& random,
                              const Parameters& parameters, std::size_t case_class) {
  { U::kName } -> std::convertible_to<std::string_view>;
  { U::kSummary } -> std::convertible_to<std::string_view>;
  { U::kLatencyText } -> std::convertible_to<std::string_view>;
  { U::kStateful } -> std::convertible_to<bool>;
  { U::kTreelet } -> std::convertible_to<bool>;
  {std::span<const std::string_view>(U::kClasses)};
  { U::generate(case_class, random, parameters) } -> std::same_as<std::vector<typename U::Stimulus>>;
  { U::respond(stimuli, parameters) } -> std::same_as<std::vector<Expected<typename U::Response>>>;
};

/// What a unit without state adds to respond_one and generate_one.
template <class U, class Stimulus_, class Response_>
struct StatelessUnit {
  using Stimulus = Stimulus_;
  using Response = Response_;
  static constexpr bool kStateful = false;
  static constexpr bool kTreelet = false;
  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters& parameters) {
    return {U::generate_one(case_class, random, parameters)};
  }
  static std::vector<Expected<Response>> respond(std::span<const Stimulus> stimuli, const Parameters& parameters) {
    std::vector<Expected<Response>> responses;
    for (const Stimulus& stimulus : stimuli) {
      responses.push_back({U::respond_one(stimulus, parameters), U::kLatency});
    }
    return responses;
  }
};

/// The N that this build has. With CBVH_FEW_BITS the even ones stand for all: for builds that are slow and look for
/// something that does not depend on N.
#ifdef CBVH_FEW_BITS
inline constexpr std::array kBuiltBits = {2, 4, 6, 8};
#else
inline constexpr std::array kBuiltBits = {2, 3, 4, 5, 6, 7, 8};
#endif

/// Calls f(std::integral_constant<int, N>) for N = bits.
template <class F>
decltype(auto) with_bits(int bits, F&& f) {
  switch (bits) {
    case 2:
      return f(std::integral_constant<int, 2>());
    case 4:
      return f(std::integral_constant<int, 4>());
    case 6:
      return f(std::integral_constant<int, 6>());
    case 8:
      return f(std::integral_constant<int, 8>());
#ifndef CBVH_FEW_BITS
    case 3:
      return f(std::integral_constant<int, 3>());
    case 5:
      return f(std::integral_constant<int, 5>());
    case 7:
      return f(std::integral_constant<int, 7>());
#endif
    default:
      throw golden::InputError("bits", fmt::format("found {}, want {}", bits, fmt::join(kBuiltBits, ", ")));
  }
}

class VectorSet;

/// A unit, with its types forgotten.
struct UnitDescription {
  std::string_view name;
  std::string_view summary;
  std::string_view latency_text;
  bool stateful;
  std::vector<std::string_view> classes;  ///< those the generator makes; the last one is kCaptured
  std::vector<int> bits;                  ///< allowed values of N; one when nothing depends on it
  std::vector<int> treelets;              ///< allowed values of D; one when nothing depends on it
  const PayloadCodec& (*stimulus)(int bits);
  const PayloadCodec& (*response)(int bits);
  /// Use make_set, which checks the parameters.
  std::unique_ptr<VectorSet> (*empty_set)(const UnitDescription& unit, const Parameters& parameters,
                                          std::uint64_t seed);

  std::size_t generated_classes() const { return classes.size() - 1; }
  /// The names of the fields, stimulus > response.
  std::string field_names(int n) const { return stimulus(n).field_names() + ">" + response(n).field_names(); }
};

/// The class of cases met in a real scene.
constexpr std::string_view kCaptured = "captured";

}  // namespace cbvh::vectors
