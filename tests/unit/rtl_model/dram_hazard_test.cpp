// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "dram_bench.h"

/// The model looks a read's answer up when the read is taken. These tests show that the DRAM, given the order in which
/// lines are on its pins, would have answered the same.
namespace cbvh::rtl {
namespace {

using testing::DramBench;

/// What the write queues and the DRAM hold, word for word.
class PinReplay {
 public:
  explicit PinReplay(DramBench& bench) : bench_(bench) {
    bench.on_taken = [this](const LineRequest& request) { taken(request); };
    bench.dram.hooks.on_access = [this](const DramAccess& access) { on_pins(access); };
  }

  std::size_t reads_checked = 0;
  std::size_t reads_completed_by_the_queue = 0;  ///< partly from the pins, partly from a waiting write
  std::size_t wrong = 0;

 private:
  struct Words {
    LineWords words;
    std::uint64_t mask = 0;

    void overlay(const Words& later) {
      for (std::size_t i = 0; i < kWordsPerLine; ++i) {
        if (later.mask >> i & 1u) words[i] = later.words[i];
      }
      mask |= later.mask;
    }
  };
  struct WaitingRead {
    Words from_queue;
    LineWords wanted;
  };

  void taken(const LineRequest& request) {
    const std::uint64_t line = request.line.value();
    if (request.write) {
      waiting_writes_[line].overlay({request.words, request.mask.value()});
      return;
    }
    const auto waiting = waiting_writes_.find(line);
    const Words from_queue = waiting == waiting_writes_.end() ? Words() : waiting->second;
    const LineWords wanted = bench_.content[line];
    if (from_queue.mask == 0xFFFF) {
      check(from_queue.words, wanted);
    } else {
      reads_completed_by_the_queue += from_queue.mask != 0;
      waiting_reads_[line].push_back({from_queue, wanted});
    }
  }

  void on_pins(const DramAccess& access) {
    const std::uint64_t line = access.address / kBytesPerLine;
    if (access.write) {
      ASSERT_EQ(waiting_writes_.count(line), 1u) << "line " << line << " is written without a reason";
      dram_[line].overlay(waiting_writes_[line]);
      waiting_writes_.erase(line);
      return;
    }
    ASSERT_FALSE(waiting_reads_[line].empty()) << "line " << line << " is read without a reason";
    Words answer = dram_[line];
    answer.overlay(waiting_reads_[line].front().from_queue);
    check(answer.words, waiting_reads_[line].front().wanted);
    waiting_reads_[line].pop_front();
  }

  void check(const LineWords& found, const LineWords& wanted) {
    ++reads_checked;
    wrong += found != wanted;
  }

  DramBench& bench_;
  std::map<std::uint64_t, Words> waiting_writes_;
  std::map<std::uint64_t, std::deque<WaitingRead>> waiting_reads_;
  std::map<std::uint64_t, Words> dram_;
};

TEST(DramHazard, the_order_on_the_pins_gives_the_answers_that_the_order_of_taking_defines) {
  for (const std::uint64_t lines : {2u, 40u, 3000u}) {
    for (const auto& disturbance : testing::stall_matrix()) {
      DramBench bench({}, disturbance);
      PinReplay replay(bench);
      std::size_t reads = 0;
      for (std::size_t i = 0; i < testing::kDramPorts; ++i) {
        bench.clients[i].requests = testing::random_requests(1500, lines, 10 * lines + i, 30 + 15 * i);
        for (const LineRequest& request : bench.clients[i].requests) reads += !request.write;
      }
      ASSERT_TRUE(bench.run());
      EXPECT_EQ(replay.wrong, 0u) << lines << " lines";
      EXPECT_EQ(replay.reads_checked, reads);
      EXPECT_GT(replay.reads_completed_by_the_queue, 10u);
    }
  }
}

}  // namespace
}  // namespace cbvh::rtl
