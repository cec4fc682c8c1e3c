// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "tests/board/faulted_run.h"

#include <fmt/format.h>

#include "fpga/emulator/model/model_core.h"
#include "fpga/host/boards.h"
#include "fpga/host/link_error.h"
#include "fpga/host/session.h"
#include "tests/board/wrong_core.h"
#include "vectors/registry.h"

namespace cbvh::testing {

namespace {

using Milliseconds = std::chrono::milliseconds;

/// Compares what a session hands over with the golden's responses.
class Comparison final : public host::ResponseSink {
 public:
  explicit Comparison(const vectors::VectorSet& set) : set_(set), want_(set.response_codec().packed_bytes()) {}

  void response(const std::uint8_t* packed, std::uint32_t latency) override {
    if (case_ >= set_.size() || in_case_ >= set_.response_range(case_).size) return differs("a surplus response");
    const std::size_t index = set_.response_range(case_).begin + in_case_++;
    set_.response_codec().pack(set_.response_at(index), want_.data());
    if (!std::equal(want_.begin(), want_.end(), packed)) differs("a response");
    const std::uint32_t stated = set_.latency_at(index);
    if (stated != vectors::kLatencyNotStated && latency != stated) differs("a latency");
  }
  void surplus() override { differs("a surplus response"); }
  void end_case(bool hung) override {
    if (hung) differs("it hung");
    if (case_ >= set_.size() || in_case_ != set_.response_range(case_).size) differs("the number of responses");
    ++case_;
    in_case_ = 0;
  }

  std::size_t cases() const { return case_; }
  const std::string& difference() const { return difference_; }  ///< empty: none

 private:
  void differs(const char* what) {
    if (difference_.empty()) difference_ = fmt::format("case {}: {} differs", case_, what);
  }

  const vectors::VectorSet& set_;
  host::Bytes want_;
  std::size_t case_ = 0;
  std::size_t in_case_ = 0;
  std::string difference_;
};

struct Work {
  std::string_view unit;
  std::uint64_t cases;
  std::uint32_t to_board;  ///< greatest payloads, such that there are dozens of transfers
  std::uint32_t from_board;
};
constexpr Work kWorks[] = {{"axis_compressor", 1500, 600, 1200},
                           {"scale_estimator", 1500, 600, 1200},
                           {"context_stack", 60, 4096, 8192},
                           {"treelet_collector", 60, 8192, 16384}};

RunReport converse(const vectors::VectorSet& set, const Ordeal& ordeal) {
  Comparison comparison(set);
  host::SessionOptions options;
  options.timeout = Milliseconds(250);
  options.reconnect_timeout = Milliseconds(1000);
  try {
    host::Session session(host::open_board({}), options);
    session.run(set, {}, comparison);
  } catch (const host::LinkError& error) {
    // What was handed over before must be right all the same.
    if (!comparison.difference().empty() && !ordeal.wrong_answers) return {Ending::wrong, comparison.difference()};
    return {Ending::failed, error.what()};
  } catch (const std::exception& error) {
    return {Ending::wrong, fmt::format("not an error of the link: {}", error.what())};
  }
  if (comparison.cases() != set.size()) {
    return {Ending::wrong, fmt::format("{} of {} cases, and no error", comparison.cases(), set.size())};
  }
  if (ordeal.wrong_answers == comparison.difference().empty()) {
    return {Ending::wrong, ordeal.wrong_answers ? "wrong answers were not noticed" : comparison.difference()};
  }
  return {Ending::completed, comparison.difference()};
}

}  // namespace

RunReport run_ordeal(emulator::UsbSystem& system, const Ordeal& ordeal) {
  vectors::Random random(ordeal.seed);
  const Work& work = kWorks[random.below(std::size(kWorks))];
  const auto set = vectors::generate_set(work.unit, {6, 1}, work.cases, random.next());
  emulator::ModelCore model({.buffers = static_cast<std::uint16_t>(random.between(1, 4)),
                             .greatest_payload_in = work.to_board,
                             .greatest_payload_out = work.from_board});
  WrongCore wrong(model, random.next());
  emulator::Link link(ordeal.wrong_answers ? static_cast<emulator::Core&>(wrong) : model, ordeal.faults, random.next());
  RunReport report{};
  {
    const emulator::UsbBoard board(system, ordeal.transport, link);
    report = converse(*set, ordeal);
  }
  for (const auto& [kind, count] : link.happened()) report.faults += count;
  if (report.ending == Ending::failed && report.faults == 0) {
    report = {Ending::wrong, "failed although nothing went wrong: " + report.what};
  }
  return report;
}

}  // namespace cbvh::testing
