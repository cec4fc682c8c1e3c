// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "testbench/backend/backend.h"
#include "testbench/board/connection.h"

namespace cbvh::testbench {

namespace {

/// Responses of a set, made from what the board sends.
class Collector final : public host::ResponseSink {
 public:
  explicit Collector(const vectors::VectorSet& set)
      : codec_(set.response_codec()), object_(codec_.object_size), responses(codec_.object_size) {
    responses.reserve(set.response_count());
  }

  /// A response with a padding bit set is none: it counts as missing.
  void response(const std::uint8_t* packed, std::uint32_t latency) override {
    if (codec_.unpack(packed, object_.data())) responses.add(object_.data(), latency);
  }
  void surplus() override {
    object_.assign(object_.size(), std::byte{0});
    responses.add(object_.data(), 0);
  }
  void end_case(bool hung) override { responses.end_case(hung); }

 private:
  const vectors::PayloadCodec& codec_;
  std::vector<std::byte> object_;

 public:
  Responses responses;
};

/// The gateware in an FPGA, over USB.
class BoardBackend final : public Backend {
 public:
  std::string name() const override { return "board"; }
  bool has(const vectors::UnitDescription& unit) const override {
    return BoardConnection::instance().find(unit.name) != nullptr;
  }
  bool takes(const vectors::UnitDescription& unit, const vectors::Parameters& parameters) const override {
    return BoardConnection::instance().takes(unit, parameters);
  }
  std::string why_unavailable() const override { return BoardConnection::instance().why_unavailable(); }
  bool stalls() const override { return false; }

  Responses run(const vectors::VectorSet& set, const RunOptions& options) const override {
    Collector collector(set);
    const host::RunLimits limits{static_cast<std::uint32_t>(options.hang_cycles),
                                 static_cast<std::uint16_t>(options.drain_cycles)};
    collector.responses.cycles = BoardConnection::instance().run(set, limits, collector);
    return std::move(collector.responses);
  }
};

}  // namespace

std::unique_ptr<Backend> make_board_backend() { return std::make_unique<BoardBackend>(); }

}  // namespace cbvh::testbench
