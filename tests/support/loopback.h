// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>

#include "fpga/host/link_error.h"
#include "fpga/host/transport.h"
#include "tests/support/fake_board.h"
#include "vectors/random.h"

namespace cbvh::testing {

enum class Fault { drop, corrupt, cut, duplicate, reorder, delay, noise, refuse_send, power_cycle, disconnect };
constexpr std::size_t kFaults = 10;
constexpr std::array<const char*, kFaults> kFaultNames = {
    "drop", "corrupt", "cut", "duplicate", "reorder", "delay", "noise", "refuse_send", "power_cycle", "disconnect"};

/// A transport to a board in memory, which does things to the transfers. Its time passes only while it waits.
class Loopback final : public host::Transport {
 public:
  Loopback(FakeBoard& board, std::uint64_t seed) : board_(board), random_(seed) {}

  /// In per mille of the transfers of both directions.
  std::array<unsigned, kFaults> rates{};
  std::array<std::uint64_t, kFaults> happened{};
  bool comes_back = true;
  /// See every transfer before it is on its way, and may change it; an empty one is lost.
  std::function<void(host::Bytes&)> to_board;
  std::function<void(host::Bytes&)> to_host;

  std::string device() const override { return "loopback"; }

  bool send(host::Bytes bytes, host::Milliseconds timeout) override {
    check_there();
    now_ += std::chrono::microseconds(10);
    if (happens(Fault::refuse_send)) {
      now_ += timeout;
      return false;
    }
    if (happens(Fault::power_cycle)) board_.power_cycle();
    pass(to_board_, std::move(bytes));
    for (; !to_board_.empty() && to_board_.front().first <= now_; to_board_.pop_front()) {
      board_.receive(to_board_.front().second);
    }
    return true;
  }

  host::Bytes receive(host::Milliseconds timeout) override {
    check_there();
    now_ += std::chrono::microseconds(10);
    const auto end = now_ + timeout;
    for (;;) {
      for (; !to_board_.empty() && to_board_.front().first <= now_; to_board_.pop_front()) {
        board_.receive(to_board_.front().second);
      }
      if (board_.has_answer()) pass(to_host_, board_.send());
      if (!to_host_.empty() && to_host_.front().first <= now_) {
        host::Bytes bytes = std::move(to_host_.front().second);
        to_host_.pop_front();
        return bytes;
      }
      if (board_.has_answer()) continue;
      auto next = end;
      if (!to_board_.empty()) next = std::min(next, to_board_.front().first);
      if (!to_host_.empty()) next = std::min(next, to_host_.front().first);
      now_ = std::max(now_, next);
      if (now_ >= end) return {};
    }
  }

  bool reconnect(host::Milliseconds timeout) override {
    if (!comes_back) {
      now_ += timeout;
      return false;
    }
    there_ = true;
    to_board_.clear();
    to_host_.clear();
    board_.power_cycle();
    return true;
  }

  host::Clock::time_point now() const override { return now_; }
  void unplug() { there_ = false; }

 private:
  using Queue = std::deque<std::pair<host::Clock::time_point, host::Bytes>>;

  bool happens(Fault fault) {
    const auto index = static_cast<std::size_t>(fault);
    if (random_.below(1000) >= rates[index]) return false;
    ++happened[index];
    return true;
  }
  void check_there() {
    if (happens(Fault::disconnect)) unplug();
    if (!there_) throw host::LinkError(host::LinkFault::gone, device(), "unplugged");
  }

  void pass(Queue& queue, host::Bytes bytes) {
    const auto& hook = &queue == &to_host_ ? to_host : to_board;
    if (hook) hook(bytes);
    if (bytes.empty() || happens(Fault::drop)) return;
    if (!bytes.empty() && happens(Fault::corrupt)) {
      std::uint8_t& byte = bytes[random_.below(bytes.size())];
      byte = static_cast<std::uint8_t>(byte ^ (1U << random_.below(8)));
    }
    if (!bytes.empty() && happens(Fault::cut)) {
      const std::size_t begin = random_.below(bytes.size());
      const std::size_t length = 1 + random_.below(bytes.size() - begin);
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
      bytes.erase(first, first + static_cast<std::ptrdiff_t>(length));
    }
    if (happens(Fault::noise)) {
      for (std::uint64_t i = random_.below(40); i > 0; --i) bytes.push_back(static_cast<std::uint8_t>(random_.next()));
    }
    auto when = now_;
    if (happens(Fault::delay)) when += std::chrono::milliseconds(random_.below(3000));
    if (!queue.empty()) when = std::max(when, queue.back().first);
    host::Bytes& overtaken = &queue == &to_host_ ? overtaken_to_host_ : overtaken_to_board_;
    if (overtaken.empty() && happens(Fault::reorder)) {
      overtaken = std::move(bytes);
      return;
    }
    queue.emplace_back(when, bytes);
    if (happens(Fault::duplicate)) queue.emplace_back(when, bytes);
    if (!overtaken.empty()) queue.emplace_back(when, std::exchange(overtaken, {}));
  }

  FakeBoard& board_;
  vectors::Random random_;
  host::Clock::time_point now_{};
  Queue to_board_;
  Queue to_host_;
  host::Bytes overtaken_to_board_;  ///< by the next transfer
  host::Bytes overtaken_to_host_;
  bool there_ = true;
};

}  // namespace cbvh::testing
