// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cbvh::testbench {

/// What a backend gave for the cases of a set, in their order. The type is known to the unit's codec alone.
class Responses {
 public:
  struct Case {
    std::size_t begin;
    std::size_t size;
    bool hung;  ///< it was given up: nothing moved any more
  };

  explicit Responses(std::size_t object_size) : object_size_(object_size) {}

  /// Adds a response to the case that the next end_case closes. A latency of kLatencyNotStated: the backend has no
  /// clock.
  void add(const void* response, std::uint32_t latency) {
    const auto* bytes = static_cast<const std::byte*>(response);
    bytes_.insert(bytes_.end(), bytes, bytes + object_size_);
    latencies_.push_back(latency);
  }
  /// Adds as many responses as latencies; they lie one behind the other.
  void add(const void* responses, std::span<const std::uint32_t> latencies) {
    const auto* bytes = static_cast<const std::byte*>(responses);
    bytes_.insert(bytes_.end(), bytes, bytes + latencies.size() * object_size_);
    latencies_.insert(latencies_.end(), latencies.begin(), latencies.end());
  }
  /// Closes a case of the responses that are in none yet; or of the first `size` of them.
  void end_case(bool hung = false) { end_case(latencies_.size() - next_begin(), hung); }
  void end_case(std::size_t size, bool hung) { cases_.push_back({next_begin(), size, hung}); }
  void reserve(std::size_t responses) {
    bytes_.reserve(responses * object_size_);
    latencies_.reserve(responses);
    cases_.reserve(responses);
  }

  std::size_t cases() const { return cases_.size(); }
  const Case& at_case(std::size_t index) const { return cases_[index]; }
  const void* response(std::size_t index) const { return bytes_.data() + index * object_size_; }
  std::uint32_t latency(std::size_t index) const { return latencies_[index]; }

  std::uint64_t cycles = 0;  ///< simulated

 private:
  std::size_t next_begin() const { return cases_.empty() ? 0 : cases_.back().begin + cases_.back().size; }

  std::size_t object_size_;
  std::vector<std::byte> bytes_;
  std::vector<std::uint32_t> latencies_;
  std::vector<Case> cases_;
};

}  // namespace cbvh::testbench
