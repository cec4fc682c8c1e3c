// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rtl_model/memory/dram_trace.h"

/// Watches a DRAM's commands and knows from the standard what may follow what. It shares no number with the model:
/// those below are JESD209-3's, of a 4 Gb LPDDR3-1600 die, in clocks of 1.25 ns (tDQSCK as Ramulator has it).
namespace cbvh::testing {

class DramCommandChecker {
 public:
  using Kind = rtl::DramCommandKind;

  explicit DramCommandChecker(unsigned banks = 8) : bank_count_(banks) {}

  void operator()(const rtl::DramCommand& command) {
    Channel& channel = channels_[command.channel];
    if (channel.banks.empty()) channel.banks.resize(bank_count_);
    now_ = static_cast<long>(command.clock);
    where_ = "channel " + std::to_string(command.channel) + " bank " + std::to_string(command.bank) + " clock " +
             std::to_string(command.clock);
    after("command bus", channel.last_command, 1);
    channel.last_command = now_;
    ++counts[command.kind];
    switch (command.kind) {
      case Kind::activate:
        return activate(channel, command);
      case Kind::precharge:
        return precharge(channel, channel.banks.at(command.bank));
      case Kind::precharge_all:
        return precharge_all(channel);
      case Kind::read:
        return read(channel, command);
      case Kind::write:
        return write(channel, command);
      case Kind::refresh:
        return refresh(channel);
      case Kind::refresh_bank:
        return refresh_bank(channel, command);
    }
  }

  std::map<std::string, std::size_t> violations;  ///< by rule
  std::string first_violation;
  std::map<Kind, std::size_t> counts;
  std::size_t turnarounds = 0;  ///< of the data buses
  std::size_t checks = 0;
  std::map<std::string, long> closest;  ///< by rule: the least clocks by which it was kept

 private:
  static constexpr long kLongAgo = -1'000'000;
  struct Bank {
    bool open = false;
    std::uint32_t row = 0;
    long activated = kLongAgo;
    long precharged = kLongAgo;
    long read = kLongAgo;
    long written = kLongAgo;
    long refreshed = kLongAgo;
  };
  struct Channel {
    std::vector<Bank> banks;
    std::vector<long> activates = {kLongAgo, kLongAgo, kLongAgo, kLongAgo};
    long last_command = kLongAgo;
    long read = kLongAgo;
    long written = kLongAgo;
    long precharged_all = kLongAgo;
    long precharged = kLongAgo;
    long refreshed = kLongAgo;
    long refreshed_bank = kLongAgo;
    long data_until = 0;
    std::size_t refreshes = 0;
    std::size_t banks_refreshed = 0;
    bool wrote = false;  ///< the last burst
  };

  void violate(const std::string& rule) {
    if (violations[rule]++ == 0 && first_violation.empty()) first_violation = rule + " at " + where_;
  }
  void that(const std::string& rule, bool holds) {
    ++checks;
    if (!holds) violate(rule);
  }
  void after(const std::string& rule, long event, long clocks) {
    ++checks;
    const long spare = now_ - event - clocks;
    if (spare < 0) violate(rule);
    const auto [entry, fresh] = closest.try_emplace(rule, spare);
    if (!fresh && spare < entry->second) entry->second = spare;
  }

  void activate(Channel& channel, const rtl::DramCommand& command) {
    Bank& bank = channel.banks.at(command.bank);
    that("activate of an open bank", !bank.open);
    after("tRC", bank.activated, 48);
    after("tRPpb", bank.precharged, 15);
    after("tRPab", channel.precharged_all, 17);
    after("tRFCab", channel.refreshed, 104);
    after("tRFCpb", bank.refreshed, 48);
    after("tRRD", channel.activates.back(), 8);
    after("tRRD from a bank's refresh", channel.refreshed_bank, 8);
    after("tFAW", channel.activates[channel.activates.size() - 4], 40);
    channel.activates.push_back(now_);
    bank.open = true;
    bank.row = command.row;
    bank.activated = now_;
  }
  void precharge(Channel& channel, Bank& bank) {
    that("precharge of a closed bank", bank.open);
    may_close(bank);
    bank.open = false;
    bank.precharged = channel.precharged = now_;
  }
  void precharge_all(Channel& channel) {
    for (Bank& bank : channel.banks) {
      if (bank.open) may_close(bank);
      bank.open = false;
    }
    channel.precharged_all = now_;
  }
  void may_close(const Bank& bank) {
    after("tRAS", bank.activated, 34);
    after("tRTP", bank.read, 6);
    after("tWR", bank.written, 6 + 1 + 4 + 12);
  }
  void read(Channel& channel, const rtl::DramCommand& command) {
    Bank& bank = column(channel, command);
    after("tCCD of reads", channel.read, 4);
    after("tWTR", channel.written, 6 + 1 + 4 + 6);
    moves_data(channel, now_ + 12 + 2, false);
    bank.read = channel.read = now_;
  }
  void write(Channel& channel, const rtl::DramCommand& command) {
    Bank& bank = column(channel, command);
    after("tCCD of writes", channel.written, 4);
    after("read to write", channel.read, 12 + 2 + 4 + 1 - 6);
    moves_data(channel, now_ + 6 + 1, true);
    bank.written = channel.written = now_;
  }
  Bank& column(Channel& channel, const rtl::DramCommand& command) {
    Bank& bank = channel.banks.at(command.bank);
    that("column in an open row", bank.open && bank.row == command.row);
    after("tRCD", bank.activated, 15);
    return bank;
  }
  void moves_data(Channel& channel, long from, bool write) {
    that("one burst on the data bus at a time", from >= channel.data_until);
    channel.data_until = from + 4;
    turnarounds += write != channel.wrote;
    channel.wrote = write;
  }
  void refresh(Channel& channel) {
    for (const Bank& bank : channel.banks) that("refresh of an open bank", !bank.open);
    after("tRPab to refresh", channel.precharged_all, 17);
    after("tRPpb to refresh", channel.precharged, 15);
    after("tRFCab", channel.refreshed, 104);
    that("tREFI", now_ <= (static_cast<long>(++channel.refreshes) + 1) * 3120);
    channel.refreshed = now_;
  }
  void refresh_bank(Channel& channel, const rtl::DramCommand& command) {
    Bank& bank = channel.banks.at(command.bank);
    that("refresh of an open bank", !bank.open);
    that("banks are refreshed in turn", command.bank == channel.banks_refreshed++ % bank_count_);
    after("tRPpb to refresh", bank.precharged, 15);
    after("tRPab to refresh", channel.precharged_all, 17);
    after("tRFCpb", channel.refreshed_bank, 48);
    after("tRRD to a bank's refresh", channel.activates.back(), 8);
    that("tREFI of a bank", now_ <= (static_cast<long>(channel.banks_refreshed) + 1) * 3120 / bank_count_ + 400);
    bank.refreshed = channel.refreshed_bank = now_;
  }

  const unsigned bank_count_;
  std::map<unsigned, Channel> channels_;
  long now_ = 0;
  std::string where_;
};

}  // namespace cbvh::testing
