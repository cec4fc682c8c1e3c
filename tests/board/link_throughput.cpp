// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// How fast vectors stream to the emulated board, beside what the same process moves through the bare endpoints with the
// same transfers. Prints the table of docs/results.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>

#include "fpga/emulator/model/model_core.h"
#include "fpga/emulator/usb/board.h"
#include "fpga/emulator/usb/preload.h"
#include "fpga/host/boards.h"
#include "fpga/host/frame.h"
#include "fpga/host/session.h"
#include "tests/board/replay_core.h"
#include "vectors/registry.h"

namespace {

using namespace cbvh;

constexpr double kMega = 1e6;
constexpr double kHighSpeedBytes = 40e6;  ///< a second, both directions together, of USB 2.0 bulk transfers
constexpr std::chrono::milliseconds kTimeout{5000};

/// Takes everything; gives so many bytes for each frame's worth taken.
class BareCore final : public emulator::Core {
 public:
  BareCore(std::size_t taken, std::size_t given) : taken_(taken), given_(given), bytes_(given) {}

  void receive(std::span<const std::uint8_t> bytes) override {
    received_ += bytes.size();
    for (; received_ >= taken_; received_ -= taken_) ready_ += given_;
  }
  std::vector<std::uint8_t> send(std::size_t most) override {
    const std::size_t count = std::min({most, ready_, given_});
    ready_ -= count;
    return {bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(count)};
  }
  void reset() override { received_ = ready_ = 0; }

 private:
  std::size_t taken_;
  std::size_t given_;
  std::vector<std::uint8_t> bytes_;
  std::size_t received_ = 0;
  std::size_t ready_ = 0;
};

class Discard final : public host::ResponseSink {
 public:
  void response(const std::uint8_t*, std::uint32_t) override { ++responses; }
  void surplus() override {}
  void end_case(bool) override {}
  std::uint64_t responses = 0;
};

double seconds_since(emulator::Time start) {
  return std::chrono::duration<double>(emulator::Clock::now() - start).count();
}

struct Streamed {
  double seconds = 0;
  std::uint64_t batches = 0;
  host::LinkCounters link;
};

template <class AnyCore>
Streamed stream_vectors(emulator::UsbSystem& system, const vectors::VectorSet& set, std::uint32_t payload) {
  AnyCore core({.greatest_payload_in = payload, .greatest_payload_out = 2 * payload});
  emulator::Link link(core, {}, 1);
  const emulator::UsbBoard board(system, emulator::Transport::bulk, link);
  host::Session session(host::open_board({}), {});
  Discard sink;
  const host::LinkCounters before = session.link_counters();
  const emulator::Time start = emulator::Clock::now();
  session.run(set, {}, sink);
  Streamed streamed{seconds_since(start), session.counters().batches, session.link_counters()};
  streamed.link.bytes_sent -= before.bytes_sent;
  streamed.link.bytes_received -= before.bytes_received;
  if (sink.responses != set.response_count()) throw std::runtime_error("responses are missing");
  return streamed;
}

/// The same bytes in transfers of the same sizes, with as many batches under way.
double move_bytes(emulator::UsbSystem& system, const Streamed& streamed) {
  constexpr std::uint64_t kUnderWay = 4;
  const std::size_t out = streamed.link.bytes_sent / streamed.batches;
  const std::size_t in = streamed.link.bytes_received / streamed.batches;
  BareCore core(out, in);
  emulator::Link link(core, {}, 1);
  const emulator::UsbBoard board(system, emulator::Transport::bulk, link);
  const auto transport = host::open_board({});
  const emulator::Time start = emulator::Clock::now();
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
  while (received < in * streamed.batches) {
    for (; sent < streamed.batches && sent < received / in + kUnderWay; ++sent) {
      if (!transport->send(host::Bytes(out), kTimeout)) throw std::runtime_error("a transfer was not taken");
    }
    const std::size_t more = transport->receive(kTimeout).size();
    if (more == 0) throw std::runtime_error("no bytes have come");
    received += more;
  }
  return seconds_since(start);
}

int measure(std::uint64_t cases, unsigned repeats, const std::vector<unsigned>& payloads) {
  emulator::UsbSystem system;
  const auto set = vectors::generate_set("axis_compressor", {6, 1}, cases, 1);
  const double data = static_cast<double>(set->stimulus_codec().packed_bytes() +
                                          host::BatchResults::record_bytes(set->response_codec().packed_bytes()));
  fmt::print("{} axis vectors of {:.0f} bytes, stimulus, response and latency; best of {}\n", cases, data, repeats);
  fmt::print("USB 2.0 at high speed, 40 MB/s in all: {:.2f} million vectors a second\n",
             kHighSpeedBytes / data / kMega);
  fmt::print(
      "| payload | bare MB/s | link alone MB/s | of bare | vectors/s | with the core MB/s | of bare | vectors/s |");
  fmt::print(" frames |\n|---|---|---|---|---|---|---|---|---|\n");
  const auto keep_best = [](Streamed& best, const Streamed& now) {
    if (best.seconds == 0 || now.seconds < best.seconds) best = now;
  };
  for (const unsigned kib : payloads) {
    Streamed computed;
    Streamed replayed;
    double bare = 0;
    for (unsigned i = 0; i < repeats; ++i) {
      keep_best(computed, stream_vectors<emulator::ModelCore>(system, *set, kib * 1024));
      keep_best(replayed, stream_vectors<testing::ReplayCore>(system, *set, kib * 1024));
      const double seconds = move_bytes(system, computed);
      if (i == 0 || seconds < bare) bare = seconds;
    }
    const auto bytes = static_cast<double>(computed.link.bytes_sent + computed.link.bytes_received);
    const auto columns = [&](const Streamed& streamed) {
      return fmt::format("{:.0f} | {:.0f} % | {:.2f} million", bytes / streamed.seconds / kMega,
                         100 * bare / streamed.seconds, static_cast<double>(cases) / streamed.seconds / kMega);
    };
    fmt::print("| {} KiB | {:.0f} | {} | {} | {:.2f} % |\n", kib, bytes / bare / kMega, columns(replayed),
               columns(computed), 100 - 100 * data * static_cast<double>(cases) / bytes);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  emulator::preload_umockdev(argv);
  std::uint64_t cases = 1'000'000;
  unsigned repeats = 3;
  std::vector<unsigned> payloads = {4, 16, 64, 256, 1024};
  CLI::App app("Measures the link to the emulated board.", "link_throughput");
  app.add_option("--cases", cases, "axis vectors")->check(CLI::PositiveNumber);
  app.add_option("--repeats", repeats, "of each measurement; the best counts")->check(CLI::PositiveNumber);
  app.add_option("--payload", payloads, "KiB of a transfer, for a row each")->check(CLI::Range(1U, 16384U));
  CLI11_PARSE(app, argc, argv);
  try {
    return measure(cases, repeats, payloads);
  } catch (const std::exception& error) {
    fmt::print(stderr, "link_throughput: {}\n", error.what());
    return 1;
  }
}
