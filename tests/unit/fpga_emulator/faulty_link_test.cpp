// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/link.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "golden/input_error.h"

namespace cbvh::testing {
namespace {

using emulator::Direction;
using emulator::Fault;
using emulator::FaultKind;
using emulator::Link;
using emulator::Plug;
using emulator::Time;
using emulator::Transfer;
using Bytes = std::vector<std::uint8_t>;
using Milliseconds = std::chrono::milliseconds;
using Status = Transfer::Status;

/// Notes what it receives; sends what it is given.
class PlainCore final : public emulator::Core {
 public:
  void receive(std::span<const std::uint8_t> bytes) override {
    received.insert(received.end(), bytes.begin(), bytes.end());
  }
  Bytes send(std::size_t most) override {
    const auto cut = to_send.begin() + static_cast<std::ptrdiff_t>(std::min(most, to_send.size()));
    Bytes bytes(to_send.begin(), cut);
    to_send.erase(to_send.begin(), cut);
    return bytes;
  }
  void reset() override { ++resets; }

  Bytes received;
  Bytes to_send;
  int resets = 0;
};

Bytes counting(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i);
  return bytes;
}

const Time kStart{};
const Bytes kFirst = counting(64);
const Bytes kSecond = {200, 201, 202};

/// Every transfer has the fault.
struct Faulty {
  explicit Faulty(FaultKind kind, std::uint64_t seed = 1) : link(core, {{kind, 1}}, seed) {}
  PlainCore core;
  Link link;
};

Bytes joined(const Bytes& a, const Bytes& b) {
  Bytes bytes = a;
  bytes.insert(bytes.end(), b.begin(), b.end());
  return bytes;
}

TEST(Link, without_faults_passes_everything_on_and_never_waits) {
  PlainCore core;
  Link link(core, {}, 1);
  EXPECT_EQ(link.out(kFirst, kStart).status, Status::done);
  EXPECT_EQ(core.received, kFirst);
  EXPECT_EQ(link.in(10, kStart).status, Status::pending);
  core.to_send = kFirst;
  EXPECT_EQ(link.in(60, kStart).bytes, Bytes(kFirst.begin(), kFirst.begin() + 60));
  EXPECT_EQ(link.in(60, kStart).bytes, Bytes(kFirst.begin() + 60, kFirst.end()));
  EXPECT_FALSE(link.wake());
  EXPECT_EQ(link.plug(), Plug::stays);
  EXPECT_TRUE(link.happened().empty());
}

TEST(Link, a_stalled_endpoint_stays_so_until_cleared_and_loses_nothing) {
  Faulty faulty(FaultKind::stall);
  EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::stalled);
  EXPECT_EQ(faulty.link.out(kFirst, kStart + Milliseconds(9999)).status, Status::stalled);
  EXPECT_TRUE(faulty.core.received.empty());
  faulty.core.to_send = kFirst;
  EXPECT_EQ(faulty.link.in(100, kStart).status, Status::stalled);
  EXPECT_EQ(faulty.link.in(100, kStart).status, Status::stalled);
  EXPECT_EQ(faulty.link.happened().at(FaultKind::stall), 2U);
  faulty.link.clear_halt(Direction::in);
  EXPECT_EQ(faulty.link.in(100, kStart).status, Status::stalled);  // the next transfer, with a fault of its own
  EXPECT_EQ(faulty.link.happened().at(FaultKind::stall), 3U);
}

TEST(Link, nak_and_delay_make_a_transfer_wait_once) {
  for (const auto& [kind, most] : {std::pair(FaultKind::nak, 400), std::pair(FaultKind::delay, 8)}) {
    Faulty faulty(kind);
    EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::pending);
    ASSERT_TRUE(faulty.link.wake());
    const Time wake = *faulty.link.wake();
    EXPECT_GT(wake, kStart);
    EXPECT_LE(wake, kStart + Milliseconds(most));
    EXPECT_EQ(faulty.link.out(kFirst, wake - Milliseconds(1)).status, Status::pending);
    EXPECT_EQ(faulty.link.out(kFirst, wake).status, Status::done);
    EXPECT_EQ(faulty.core.received, kFirst);
    faulty.core.to_send = kFirst;
    EXPECT_EQ(faulty.link.in(100, wake).status, Status::pending);
    EXPECT_EQ(faulty.link.in(100, wake + Milliseconds(most)).bytes, kFirst);
    EXPECT_EQ(faulty.link.happened().at(kind), 2U);
  }
}

TEST(Link, short_transfers_into_the_host_lose_nothing) {
  Faulty faulty(FaultKind::short_);
  faulty.core.to_send = kFirst;
  Bytes got;
  for (int i = 0; i < 1000 && got.size() < kFirst.size(); ++i) {
    const Transfer transfer = faulty.link.in(32, kStart);
    ASSERT_EQ(transfer.status, Status::done);
    EXPECT_LT(transfer.bytes.size(), 32U);
    got = joined(got, transfer.bytes);
  }
  EXPECT_EQ(got, kFirst);
  EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::done);  // the other direction has no such fault
  EXPECT_EQ(faulty.core.received, kFirst);
}

TEST(Link, babble_loses_a_transfer_into_the_host) {
  Faulty faulty(FaultKind::babble);
  faulty.core.to_send = kFirst;
  EXPECT_EQ(faulty.link.in(32, kStart).status, Status::babbled);
  EXPECT_EQ(faulty.core.to_send.size(), 32U);
}

