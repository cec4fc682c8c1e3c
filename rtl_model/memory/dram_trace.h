// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>

/// What a Dram does on its pins, for those who watch.
namespace cbvh::rtl {

enum class DramCommandKind { activate, precharge, precharge_all, read, write, refresh, refresh_bank };

/// One command of one burst.
struct DramCommand {
  DramCommandKind kind;
  unsigned channel;
  unsigned bank;      ///< not of precharge_all and refresh
  std::uint32_t row;  ///< the open one, except of precharge_all and the refreshes
  std::uint64_t clock;
};

/// One line on its way: at the first of its two bursts.
struct DramAccess {
  std::uint64_t address;  ///< in bytes
  bool write;
  std::uint64_t clock;
};

/// Called when set; nothing otherwise.
struct DramHooks {
  std::function<void(const DramCommand&)> on_command;
  std::function<void(const DramAccess&)> on_access;
};

/// The access as a line of Ramulator's DRAM traces, without its end: 0x1f40 R
std::string dram_trace_line(const DramAccess& access);

}  // namespace cbvh::rtl
