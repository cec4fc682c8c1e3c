// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Broken gateware behind the link is noticed: each mutant of the frame engine or of what is in it says something else.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "fpga/emulator/gateware/gateware_core.h"
#include "testbench/gateware/simulator.h"
#include "testbench/gateware/sources.h"
#include "transcript.h"

namespace cbvh::testing {
namespace {

namespace fs = std::filesystem;

using emulator::GatewareCore;
using emulator::ModelCore;

/// The engine's Verilog with one place changed, used as long as this lives.
class Mutant {
 public:
  Mutant(const std::string& file, const std::string& from, const std::string& to) {
    std::size_t changed = 0;
    for (const auto& sources :
         {testbench::gateware_sources(), testbench::gateware_benches(), testbench::gateware_engine()}) {
      for (const auto& source : sources) {
        std::string text(source.bytes);
        const std::size_t at = text.find(from);
        if (source.name == file && at != std::string::npos && text.find(from, at + 1) == std::string::npos) {
          text.replace(at, from.size(), to);
          ++changed;
        }
        std::ofstream(fs::path(folder_.path()) / source.name) << text;
      }
    }
    EXPECT_EQ(changed, 1U) << file << ": " << from;
    setenv("CBVH_GATEWARE", folder_.path().c_str(), 1);
  }
  ~Mutant() { unsetenv("CBVH_GATEWARE"); }

