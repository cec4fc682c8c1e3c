// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cassert>
#include <vector>

#include "rtl_model/bits/machine_bits.h"
#include "rtl_model/datapath/refit_payloads.h"
#include "rtl_model/memory/line_reads.h"

namespace cbvh::rtl {

struct GathererConfig {
  std::size_t held_lines = 128;  ///< a power of two
  std::size_t outstanding = 16;  ///< reads in flight
  std::size_t queue = 64;        ///< accesses between the tags and the lines: what hides the memory's latency
};

/// Fetches primitives by number: ten words from word 10 * ID of the array on, in one line or two. Lines stay in a
/// direct-mapped store, so that neighbours share reads. Its tags are looked up when an ID arrives, and reads go out at
/// once; the access then queues, and a line enters the store when the access that asked for it comes out. So the store
/// changes in the order of the IDs however late memory answers: a prefetching texture cache (Igehy et al. 1998).
/// A command gives the array and how many primitives it has, then IDs follow up to the one marked last. Each gives a
/// primitive and its mark; an ID out of range gives zeros, and no access. A line access a clock: 1.5 clocks a primitive
/// on average; the first primitive comes 2 clocks after its ID was taken and the memory's latency.
/// Memory: per held line a 27-bit tag and 512 bits of data, one entry read and written a clock, each; `outstanding`
/// lines. Paper section 5.2: refitting reads 40 bytes a primitive.
template <class Bits>
class PrimitiveGatherer {
 public:
  PrimitiveGatherer(Channel<ReadCommand>& commands, Channel<IdEntry>& ids, LinePort memory,
                    Channel<Primitive>& primitives, Channel<LeafMark>& marks, const GathererConfig& config = {})
      : commands_(commands),
        ids_(ids),
        primitives_(primitives),
        marks_(marks),
        tags_(config.held_lines, kNoLine),
        lines_(config.held_lines),
        accesses_(config.queue),
        reads_(memory, config.outstanding) {
    assert(std::has_single_bit(config.held_lines));
  }

  void tick() {
    reads_.take_answer();
    deliver();
    if (!running_) {
      if (!commands_.can_pop()) return;
      command_ = commands_.pop();
      running_ = true;
      std::fill(tags_.begin(), tags_.end(), kNoLine);  // another array, or this one changed
    } else if (ids_.can_pop()) {
      look_up(ids_.front());
    }
  }
  void commit(CommitKey) {}

  std::uint64_t lines_read = 0;    ///< 64-byte accesses so far
  std::uint64_t lines_shared = 0;  ///< accesses that found their line

 private:
  static constexpr std::uint64_t kNoLine = ~std::uint64_t{0};
  enum class Part { whole, first, second };
  struct Access {
    std::size_t entry = 0;  ///< of the store
    bool miss = false;
    bool in_range = false;
    Part part = Part::whole;
    std::size_t offset = 0;  ///< the primitive's first word in its first line
    IdEntry id;
  };

  void look_up(const IdEntry& id) {
    if (accesses_.free() == 0) return;
    const bool in_range = id.id.value() < command_.items.value();
    const UInt<31> word = truncate<31>(concat(id.id, UInt<3>()) + concat(id.id, UInt<1>()));  // 10 * ID
    const std::size_t offset = bits<3, 0>(word).value();
    const bool two_lines = in_range && offset + kWordsPerPrimitive > kWordsPerLine;
    const std::uint64_t line = bits<30, 4>(word).value() + second_;
    Access access{line & (tags_.size() - 1),
                  in_range && tags_[line & (tags_.size() - 1)] != line,
                  in_range,
                  !two_lines ? Part::whole
                  : second_  ? Part::second
                             : Part::first,
                  offset,
                  id};
    if (taken<Bits>(Corner::gatherer_misses, access.miss)) {
      if (!reads_.can_request()) return;
      reads_.request(truncate<kLineAddressBits>(command_.first_line + LineAddress(line)));
      tags_[access.entry] = line;
      ++lines_read;
    } else {
      lines_shared += in_range;
    }
    accesses_.push() = access;
    second_ = access.part == Part::first;
    if (second_) return;
    if (ids_.pop().last) running_ = false;
  }

  void deliver() {
    if (accesses_.empty()) return;
    const Access& access = accesses_.front();
    if (access.miss && !reads_.has_line()) return;
    if (access.part != Part::first && !(primitives_.can_push() && marks_.can_push())) return;
    LineWords& line = lines_[access.entry];
    if (access.miss) {
      line = reads_.line();
      reads_.drop_line();
    }
    if (access.part == Part::first) {
      first_line_ = line;
    } else {
      primitives_.push(primitive_of(access, line));
      marks_.push({access.id.last_of_leaf, access.id.last, UInt<1>(access.in_range)});
    }
    accesses_.pop();
  }

  Primitive primitive_of(const Access& access, const LineWords& line) const {
    Primitive primitive;
    primitive.id = access.id.id;
    primitive.last = access.id.last;
    if (!access.in_range) return primitive;
    const LineWords& begin = access.part == Part::second ? first_line_ : line;
    for (std::size_t i = 0; i < 9; ++i) {
      const std::size_t word = access.offset + i;
      const auto& from = word < kWordsPerLine ? begin[word] : line[word - kWordsPerLine];
      primitive.vertex[i / 3][i % 3] = Float32::of_raw(from.raw());
    }
    return primitive;
  }

  Channel<ReadCommand>& commands_;
  Channel<IdEntry>& ids_;
  Channel<Primitive>& primitives_;
  Channel<LeafMark>& marks_;
  ReadCommand command_;
  std::vector<std::uint64_t> tags_;
  std::vector<LineWords> lines_;
  Fifo<Access> accesses_;
  LineReads reads_;
  LineWords first_line_{};  ///< of a primitive in two lines
  bool running_ = false;
  bool second_ = false;  ///< the next access is for a primitive's second line
};

}  // namespace cbvh::rtl
