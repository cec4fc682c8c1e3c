// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/kernel/vcd.h"

#include <algorithm>
#include <ostream>

namespace cbvh::rtl {

namespace {

/// Printable identifiers as short as VCD allows: !, ", ..., ~, !!, ...
std::string identifier_of(std::size_t index) {
  std::string identifier;
  do {
    identifier += static_cast<char>('!' + index % 94);
    index /= 94;
  } while (index > 0);
  return identifier;
}

std::vector<std::string_view> split(std::string_view path) {
  std::vector<std::string_view> parts;
  for (std::size_t dot; (dot = path.find('.')) != std::string_view::npos; path.remove_prefix(dot + 1))
    parts.push_back(path.substr(0, dot));
  parts.push_back(path);
  return parts;
}

}  // namespace

ValueChangeDump::ValueChangeDump(std::ostream& out, std::string scope, std::uint64_t first_cycle,
                                 std::uint64_t last_cycle)
    : out_(out), scope_(std::move(scope)), first_cycle_(first_cycle), last_cycle_(last_cycle) {}

bool ValueChangeDump::chosen(std::string_view path) const {
  return scope_.empty() || path == scope_ || (path.starts_with(scope_) && path[scope_.size()] == '.');
}

void ValueChangeDump::add_bit(const std::string& path, std::function<bool()> read) {
  add_group({{path, 1}}, [read = std::move(read)](std::vector<std::uint64_t>& values) { values.push_back(read()); });
}

void ValueChangeDump::add_group(const std::vector<std::pair<std::string, int>>& signals,
                                std::function<void(std::vector<std::uint64_t>&)> read) {
  if (signals.empty() || !chosen(signals.front().first)) return;
  groups_.push_back({signals_.size(), signals.size(), std::move(read)});
  for (const auto& [path, width] : signals) signals_.push_back({path, width, identifier_of(signals_.size()), 0, false});
}

void ValueChangeDump::write_header() {
  out_ << "$timescale 1ns $end\n";
  std::vector<std::string_view> open;
  for (const Signal& signal : signals_) {
    auto parts = split(signal.path);
    const auto name = parts.back();
    parts.pop_back();
    std::size_t common = 0;
    while (common < std::min(open.size(), parts.size()) && open[common] == parts[common]) ++common;
    for (; open.size() > common; open.pop_back()) out_ << "$upscope $end\n";
    for (; open.size() < parts.size(); open.push_back(parts[open.size()]))
      out_ << "$scope module " << parts[open.size()] << " $end\n";
    out_ << "$var wire " << signal.width << ' ' << signal.identifier << ' ' << name;
    if (signal.width > 1) out_ << " [" << signal.width - 1 << ":0]";
    out_ << " $end\n";
  }
  for (; !open.empty(); open.pop_back()) out_ << "$upscope $end\n";
  out_ << "$enddefinitions $end\n";
  header_written_ = true;
}

void ValueChangeDump::write_value(const Signal& signal) {
  if (signal.width == 1) {
    out_ << (signal.known ? static_cast<char>('0' + signal.last) : 'x') << signal.identifier << '\n';
    return;
  }
  out_ << 'b';
  if (signal.known) {
    for (int bit = signal.width; bit-- > 0;) out_ << static_cast<char>('0' + (signal.last >> bit & 1u));
  } else {
    out_ << 'x';
  }
  out_ << ' ' << signal.identifier << '\n';
}

void ValueChangeDump::sample(std::uint64_t cycle) {
  if (cycle < first_cycle_ || cycle > last_cycle_) return;
  const bool first = !header_written_;
  if (first) write_header();
  bool time_written = false;
  std::vector<std::uint64_t> values;
  for (const Group& group : groups_) {
    values.clear();
    group.read(values);
    for (std::size_t i = 0; i < group.signal_count; ++i) {
      Signal& signal = signals_[group.first_signal + i];
      const bool known = !values.empty();
      const std::uint64_t value = known ? values[i] : 0;
      if (!first && known == signal.known && value == signal.last) continue;
      signal.known = known;
      signal.last = value;
      if (!time_written) out_ << '#' << cycle << '\n';
      time_written = true;
      write_value(signal);
    }
  }
}

}  // namespace cbvh::rtl
