// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>

#include "golden/input_error.h"
#include "testbench/sim/sim_config.h"

namespace cbvh::testbench {

namespace {

template <class T>
T parse_integer(const std::string& name, const std::string& text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw golden::InputError(name, fmt::format("found '{}', want an integer", text));
  return value;
}

template <class Access>
SimParameter integer(const char* name, const char* unit, const char* description, Access access) {
  return {name, unit, description, [access](const SimConfig& config) { return fmt::to_string(access(config)); },
          [access, name](SimConfig& config, const std::string& value) {
            auto& field = access(config);
            field = parse_integer<std::remove_reference_t<decltype(field)>>(name, value);
          }};
}

template <class Access>
SimParameter choice(const char* name, const char* description, std::vector<std::string> words, Access access) {
  const std::string unit = fmt::format("{}", fmt::join(words, "|"));
  return {name, unit, description,
          [access, words](const SimConfig& config) { return words.at(static_cast<std::size_t>(access(config))); },
          [access, words, name](SimConfig& config, const std::string& value) {
            for (std::size_t i = 0; i < words.size(); ++i) {
              auto& field = access(config);
              if (words[i] != value) continue;
              field = static_cast<std::remove_reference_t<decltype(field)>>(i);
              return;
            }
            throw golden::InputError(name, fmt::format("found '{}', want {}", value, fmt::join(words, " or ")));
          }};
}

SimParameter min_scale() {
  return {"min_scale", "auto|exponent", "e_min: the finest grid; auto is the scene's exactness limit",
          [](const SimConfig& config) { return config.min_scale ? fmt::to_string(*config.min_scale) : "auto"; },
          [](SimConfig& config, const std::string& value) {
            config.min_scale.reset();
            if (value != "auto") config.min_scale = parse_integer<int>("min_scale", value);
          }};
}

#define CBVH_FIELD(field) ([](auto& config) -> auto& { return config.field; })

}  // namespace

const std::vector<SimParameter>& sim_parameters() {
  static const std::vector<SimParameter> all = {
      choice("output", "what the pipeline writes", {"float", "float-top-down", "streaming"}, CBVH_FIELD(output)),
      choice("code", "stored codes", {"modulo", "relative"}, CBVH_FIELD(code)),
      choice("scale_rule", "grid of a node", {"equation2", "figure5"}, CBVH_FIELD(scale_rule)),
      choice("collector", "treelet collector: the paper's, or the lazy one", {"full", "lazy"}, CBVH_FIELD(collector)),
      integer("treelet", "levels", "D, levels of a treelet; 1: none", CBVH_FIELD(treelet)),
      integer("bits", "bits", "N, bits a coordinate", CBVH_FIELD(bits)),
      min_scale(),
      integer("scratchpad_bytes", "bytes", "on-chip memory that sorts runs and then buffers them for the merge",
              CBVH_FIELD(scratchpad_bytes)),
      integer("buffer_records", "boxes",
              "least buffer of a run in a merge; more runs than that holds take another pass",
              CBVH_FIELD(buffer_records)),
      integer("refill_lines", "lines", "64-byte lines that the merger asks for at a time for one run",
              CBVH_FIELD(refill_lines)),
      integer("reader_outstanding", "lines", "reads in flight of the primitive, tree and ID readers",
              CBVH_FIELD(reader_outstanding)),
      integer("merger_outstanding", "lines", "reads in flight of the run merger", CBVH_FIELD(merger_outstanding)),
      integer("run_skew_lines", "lines", "left free between runs, so that they begin in different banks",
              CBVH_FIELD(run_skew_lines)),
      integer("combining_lines", "lines", "64-byte lines that the node writer holds to complete them",
              CBVH_FIELD(combining_lines)),
      integer("gather_lines", "lines", "lines of primitives that the refit unit keeps on chip",
              CBVH_FIELD(gather_lines)),
      integer("gather_outstanding", "lines", "reads of primitives that the refit unit has in flight",
              CBVH_FIELD(gather_outstanding)),
      integer("gather_queue", "accesses", "of the refit unit between tags and lines, hiding the memory's latency",
              CBVH_FIELD(gather_queue)),
      integer("max_triangles", "triangles", "a scene with more is refused", CBVH_FIELD(max_triangles)),
      choice("memory", "external memory: LPDDR3, or an ideal one", {"dram", "ideal"}, CBVH_FIELD(memory)),
      integer("ideal_latency", "cycles", "of the ideal memory", CBVH_FIELD(ideal_latency)),
      integer("clock_mhz", "MHz", "clock of the pipeline", CBVH_FIELD(dram.core_clock_mhz)),
      integer("watchdog_cycles", "cycles", "without any transfer after which the simulation is a deadlock",
              CBVH_FIELD(watchdog_cycles)),
      integer("dram.channels", "channels", "of 32 bits", CBVH_FIELD(dram.channels)),
      integer("dram.banks", "banks", "of a channel", CBVH_FIELD(dram.banks)),
      integer("dram.row_bytes", "bytes", "a row of a bank", CBVH_FIELD(dram.row_bytes)),
      integer("dram.capacity_bytes", "bytes", "of all channels", CBVH_FIELD(dram.capacity_bytes)),
      integer("dram.interleave_bytes", "bytes", "consecutive in one channel", CBVH_FIELD(dram.interleave_bytes)),
      integer("dram.read_queue_depth", "lines", "reads waiting in a channel", CBVH_FIELD(dram.read_queue_depth)),
      integer("dram.write_queue_depth", "lines", "writes waiting in a channel", CBVH_FIELD(dram.write_queue_depth)),
      integer("dram.write_high", "lines", "waiting writes that turn a channel to writing", CBVH_FIELD(dram.write_high)),
      integer("dram.write_low", "lines", "waiting writes that turn it back to reading", CBVH_FIELD(dram.write_low)),
      integer("dram.batch_lines", "lines", "a direction is kept for, while the other waits",
              CBVH_FIELD(dram.batch_lines)),
      integer("dram.idle_clocks", "command clocks", "without a read, after which waiting writes go out",
              CBVH_FIELD(dram.idle_clocks)),
      integer("dram.overtakes", "lines", "that may overtake a waiting one of their bank", CBVH_FIELD(dram.overtakes)),
      choice("dram.bank_hash", "XOR the bank's number with the row's", {"off", "on"}, CBVH_FIELD(dram.bank_hash)),
      choice("dram.refresh", "a channel at a time, as Ramulator does, or a bank", {"all_banks", "per_bank"},
             CBVH_FIELD(dram.refresh)),
      integer("dram.answer_latency", "cycles", "from the last word on the pins to the answer",
              CBVH_FIELD(dram.answer_latency)),
      integer("dram.outstanding", "lines", "answers that a port may wait for", CBVH_FIELD(dram.outstanding)),
      integer("dram.jitter", "cycles", "most random extra latency of an answer", CBVH_FIELD(dram.jitter)),
      integer("dram.seed", "", "of the jitter", CBVH_FIELD(dram.seed)),
      integer("dram.lose_answer", "", "n: the nth answer gets lost, to see the deadlock found; 0: none",
              CBVH_FIELD(dram.lose_answer)),
  };
  return all;
}

#undef CBVH_FIELD

}  // namespace cbvh::testbench
