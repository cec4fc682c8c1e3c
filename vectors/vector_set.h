// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "vectors/unit.h"

namespace cbvh::vectors {

/// What a set holds. A check is one response field; a latency that is not stated is counted apart and checks nothing.
struct Counts {
  std::uint64_t cases = 0;
  std::uint64_t stimuli = 0;
  std::uint64_t responses = 0;
  std::uint64_t checks = 0;              ///< response fields
  std::uint64_t latencies = 0;           ///< responses whose cycle is stated
  std::uint64_t latencies_unstated = 0;  ///< responses whose cycle is not
  bool operator==(const Counts&) const = default;
};

/// A response that differs from the golden's.
struct Mismatch {
  std::uint64_t id = 0;
  std::string case_class;
  std::size_t response = 0;  ///< within the case
  std::string what;          ///< "field 'code_lo': found 20, want 21", "latency: found 4, want 3", ...
};

struct Verification {
  Counts counts;                 ///< of what was compared
  std::uint64_t mismatches = 0;  ///< cases that differ
  std::vector<Mismatch> first;   ///< of the first few such cases, the first difference
};

/// Cases of one unit, of a type that only TypedVectorSet knows. Ids rise. Cases are kept flat: heads, stimuli and
/// responses in an array each.
class VectorSet {
 public:
  struct Head {
    std::uint64_t id;
    std::uint16_t case_class;  ///< an index into unit().classes
  };
  /// Where a case's stimuli or responses lie in their flat array.
  struct Range {
    std::size_t begin;
    std::size_t size;
  };

  virtual ~VectorSet() = default;
  VectorSet(const VectorSet&) = delete;
  VectorSet& operator=(const VectorSet&) = delete;

  const UnitDescription& unit() const { return *unit_; }
  const Parameters& parameters() const { return parameters_; }
  std::uint64_t seed() const { return seed_; }
  const PayloadCodec& stimulus_codec() const { return unit_->stimulus(parameters_.bits); }
  const PayloadCodec& response_codec() const { return unit_->response(parameters_.bits); }

  std::size_t size() const { return heads_.size(); }
  bool empty() const { return heads_.empty(); }
  const Head& head(std::size_t index) const { return heads_[index]; }
  std::string_view class_name(std::size_t index) const { return unit_->classes[heads_[index].case_class]; }
  Range stimulus_range(std::size_t index) const;
  Range response_range(std::size_t index) const;
  /// The index of the case with this id, or size().
  std::size_t find(std::uint64_t id) const;
  Counts counts() const;

  /// Removes all cases.
  virtual void clear() = 0;
  /// Starts a case; add_stimulus and add_response add to it. Its id must be above the last one's.
  void begin_case(std::uint64_t id, std::uint16_t case_class);
  /// The address of a new stimulus (all zero) of the last case. Stimuli come before responses. The address is good
  /// until the next is added.
  virtual void* add_stimulus() = 0;
  struct ResponseSlot {
    void* response;
    std::uint32_t* latency;
  };
  virtual ResponseSlot add_response() = 0;
  /// By index in the flat arrays.
  virtual const void* stimulus_at(std::size_t index) const = 0;
  virtual const void* response_at(std::size_t index) const = 0;
  virtual std::uint32_t latency_at(std::size_t index) const = 0;
  virtual std::size_t stimulus_count() const = 0;
  virtual std::size_t response_count() const = 0;

  /// Ends the last case with the golden's responses to its stimuli.
  virtual void add_golden_responses() = 0;
  /// Adds case `id` as the generator makes it from seed(), with the golden's responses.
  virtual void generate_case(std::uint64_t id) = 0;
  /// Gives the last case, whose stimuli have all been added, the golden's responses to them.
  virtual void complete_case() = 0;
  /// Adds a copy of a case of another set of the same unit and parameters.
  void copy_case(const VectorSet& from, std::size_t index);
  /// Compares every stored response and stated latency with the golden's.
  virtual Verification verify() const = 0;
  /// The same unit, parameters, seed, cases and latencies.
  bool equals(const VectorSet& other) const;

 protected:
  VectorSet(const UnitDescription& unit, const Parameters& parameters, std::uint64_t seed)
      : unit_(&unit), parameters_(parameters), seed_(seed) {}
  void clear_heads() {
    heads_.clear();
    starts_.clear();
  }

 private:
  const UnitDescription* unit_;
  Parameters parameters_;
  std::uint64_t seed_;
  std::vector<Head> heads_;
  std::vector<std::pair<std::size_t, std::size_t>> starts_;  ///< first stimulus and response; stateful units only
};

/// Which cases to make: those whose id modulo `count` is `index`.
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t count = 1;
};

}  // namespace cbvh::vectors
