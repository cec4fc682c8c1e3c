// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <vector>

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/node_words.h"
#include "rtl_model/kernel/channel.h"
#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {

struct NodeWriterConfig {
  LineAddress first_line;        ///< where pair 0 lies in memory
  std::size_t held_lines = 128;  ///< a power of two
};

/// Between the stream compressor's memory port and a 64-byte port: packs and unpacks pairs, and combines writes. Final
/// pairs of treelets leave out of emission order, so lines arrive in parts; a line is held here until it is complete,
/// until another line with the same low address bits needs its place, or until the tree ends. A read wants one pair. If
/// that is held, the answer comes from here and costs no access, and the repair's write then merges; if not, memory has
/// it, whatever else of its line is held.
/// Takes a request a clock; one before a read from memory waits a clock longer. At the report it looks at one held line
/// a clock, asks for an acknowledgement with the last write, and passes the report on when that is back: then every
/// later read at any port sees the tree. Of a refused tree it drops what it holds.
/// Memory: per held line 512 bits of pairs, a 25-bit tag and a 4-bit mask, direct mapped: one entry read, one tag
/// compared and one entry written a clock; 8.5 KiB for 128 lines. Paper section 5.3 (write-combining output).
template <class Bits, int N>
class NodeWriter {
  static_assert(N <= kMostPackedBits);

 public:
  static constexpr std::size_t kReads = 4;  ///< in flight

  NodeWriter(Channel<MemoryRequest<N>>& requests, Channel<MemoryLine<N>>& lines, Channel<StreamReport>& reports,
             LinePort memory, Channel<StreamReport>& finished, const NodeWriterConfig& config)
      : requests_(requests),
        lines_(lines),
        reports_(reports),
        memory_(memory),
        finished_(finished),
        first_line_(config.first_line),
        held_(config.held_lines) {
    assert(std::has_single_bit(config.held_lines));
  }

  void tick() {
    port_free_ = memory_.requests->can_push();
    lines_free_ = lines_.can_push();
    const bool awaits_read = reads_in_flight_ > 0;
    if (awaits_read) take_read_answer();
    switch (state_) {
      case State::combining:
        combine();
        return;
      case State::flushing:
        flush_one();
        return;
      case State::last_write:
        write_last();
        return;
      case State::acknowledged:
        if (awaits_read || !memory_.answers->can_pop() || !finished_.can_push()) return;
        memory_.answers->pop();
        finish();
        return;
    }
  }
  void commit(CommitKey) {}

  std::uint64_t lines_written = 0;  ///< 64-byte accesses so far
  std::uint64_t lines_read = 0;

 private:
  enum class State { combining, flushing, last_write, acknowledged };
  using Line = MemoryRequest<N>;  ///< a line in parts; nothing when its mask is zero

  static bool empty(const Line& line) { return line.mask.raw() == 0; }
  static bool complete(const Line& line) { return line.mask.raw() == low_mask(kPairsPerLine); }
  /// `newer` over `line`; both are parts of the same line.
  static void lay_over(Line& line, const Line& newer) {
    line.write = newer.write;
    line.line = newer.line;
    line.mask = line.mask | newer.mask;
    for (std::size_t slot = 0; slot < kPairsPerLine; ++slot) {
      if (newer.mask.raw() >> slot & 1u) line.pairs[slot] = newer.pairs[slot];
    }
  }

  void combine() {
    if (reports_.can_pop() && !ending_) {
      ending_ = true;
      requests_before_end_ = requests_.pushes() - requests_.pops();  // 0..2: what waits in the channel
    }
    if (ending_ && requests_before_end_ == 0) {
      report_ = reports_.pop();
      next_flushed_ = 0;
      state_ = State::flushing;
    } else if (requests_.can_pop() && take(requests_.front())) {
      requests_.pop();
      if (ending_) --requests_before_end_;
    }
  }

  /// Whether the request could be served.
  bool take(const MemoryRequest<N>& request) {
    Line& held = held_[request.line.raw() & (held_.size() - 1)];
    const bool hit = !empty(held) && held.line == request.line;
    return request.write ? write(request, held, hit) : read(request, held, hit);
  }

  bool write(const MemoryRequest<N>& request, Line& held, bool hit) {
    if (!hit && complete(request)) return send(request);
    const bool evicts = taken<Bits>(Corner::writer_evicts, !hit && !empty(held));
    if (evicts && !send(held)) return false;
    Line merged = hit ? held : Line();
    lay_over(merged, request);
    if (taken<Bits>(Corner::writer_completes, complete(merged))) {
      if (!send(merged)) return false;
      held = {};
    } else {
      held = merged;
    }
    return true;
  }

  bool read(const MemoryRequest<N>& request, const Line& held, bool hit) {
    if (taken<Bits>(Corner::writer_forwards, hit && (request.mask.raw() & ~held.mask.raw()) == 0)) {
      if (reads_in_flight_ > 0 || !lines_free_) return false;
      lines_.push({held.pairs});
      return true;
    }
    if (!port_free_ || reads_in_flight_ == kReads) return false;
    if (!empty(leaving_)) {
      push_leaving(false);
      return false;
    }
    LineRequest wanted;
    wanted.line = truncate<kLineAddressBits>(first_line_ + request.line);
    memory_.requests->push(wanted);
    ++lines_read;
    ++reads_in_flight_;
    return true;
  }

  void take_read_answer() {
    if (!memory_.answers->can_pop() || !lines_free_) return;
    lines_.push(unpack_line<N>(memory_.answers->pop().words));
    --reads_in_flight_;
    lines_free_ = false;
  }

  /// Lets a line go. The newest to go waits until the next one goes, so that the last can ask for an acknowledgement.
  bool send(const Line& line) {
    if (!empty(leaving_)) {
      if (!port_free_) return false;
      push_leaving(false);
    }
    leaving_ = line;
    return true;
  }
  void push_leaving(bool acknowledge) {
    LineRequest request = pack_write(leaving_, first_line_);
    request.acknowledge = UInt<1>(acknowledge);
    memory_.requests->push(request);
    port_free_ = false;
    leaving_ = {};
    ++lines_written;
  }

  void flush_one() {
    Line& held = held_[next_flushed_];
    if (!refused() && !empty(held) && !send(held)) return;
    held = {};
    if (++next_flushed_ == held_.size()) state_ = State::last_write;
  }
  void write_last() {
    if (refused() || empty(leaving_)) {
      if (finished_.can_push()) finish();
    } else if (port_free_) {
      push_leaving(true);
      state_ = State::acknowledged;
    }
  }
  void finish() {
    finished_.push(report_);
    leaving_ = {};
    ending_ = false;
    state_ = State::combining;
  }
  bool refused() const { return report_.status != StatusBits(); }

  Channel<MemoryRequest<N>>& requests_;
  Channel<MemoryLine<N>>& lines_;
  Channel<StreamReport>& reports_;
  const LinePort memory_;
  Channel<StreamReport>& finished_;
  const LineAddress first_line_;
  std::vector<Line> held_;  ///< by the low bits of the line's number
  Line leaving_;            ///< the newest line to go
  StreamReport report_;
  State state_ = State::combining;
  std::size_t reads_in_flight_ = 0;
  std::size_t next_flushed_ = 0;
  std::uint64_t requests_before_end_ = 0;
  bool ending_ = false;
  bool port_free_ = false;
  bool lines_free_ = false;
};

}  // namespace cbvh::rtl
