// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rtl_model/kernel/clock.h"
#include "rtl_model/memory/dram.h"
#include "tests/support/unit_run.h"

/// A Dram with four clients that ask for what they are given, and a plain map that knows what they must get.
namespace cbvh::testing {

constexpr std::size_t kDramPorts = 4;

inline rtl::LineRequest read_request(std::uint64_t line) {
  rtl::LineRequest request;
  request.line = rtl::LineAddress(line);
  return request;
}

inline rtl::LineRequest write_request(std::uint64_t line, std::uint32_t first_word, std::uint64_t mask = 0xFFFF,
                                      bool acknowledge = false) {
  rtl::LineRequest request;
  request.write = rtl::UInt<1>(1);
  request.acknowledge = rtl::UInt<1>(acknowledge);
  request.line = rtl::LineAddress(line);
  request.mask = rtl::UInt<16>(mask);
  for (std::uint32_t i = 0; i < rtl::kWordsPerLine; ++i)
    request.words[i] = rtl::UInt<32>((first_word + i) & 0xFFFFFFFF);
  return request;
}

/// One client: its requests in order, at most `window` reads at a time.
struct DramClient {
  std::vector<rtl::LineRequest> requests;
  std::size_t window = 1000;
  std::size_t sent = 0;
  std::size_t wanted = 0;  ///< answers to what was sent
  std::vector<rtl::LineData> answers;
  std::vector<std::uint64_t> answer_cycles;
  std::uint64_t longest_wait = 0;  ///< of a request at the head of its channel

  bool done() const { return sent == requests.size() && answers.size() == wanted; }
};

class DramBench {
 public:
  explicit DramBench(const rtl::DramConfig& config = {}, const Disturbance& disturbance = {})
      : dram(config, links()), disturbance_(disturbance), order_(disturbance.seed) {
    for (std::uint64_t i = 0; i < kDramPorts; ++i) {
      sources_.push_back(disturbance.source_stalls ? rtl::StallPattern::bursts(disturbance.seed + 100 + i)
                                                   : rtl::StallPattern::never());
      sinks_.push_back(disturbance.sink_stalls ? rtl::StallPattern::bursts(disturbance.seed + 200 + i)
                                               : rtl::StallPattern::never());
    }
  }

  void step() {
    for (std::size_t i = 0; i < kDramPorts; ++i) drive(i);
    std::array<std::optional<rtl::LineRequest>, kDramPorts> heads;
    std::array<std::uint64_t, kDramPorts> pops{};
    for (std::size_t i = 0; i < kDramPorts; ++i) {
      pops[i] = requests_[i].pops();
      if (requests_[i].can_pop()) heads[i] = requests_[i].front();
    }
    disturbance_.shuffled_order ? clock_.step_shuffled(order_) : clock_.step();
    // Reads are taken before writes, and of either only one of the same line in a cycle.
    for (const bool write : {false, true}) {
      for (std::size_t i = 0; i < kDramPorts; ++i) {
        if (!heads[i] || bool(heads[i]->write) != write) continue;
        const bool taken = requests_[i].pops() != pops[i];
        waits_[i] = taken ? 0 : waits_[i] + 1;
        clients[i].longest_wait = std::max(clients[i].longest_wait, waits_[i]);
        if (!taken) continue;
        account(i, *heads[i]);
        if (on_taken) on_taken(*heads[i]);
      }
    }
  }

  /// Until all clients are done and the memory is idle; false if that takes too long.
  bool run(std::uint64_t deadline = 10'000'000) {
    const auto done = [](const DramClient& client) { return client.done(); };
    while (!std::all_of(clients.begin(), clients.end(), done) || !dram.idle()) {
      if (clock_.cycle() > deadline) return false;
      step();
    }
    return true;
  }
  double statistic(const std::string& name) const {
    for (const rtl::DramStatistic& statistic : dram.statistics()) {
      if (statistic.name == name) return statistic.value;
    }
    ADD_FAILURE() << "no statistic " << name;
    return 0;
  }
  /// Cycles so far over those that the lines on the pins need at the least.
  double times_bound() const { return static_cast<double>(clock_.cycle()) / static_cast<double>(dram.bound_cycles()); }

