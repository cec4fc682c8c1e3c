// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram_channel.h"

#include <algorithm>
#include <bit>

namespace cbvh::rtl {
namespace {

unsigned lowest(std::uint32_t banks) { return static_cast<unsigned>(std::countr_zero(banks)); }

}  // namespace

DramChannel::DramChannel(const DramConfig& config, unsigned index, const DramHooks& hooks)
    : config_(config),
      timing_(config.timing),
      index_(index),
      hooks_(hooks),
      reads_(config.read_queue_depth, config.banks),
      writes_(config.write_queue_depth, config.banks),
      banks_(config.banks),
      refresh_period_(config.timing.refresh_interval / (config.refresh == DramRefresh::per_bank ? config.banks : 1)),
      next_refresh_(refresh_period_) {}

void DramChannel::push(bool write, const DramRequest& request) {
  (write ? writes_ : reads_).push(request, is_open(request.bank) && banks_[request.bank].row == request.row);
  wake_ = std::min(wake_, request.arrival + 1);
}

std::optional<DramReadIssued> DramChannel::step(std::uint64_t clock) {
  wake_ = kNever;
  std::optional<DramReadIssued> issued;
  if (second_burst_.clock == clock) {
    command(second_burst_.kind, second_burst_.bank, clock);
    second_burst_.clock = kNever;
  } else if (!refresh(clock)) {
    choose_direction(clock);
    DramQueue& queue = writing_ ? writes_ : reads_;
    DramQueue& other = writing_ ? reads_ : writes_;
    if (const int slot = pick_column(queue, clock); slot != DramQueue::kNone) {
      const DramReadIssued read = issue_column(queue, slot, clock);
      if (!writing_) issued = read;
    } else if (!prepare_row(queue, ~refreshing_, clock)) {
      prepare_row(other, ~refreshing_ & ~queue.busy_banks(), clock);
    }
  }
  wake_ = std::min(wake_, second_burst_.clock);
  return issued;
}

/// Has the clock come? If not, it is one to wake at.
bool DramChannel::due(std::uint64_t from, std::uint64_t clock) {
  if (from <= clock) return true;
  wake_ = std::min(wake_, from);
  return false;
}

void DramChannel::command(DramCommandKind kind, unsigned bank, std::uint64_t clock) {
  if (hooks_.on_command) hooks_.on_command({kind, index_, bank, banks_[bank].row, clock});
  wake_ = clock + 1;
}

void DramChannel::choose_direction(std::uint64_t clock) {
  const bool reads_wait = !reads_.empty();
  const bool batch_done = batch_ >= config_.batch_lines;
  bool turn = false;
  if (writing_) {
    turn = writes_.empty() || (reads_wait && (batch_done || writes_.size() <= config_.write_low));
  } else if (writes_.size() >= config_.write_high) {
    turn = batch_done || !reads_wait;
  } else if (!writes_.empty() && !reads_wait) {
    turn = due(no_read_since_ + config_.idle_clocks, clock);
  }
  if (!turn) return;
  writing_ = !writing_;
  batch_ = 0;
}

/// Those with a request for their open row that may go before all others of the bank.
std::uint32_t DramChannel::hit_banks(const DramQueue& queue) const {
  std::uint32_t banks = queue.hit_banks();
  for (std::uint32_t left = banks & overtaken_banks_; left != 0; left &= left - 1) {
    const unsigned bank = lowest(left);
    if (queue.oldest(bank) != queue.oldest_hit(bank)) banks &= ~(1u << bank);
  }
  return banks;
}

int DramChannel::pick_column(const DramQueue& queue, std::uint64_t clock) {
  int best = DramQueue::kNone;
  const std::uint32_t banks = hit_banks(queue) & ~refreshing_;
  if (banks == 0 || !due(writing_ ? write_from_ : read_from_, clock)) return best;
  for (std::uint32_t left = banks; left != 0; left &= left - 1) {
    const unsigned bank = lowest(left);
    if (!due(banks_[bank].column_from, clock)) continue;
    const int hit = queue.oldest_hit(bank);
    if (best == DramQueue::kNone || queue[hit].age < queue[best].age) best = hit;
  }
  return best;
}

/// Both bursts: the second follows after tCCD, to the clock.
DramReadIssued DramChannel::issue_column(DramQueue& queue, int slot, std::uint64_t clock) {
  const DramRequest& request = queue[slot];
  const DramReadIssued issued{request.port, request.answer, clock + timing_.line_read()};
  Bank& bank = banks_[request.bank];
  bank.overtaken += queue.oldest(request.bank) != slot;
  if (bank.overtaken >= config_.overtakes) overtaken_banks_ |= 1u << request.bank;
  const std::uint64_t second = clock + timing_.column_to_column;
  const std::uint64_t next = second + timing_.column_to_column;
  if (writing_) {
    write_from_ = next;
    read_from_ = std::max(read_from_, second + timing_.write_command_to_read());
    bank.precharge_from = std::max(bank.precharge_from, second + timing_.write_command_to_precharge());
    ++counts_.writes;
  } else {
    read_from_ = next;
    write_from_ = std::max(write_from_, second + timing_.read_command_to_write());
    bank.precharge_from = std::max(bank.precharge_from, second + timing_.read_to_precharge);
    ++counts_.reads;
  }
  ++(!request.activated ? counts_.row_hits : request.precharged ? counts_.row_conflicts : counts_.row_misses);
  counts_.turnarounds += writing_ != last_was_write_;
  last_was_write_ = writing_;
  ++batch_;

  if (hooks_.on_access) hooks_.on_access({std::uint64_t{request.line} * kBytesPerLine, writing_, clock});
  const DramCommandKind kind = writing_ ? DramCommandKind::write : DramCommandKind::read;
  second_burst_ = {second, kind, request.bank};
  command(kind, request.bank, clock);
  queue.remove(slot);
  if (!writing_ && reads_.empty()) no_read_since_ = clock;
  return issued;
}

/// The oldest request, of these banks, whose bank has to be activated or precharged first and can be now.
bool DramChannel::prepare_row(DramQueue& queue, std::uint32_t banks, std::uint64_t clock) {
  int best = DramQueue::kNone;
  banks &= queue.busy_banks() & ~hit_banks(queue);
  if ((banks & ~open_banks_) != 0 && !due(activate_from_, clock)) banks &= open_banks_;
  for (std::uint32_t left = banks; left != 0; left &= left - 1) {
    const unsigned number = lowest(left);
    const Bank& bank = banks_[number];
    if (!due(is_open(number) ? bank.precharge_from : bank.activate_from, clock)) continue;
    const int oldest = queue.oldest(number);
    if (best == DramQueue::kNone || queue[oldest].age < queue[best].age) best = oldest;
  }
  if (best == DramQueue::kNone) return false;
  DramRequest& request = queue[best];
  if (is_open(request.bank)) {
    request.precharged = true;
    precharge(request.bank, clock);
  } else {
    request.activated = true;
    activate(request.bank, request.row, clock);
  }
  return true;
}

void DramChannel::activate(unsigned number, std::uint32_t row, std::uint64_t clock) {
  Bank& bank = banks_[number];
  open_banks_ |= 1u << number;
  overtaken_banks_ &= ~(1u << number);
  bank.row = row;
  bank.overtaken = 0;
  bank.column_from = clock + timing_.activate_to_column;
  bank.precharge_from = clock + timing_.activate_to_precharge;
  bank.activate_from = clock + timing_.activate_to_activate;
  reads_.row_opened(number, row);
  writes_.row_opened(number, row);
  windows_[oldest_window_] = clock + timing_.four_activates;
  oldest_window_ = (oldest_window_ + 1) % windows_.size();
  activate_from_ = std::max(clock + timing_.other_bank_activate, windows_[oldest_window_]);
  ++counts_.activates;
  command(DramCommandKind::activate, number, clock);
}

void DramChannel::precharge(unsigned number, std::uint64_t clock) {
  command(DramCommandKind::precharge, number, clock);
  close(number, clock + timing_.precharge);
  ++counts_.precharges;
}

void DramChannel::close(unsigned number, std::uint64_t activate_from) {
  Bank& bank = banks_[number];
  open_banks_ &= ~(1u << number);
  bank.activate_from = std::max(bank.activate_from, activate_from);
  reads_.row_closed(number);
  writes_.row_closed(number);
}

/// True if it has used the command bus.
bool DramChannel::refresh(std::uint64_t clock) {
  if (!due(next_refresh_, clock)) return false;
  const bool per_bank = config_.refresh == DramRefresh::per_bank;
  refreshing_ = per_bank ? 1u << refresh_bank_ : ~0u;
  return per_bank ? refresh_next_bank(clock) : refresh_all(clock);
}

bool DramChannel::refresh_all(std::uint64_t clock) {
  const bool any_open = open_banks_ != 0;
  std::uint64_t precharge_from = 0;
  std::uint64_t refresh_from = 0;
  for (unsigned number = 0; number < banks_.size(); ++number) {
    if (is_open(number)) precharge_from = std::max(precharge_from, banks_[number].precharge_from);
    refresh_from = std::max(refresh_from, banks_[number].activate_from);
  }
  if (!due(any_open ? precharge_from : refresh_from, clock)) return false;
  const unsigned busy = any_open ? timing_.precharge_all : timing_.refresh_all;
  for (unsigned number = 0; number < banks_.size(); ++number) close(number, clock + busy);
  if (any_open) {
    ++counts_.precharges;
    command(DramCommandKind::precharge_all, 0, clock);
  } else {
    ++counts_.refreshes;
    next_refresh_ += refresh_period_;
    refreshing_ = 0;
    command(DramCommandKind::refresh, 0, clock);
  }
  return true;
}

bool DramChannel::refresh_next_bank(std::uint64_t clock) {
  Bank& bank = banks_[refresh_bank_];
  if (is_open(refresh_bank_)) {
    if (!due(bank.precharge_from, clock)) return false;
    precharge(refresh_bank_, clock);
    return true;
  }
  if (!due(std::max({bank.activate_from, activate_from_, refresh_from_}), clock)) return false;
  command(DramCommandKind::refresh_bank, refresh_bank_, clock);
  bank.activate_from = refresh_from_ = clock + timing_.refresh_bank;
  activate_from_ = std::max(activate_from_, clock + timing_.other_bank_activate);
  refresh_bank_ = (refresh_bank_ + 1) % config_.banks;
  next_refresh_ += refresh_period_;
  refreshing_ = 0;
  ++counts_.refreshes;
  return true;
}

}  // namespace cbvh::rtl