 private:
  testbench::TemporaryFolder folder_;
};

/// What the model does in another order: batches that come before there is a buffer for them.
Transcript run_burst(emulator::Core& core) {
  const auto set = vectors::generate_set("axis_compressor", {6, 1}, 50, 5);
  const host::Bytes payload = PackedBatch(*set).batch.to_payload();
  host::Bytes bytes;
  host::append_frame(bytes, host::FrameType::open, 0, open_payload("axis_compressor", 6, 1));
  for (std::uint32_t i = 1; i <= 4; ++i) host::append_frame(bytes, host::FrameType::vectors, i, payload);
  host::append_frame(bytes, host::FrameType::status, 5);
  Transcript talk(core);
  talk.turn(bytes);
  return talk;
}

TEST(GatewareCoreMutants, of_units_with_memory_and_of_treelets_are_noticed) {
  if (!testbench::why_no_simulator().empty()) GTEST_SKIP() << testbench::why_no_simulator();
  struct Place {
    const char *unit, *file, *from, *to;
  };
  const Place places[] = {
      {"backtrack_unit", "backtrack_unit.v", "next = repair_0 ? place_0", "next = repair_1 ? place_1"},
      {"backtrack_unit", "reencode_axis.v", "rounds_up = |(old_to", "rounds_up = |(old_from"},
      {"backtrack_unit", "unit_socket.v", ".out_data({sink_cycle, sink_data})", ".out_data({sink_data, sink_cycle})"},
      {"backtrack_unit", "latency_meter.v", "event_cycle <= sink_cycle", "event_cycle <= cycle"},
      {"treelet_collector", "treelet_assembler.v", "left = &inner ? second_entry", "left = &inner ? right"},
      {"treelet_collector", "treelet_row.v", "refused <= root ? ", "refused <= ~root ? "},
      {"stream_compressor", "line_combiner.v", "wanted = holds & ", "wanted = 1'b0 & "},
      {"stream_compressor", "stream_compressor_harness.v", "answers_data[PAIR*told_slot+:PAIR]",
       "answers_data[0+:PAIR]"},
  };
  for (const Place& place : places) {
    const int treelet = place.unit == std::string("treelet_collector") ? 2 : 1;
    ModelCore model = model_core(place.unit, 6, treelet);
    const Transcript wanted = run_vectors(model, place.unit, 6, 24, treelet);
    const Mutant mutant(place.file, place.from, place.to);
    GatewareCore core({.unit = place.unit, .treelet = treelet});
    EXPECT_FALSE(run_vectors(core, place.unit, 6, 24, treelet) == wanted) << place.file << ": " << place.from;
  }
}

TEST(GatewareCoreMutants, each_is_noticed) {
  if (!testbench::why_no_simulator().empty()) GTEST_SKIP() << testbench::why_no_simulator();
  struct Place {
    const char *file, *from, *to;
  };
  const Place places[] = {
      {"crc32c_byte.v", "32'h82F63B78", "32'h82F63B79"},
      {"frame_receiver.v", "if (full && magic) state", "if (full) state"},
      {"frame_receiver.v", "HUNT;\n          filled <= 5'd15;", "HUNT;\n          filled <= 5'd0;"},
      {"frame_sender.v", "? ~crc :", "? crc :"},
      {"frame_engine.v", "credit = next_number + BUFFER_COUNT - {30'd0, used}", "credit = next_number + BUFFER_COUNT"},
      {"frame_engine.v", "lost        <= lost + ahead;", "lost        <= lost + 1;"},
      {"frame_engine.v", "takes = counts && !ahead[31]", "takes = counts"},
      {"frame_engine.v", "if (end_valid && !end_good)", "if (end_valid)"},
      {"frame_judge.v", "answer == `CBVH_FRAME_BOARD_OPEN", "1'b1"},
      {"batch_queue.v", "keeps   <= wanted && !full", "keeps   <= wanted"},
      {"batch_queue.v", "{fill_buffer, run_buffer} <= 2'd0", "fill_buffer <= 1'b0"},
      {"answer_payload.v", "&& next[15:2] != 14'd0;", ";"},
      {"latency_meter.v", "given <= given + 1'b1", "given <= accepted"},
      {"batch_runner.v", "record[31:0] <= latency;", "record[31:0] <= latency + 1;"},
      {"batch_runner.v", "unit_reset   <= 1'b1;", "unit_reset   <= 1'b0;"},
      {"batch_runner.v", "source_valid <= 1'b0;\n        end\n        if (popped)", "end\n        if (popped)"},
      {"unit_socket.v", "taken = stimuli_valid & stimuli_ready", "taken = stimuli_ready"},
      {"axis_compressor.v", "upper_floor_1 + 26'sd1", "upper_floor_1"},
      {"skid_buffer.v", "oldest <= full ? newer", "oldest <= ~full ? newer"},
  };
  ModelCore model = model_core("axis_compressor", 6);
  const Transcript vectors_wanted = run_vectors(model, "axis_compressor", 6, 40);
  model.reset();
  const Transcript errors_wanted = run_errors(model);
  model.reset();
  const Transcript noise_wanted = run_noise(model, 1);
  GatewareCore whole;
  const Transcript burst_wanted = run_burst(whole);
  EXPECT_EQ(burst_wanted.frames, 6U);
  ModelCore stack_model = model_core("context_stack", 6);
  const Transcript stack_wanted = run_vectors(stack_model, "context_stack", 6, 10);
  for (const Place& place : places) {
    const Mutant mutant(place.file, place.from, place.to);
    GatewareCore core;
    bool noticed = !(run_vectors(core, "axis_compressor", 6, 40) == vectors_wanted);
    core.reset();
    noticed = noticed || !(run_errors(core) == errors_wanted);
    core.reset();
    noticed = noticed || !(run_burst(core) == burst_wanted);
    core.reset();
    noticed = noticed || !(run_noise(core, 1) == noise_wanted);
    if (!noticed) {  // bytes do not always follow each other at once
      GatewareCore stalled({.stalls = true});
      noticed = !(run_errors(stalled) == errors_wanted);
    }
    if (!noticed) {
      GatewareCore stack({.unit = "context_stack"});
      noticed = !(run_vectors(stack, "context_stack", 6, 10) == stack_wanted);
    }
    EXPECT_TRUE(noticed) << place.file << ": " << place.from;
  }
}

}  // namespace
}  // namespace cbvh::testing