  rtl::Dram dram;
  std::array<DramClient, kDramPorts> clients;
  std::array<std::vector<rtl::LineData>, kDramPorts> expected;  ///< by the order in which requests were taken
  std::map<std::uint64_t, rtl::LineWords> content;
  std::function<void(const rtl::LineRequest&)> on_taken;  ///< after what happened on the pins in the same cycle

 private:
  std::vector<rtl::LinePort> links() {
    std::vector<rtl::LinePort> result;
    for (std::size_t i = 0; i < kDramPorts; ++i) result.push_back({&requests_[i], &answers_[i]});
    return result;
  }

  void drive(std::size_t i) {
    DramClient& client = clients[i];
    const bool source_stalls = sources_[i].stalls();
    if (!source_stalls && client.sent < client.requests.size() && requests_[i].can_push() &&
        client.wanted - client.answers.size() < client.window) {
      const rtl::LineRequest& request = client.requests[client.sent++];
      client.wanted += !request.write || request.acknowledge;
      requests_[i].push(request);
    }
    if (!sinks_[i].stalls() && answers_[i].can_pop()) {
      client.answers.push_back(answers_[i].pop());
      client.answer_cycles.push_back(clock_.cycle());
    }
  }

  void account(std::size_t i, const rtl::LineRequest& request) {
    if (!request.write) {
      expected[i].push_back({content[request.line.value()]});
      return;
    }
    if (request.acknowledge) expected[i].push_back({});
    for (std::size_t word = 0; word < rtl::kWordsPerLine; ++word) {
      if (request.mask.value() >> word & 1u) content[request.line.value()][word] = request.words[word];
    }
  }

  std::array<rtl::Channel<rtl::LineRequest>, kDramPorts> requests_;
  std::array<rtl::Channel<rtl::LineData>, kDramPorts> answers_;
  const Disturbance disturbance_;
  rtl::SplitMix64 order_;
  std::vector<rtl::StallPattern> sources_;
  std::vector<rtl::StallPattern> sinks_;
  std::array<std::uint64_t, kDramPorts> waits_{};
  rtl::Clock<rtl::Dram, rtl::Channel<rtl::LineRequest>, rtl::Channel<rtl::LineRequest>, rtl::Channel<rtl::LineRequest>,
             rtl::Channel<rtl::LineRequest>, rtl::Channel<rtl::LineData>, rtl::Channel<rtl::LineData>,
             rtl::Channel<rtl::LineData>, rtl::Channel<rtl::LineData>>
      clock_{dram,        requests_[0], requests_[1], requests_[2], requests_[3],
             answers_[0], answers_[1],  answers_[2],  answers_[3]};
};

/// Reads and writes of random lines below `lines`, some of them masked, some acknowledged.
inline std::vector<rtl::LineRequest> random_requests(std::size_t count, std::uint64_t lines, std::uint64_t seed,
                                                     std::uint64_t writes_in_100 = 50) {
  rtl::SplitMix64 random(seed);
  std::vector<rtl::LineRequest> requests;
  std::uint64_t line = 0;
  for (std::size_t i = 0; i < count; ++i) {
    line = random.below(3) == 0 ? (line + 1) % lines : random.below(lines);
    if (random.below(100) >= writes_in_100) {
      requests.push_back(read_request(line));
    } else {
      requests.push_back(write_request(line, static_cast<std::uint32_t>(random.next()),
                                       random.below(2) == 0 ? 0xFFFF : random.below(0x10000), random.below(4) == 0));
    }
  }
  return requests;
}

}  // namespace cbvh::testing
