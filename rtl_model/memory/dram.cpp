// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/memory/dram.h"

#include <bit>
#include <cassert>

namespace cbvh::rtl {
namespace {

constexpr std::uint64_t kAllWords = (1u << kWordsPerLine) - 1;
constexpr std::size_t kMostPorts = 32;

std::uint64_t divide_up(std::uint64_t dividend, std::uint64_t divisor) { return (dividend + divisor - 1) / divisor; }

}  // namespace

Dram::Dram(const DramConfig& config, const std::vector<LinePort>& ports)
    : store(config.capacity_bytes / kBytesPerLine), config_(config), map_(config), random_(config.seed) {
  assert(!config.check() && ports.size() <= kMostPorts);
  for (unsigned i = 0; i < config_.channels; ++i) lanes_.push_back({DramChannel(config_, i, hooks), {}, {}, {}});
  for (const LinePort& link : ports) ports_.push_back({link, std::vector<Answer>(config_.outstanding), 0, 0, {}});
}

void Dram::step(DramChannel& channel) {
  if (const auto issued = channel.step(clock_)) {
    Port& port = ports_[issued->port];
    Answer& answer = port.answers[issued->answer];
    make_ready(port, answer, cycle_of(issued->data_end));
  }
}

void Dram::make_ready(Port& port, Answer& answer, std::uint64_t cycle) {
  answer.ready_cycle =
      cycle + config_.answer_latency + (config_.jitter == 0 ? 0 : random_.below(std::uint64_t{config_.jitter} + 1));
  if (answer.read) port.counts.read_cycles += answer.ready_cycle - answer.taken_cycle;
}

/// The core cycle in which a clock of the command bus happens.
std::uint64_t Dram::cycle_of(std::uint64_t clock) const {
  return divide_up(clock * config_.core_clock_mhz, config_.timing.clock_mhz);
}

void Dram::give(Port& port) {
  if (++answers_given_ != config_.lose_answer) port.link.answers->push(port.answers[port.head].data);
  port.head = port.head + 1 == config_.outstanding ? 0 : port.head + 1;
  --port.size;
}

void Dram::take_requests() {
  bool any = false;
  for (unsigned index = 0; index < ports_.size(); ++index) {
    const Port& port = ports_[index];
    if (!port.link.requests->can_pop()) continue;
    const LineRequest& request = port.link.requests->front();
    const bool write = bool(request.write);
    if ((!write || request.acknowledge) && port.size == config_.outstanding) continue;
    if (request.line.value() >= store.capacity_lines()) {
      refuse(index);
      continue;
    }
    Lane& lane = lanes_[map_.channel(request.line.value())];
    if ((write ? lane.channel.writes() : lane.channel.reads()).full()) continue;
    lane.wanting[write] |= 1u << index;
    any = true;
  }
  if (!any) return;
  for (Lane& lane : lanes_) {
    if (lane.wanting[0] != 0) take_one(lane, false);
    if (lane.wanting[1] != 0) take_one(lane, true);
  }
}

/// The first that can be taken, beginning with the port whose turn it is.
void Dram::take_one(Lane& lane, bool write) {
  const std::uint32_t before = (1u << lane.next_port[write]) - 1;
  for (std::uint32_t part : {lane.wanting[write] & ~before, lane.wanting[write] & before}) {
    for (; part != 0; part &= part - 1) {
      const auto index = static_cast<unsigned>(std::countr_zero(part));
      if (!take(index, lane)) continue;
      lane.next_port[write] = (index + 1) % kMostPorts;
      lane.wanting[write] = 0;
      return;
    }
  }
  lane.wanting[write] = 0;
}

bool Dram::take(unsigned index, Lane& lane) {
  Port& port = ports_[index];
  const LineRequest& request = port.link.requests->front();
  const DramPlace place = map_.place(request.line.value());
  return bool(request.write) ? take_write(port, place, lane) : take_read(port, index, place, lane);
}

bool Dram::take_write(Port& port, const DramPlace& place, Lane& lane) {
  const LineRequest& request = port.link.requests->front();
  const auto line = static_cast<std::uint32_t>(request.line.value());
  if (lane.channel.reads().find(place.bank, line) != DramQueue::kNone) {
    if (!lane.awaited) lane.awaited = line;
    return false;
  }
  const DramQueue& writes = lane.channel.writes();
  const int waiting = writes.find(place.bank, line);
  if (lane.awaited == line) lane.awaited.reset();
  if (waiting != DramQueue::kNone) {
    lane.channel.merge(waiting, request.mask);
    ++merged_writes_;
  } else {
    DramRequest entry = request_for(line, place);
    entry.mask = request.mask;
    lane.channel.push(true, entry);
  }
  ++port.counts.writes;
  store.write(request);
  if (request.acknowledge) make_ready(port, new_answer(port, false), cycle_);
  port.link.requests->pop();
  return true;
}

bool Dram::take_read(Port& port, unsigned index, const DramPlace& place, Lane& lane) {
  const LineRequest& request = port.link.requests->front();
  const auto line = static_cast<std::uint32_t>(request.line.value());
  if (lane.awaited == line) return false;
  const DramQueue& writes = lane.channel.writes();
  const int waiting = writes.find(place.bank, line);
  const bool forwarded = waiting != DramQueue::kNone && writes[waiting].mask.value() == kAllWords;
  Answer& answer = new_answer(port, true);
  answer.data = store.read(request.line);
  if (forwarded) {
    ++forwarded_reads_;
    make_ready(port, answer, cycle_);
  } else {
    DramRequest entry = request_for(line, place);
    entry.port = static_cast<std::uint8_t>(index);
    entry.answer = static_cast<std::uint16_t>(&answer - port.answers.data());
    lane.channel.push(false, entry);
  }
  ++port.counts.reads;
  port.link.requests->pop();
  return true;
}

DramRequest Dram::request_for(std::uint32_t line, const DramPlace& place) {
  DramRequest entry;
  entry.line = line;
  entry.row = place.row;
  entry.bank = static_cast<std::uint8_t>(place.bank);
  entry.age = age_++;
  entry.arrival = clock_;
  return entry;
}

/// The next place in the port's reorder buffer.
Dram::Answer& Dram::new_answer(Port& port, bool read) {
  const unsigned place = port.head + port.size++;
  Answer& answer = port.answers[place < config_.outstanding ? place : place - config_.outstanding];
  answer.taken_cycle = cycle_;
  answer.ready_cycle = kPending;
  answer.read = read;
  if (!read) answer.data = LineData();
  return answer;
}

/// Beyond the capacity: answered with zeros, without a trace on the pins.
void Dram::refuse(unsigned index) {
  Port& port = ports_[index];
  const LineRequest& request = port.link.requests->pop();
  if (!error_) {
    error_ = "DRAM port " + std::to_string(index) + (request.write ? " writes" : " reads") + " byte " +
             std::to_string(request.line.value() * kBytesPerLine) + ", capacity " +
             std::to_string(config_.capacity_bytes) + " bytes";
  }
  const LineData zeros = store.read(request.line);  // remembers it, too
  if (request.write && !request.acknowledge) return;
  Answer& answer = new_answer(port, false);
  answer.data = zeros;
  make_ready(port, answer, cycle_);
}

bool Dram::idle() const {
  for (const Port& port : ports_) {
    if (port.size > 0 || port.link.requests->can_pop()) return false;
  }
  for (const Lane& lane : lanes_) {
    if (!lane.channel.idle()) return false;
  }
  return true;
}

DramCounts Dram::counts() const {
  DramCounts sum;
  for (const Lane& lane : lanes_) sum += lane.channel.counts();
  return sum;
}

std::uint64_t Dram::bound_cycles() const {
  const DramCounts sum = counts();
  return config_.cycles_at_peak((sum.reads + sum.writes) * kBytesPerLine);
}

}  // namespace cbvh::rtl
