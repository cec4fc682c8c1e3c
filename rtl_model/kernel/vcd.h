// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "rtl_model/bits/fields.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/kernel/reg.h"

namespace cbvh::rtl {

/// Writes a value change dump (IEEE 1364) of chosen scopes and cycles; one cycle is one nanosecond. A design that has
/// no dump attached pays nothing for it: nobody but the dump looks at the signals.
class ValueChangeDump {
 public:
  /// Dumps signals whose path (dots between scopes) is `scope` or lies below it, in cycles first..last. An empty scope
  /// takes all.
  ValueChangeDump(std::ostream& out, std::string scope, std::uint64_t first_cycle, std::uint64_t last_cycle);

  /// valid and ready of a channel, and every field of what it holds.
  template <class T>
  void add(const std::string& path, const Channel<T>& channel) {
    add_bit(path + ".valid", [&channel] { return channel.can_pop(); });
    add_bit(path + ".ready", [&channel] { return channel.can_push(); });
    add_payload<T>(path, [&channel]() -> const T* { return channel.can_pop() ? &channel.front() : nullptr; });
  }
  template <class T>
  void add(const std::string& path, const Reg<T>& reg) {
    add_payload<T>(path, [&reg]() -> const T* { return &reg.q(); });
  }
  /// The channels of a composite (netlist.h).
  template <class Design>
  requires requires(const Design& design) {
    design.channels([](const char*, const char*, const char*, const auto&) {});
  }
  void add(const std::string& path, const Design& design) {
    design.channels(
        [&](const char* name, const char*, const char*, const auto& channel) { add(path + "." + name, channel); });
  }

  /// Call once a cycle, after the clock's step. The header is written at the first call.
  void sample(std::uint64_t cycle);
  std::size_t signals() const { return signals_.size(); }

 private:
  struct Signal {
    std::string path;
    int width;
    std::string identifier;
    std::uint64_t last;
    bool known;
  };
  /// A group of signals that are read together: fills `values`, or clears it where there is no value.
  struct Group {
    std::size_t first_signal;
    std::size_t signal_count;
    std::function<void(std::vector<std::uint64_t>&)> read;
  };

  void add_bit(const std::string& path, std::function<bool()> read);
  void add_group(const std::vector<std::pair<std::string, int>>& signals,
                 std::function<void(std::vector<std::uint64_t>&)> read);
  bool chosen(std::string_view path) const;
  void write_header();
  void write_value(const Signal& signal);

  template <class T, class Read>
  void add_payload(const std::string& path, Read read) {
    std::vector<std::pair<std::string, int>> signals;
    for (const auto& leaf : describe_leaves<T>())
      signals.emplace_back(leaf.name.empty() ? path : path + "." + leaf.name, leaf.width);
    add_group(signals, [read](std::vector<std::uint64_t>& values) {
      if (const T* payload = read()) visit_leaves(*payload, [&](const auto& leaf) { values.push_back(leaf.raw()); });
    });
  }

  std::ostream& out_;
  const std::string scope_;
  const std::uint64_t first_cycle_;
  const std::uint64_t last_cycle_;
  std::vector<Signal> signals_;
  std::vector<Group> groups_;
  bool header_written_ = false;
};

}  // namespace cbvh::rtl