TEST(Link, corruption_changes_one_to_four_bytes) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Faulty faulty(FaultKind::corrupt, seed);
    EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::done);
    faulty.core.to_send = kFirst;
    for (const Bytes& got : {faulty.core.received, faulty.link.in(100, kStart).bytes}) {
      ASSERT_EQ(got.size(), kFirst.size());
      std::size_t changed = 0;
      for (std::size_t i = 0; i < got.size(); ++i) changed += got[i] != kFirst[i] ? 1 : 0;
      EXPECT_LE(changed, 4U);
      EXPECT_NE(got, kFirst);
    }
  }
}

TEST(Link, drops_cut_a_piece_out_of_a_transfer_or_take_all_of_it) {
  std::size_t everything = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Faulty faulty(FaultKind::drop, seed);
    EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::done);
    EXPECT_LT(faulty.core.received.size(), kFirst.size());
    EXPECT_TRUE(std::is_sorted(faulty.core.received.begin(), faulty.core.received.end()));
    faulty.core.to_send = kFirst;
    const Transfer transfer = faulty.link.in(100, kStart);
    EXPECT_LT(transfer.bytes.size(), kFirst.size());
    EXPECT_EQ(transfer.status == Status::pending, transfer.bytes.empty());
    EXPECT_TRUE(faulty.core.to_send.empty());
    everything += transfer.bytes.empty() ? 1 : 0;
  }
  EXPECT_GT(everything, 10U);
  EXPECT_LT(everything, 40U);
}

TEST(Link, duplicates_arrive_one_after_the_other) {
  Faulty faulty(FaultKind::duplicate);
  faulty.link.out(kFirst, kStart);
  EXPECT_EQ(faulty.core.received, joined(kFirst, kFirst));
  PlainCore core;
  Link link(core, {{FaultKind::duplicate, 1}}, 1);
  core.to_send = kFirst;
  EXPECT_EQ(link.in(100, kStart).bytes, kFirst);
  EXPECT_EQ(link.in(100, kStart).bytes, kFirst);
}

TEST(Link, a_transfer_is_overtaken_by_the_next_or_comes_late) {
  Faulty faulty(FaultKind::reorder);
  EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::done);
  EXPECT_TRUE(faulty.core.received.empty());
  EXPECT_EQ(faulty.link.out(kSecond, kStart).status, Status::done);
  EXPECT_EQ(faulty.core.received, kFirst);  // the second is held back in its turn
  ASSERT_TRUE(faulty.link.wake());
  faulty.link.in(0, *faulty.link.wake());
  EXPECT_EQ(faulty.core.received, joined(kFirst, kSecond));

  PlainCore core;
  Link half(core, {{FaultKind::reorder, 0.5}}, 3);
  Bytes sent;
  for (std::uint8_t i = 0; i < 100; ++i) {
    half.out(Bytes{i}, kStart);
    sent.push_back(i);
  }
  half.in(0, kStart + Milliseconds(1000));
  EXPECT_NE(core.received, sent);
  EXPECT_TRUE(std::is_permutation(core.received.begin(), core.received.end(), sent.begin(), sent.end()));

  core.to_send = counting(100);
  Bytes got;
  for (Time now = kStart; now < kStart + Milliseconds(5000); now += Milliseconds(10))
    got = joined(got, half.in(1, now).bytes);
  EXPECT_NE(got, counting(100));
  EXPECT_TRUE(std::is_permutation(got.begin(), got.end(), sent.begin(), sent.end()));
}

TEST(Link, unplugging_is_told_once) {
  Faulty gone(FaultKind::disconnect);
  EXPECT_EQ(gone.link.out(kFirst, kStart).status, Status::pending);
  EXPECT_EQ(gone.link.plug(), Plug::leaves);
  EXPECT_EQ(gone.link.plug(), Plug::stays);
  Faulty back(FaultKind::reconnect);
  back.core.to_send = kFirst;
  EXPECT_EQ(back.link.in(100, kStart).status, Status::pending);
  EXPECT_EQ(back.link.plug(), Plug::leaves_and_returns);
  EXPECT_EQ(back.core.resets, 0);
  back.link.power_on();
  EXPECT_EQ(back.core.resets, 1);
}

TEST(Link, reset_powers_the_core_on_and_then_takes_the_transfer) {
  Faulty faulty(FaultKind::reset);
  EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::pending);
  EXPECT_EQ(faulty.core.resets, 1);
  EXPECT_EQ(faulty.link.out(kFirst, kStart).status, Status::done);
  EXPECT_EQ(faulty.core.resets, 1);
  EXPECT_EQ(faulty.core.received, kFirst);
}

TEST(Link, the_seed_alone_says_which_transfers_have_faults) {
  const auto run = [](std::uint64_t seed) {
    PlainCore core;
    Link link(core, {{FaultKind::corrupt, 0.1}, {FaultKind::drop, 0.1}}, seed);
    for (int i = 0; i < 500; ++i) link.out(kFirst, kStart);
    EXPECT_NEAR(static_cast<double>(link.happened().at(FaultKind::corrupt)), 50, 25);
    EXPECT_NEAR(static_cast<double>(link.happened().at(FaultKind::drop)), 45, 25);
    return core.received;
  };
  EXPECT_EQ(run(7), run(7));
  EXPECT_NE(run(7), run(8));
}

TEST(Fault, is_read_from_text) {
  for (const auto name : emulator::kFaultNames) {
    const Fault fault = emulator::parse_fault(std::string(name));
    EXPECT_EQ(to_string(fault.kind), name);
    EXPECT_EQ(fault.rate, emulator::kUsualRate);
  }
  EXPECT_EQ(emulator::parse_fault("drop:0.25").rate, 0.25);
  for (const char* const wrong : {"", "lose", "drop:", "drop:2", "drop:-1", "drop:0.1x", "drop:nan"}) {
    EXPECT_THROW(emulator::parse_fault(wrong), golden::InputError) << wrong;
  }
}

}  // namespace
}  // namespace cbvh::testing
