// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "golden/build/float_tree.h"
#include "golden/update/traffic.h"
#include "rtl_model/lbvh/lbvh_pipeline.h"
#include "testbench/sim/accounts.h"
#include "testbench/sim/scene_image.h"
#include "testbench/sim/simulate.h"

/// One simulation of the LBVH pipeline, for any of its outputs.
namespace cbvh::testbench {

/// What is simulated, and what must come out.
struct LbvhJob {
  const golden::Mesh& mesh;
  const golden::FloatTree& floats;  ///< the golden's
  const SimRequest& request;
  rtl::LbvhConfig config;  ///< of the hardware: wires and parameters
};

/// What is in memory when the pipeline has finished.
template <class Output>
struct LbvhOutcome {
  const rtl::LbvhPipeline<rtl::MachineBits, Output>& pipeline;
  const rtl::LineStore& store;
  const ModuleAccesses& ports;  ///< by module
};

/// The rows that all outputs have in common.
template <class Output>
void add_build_traffic(SimResult& result, const LbvhOutcome<Output>& outcome) {
  const std::uint64_t n = result.triangles;
  const std::uint64_t odd_bytes = 32 * outcome.pipeline.run_writer().odd_runs();
  const std::uint64_t again = 32 * outcome.pipeline.records_rewritten();
  const std::string why = again > 0
                              ? fmt::format("{} records of earlier passes; half lines at ends of runs", again / 32)
                              : "half lines at ends of runs";
  add_traffic(result, "primitives read", outcome.ports.at("primitive_reader"), 40 * n, whole_lines(40 * n),
              "the last line");
  add_traffic(result, "sorted boxes written", outcome.ports.at("run_writer"), 32 * n, 32 * n + again + odd_bytes, why);
  add_traffic(result, "sorted boxes read", outcome.ports.at("run_merger"), 32 * n, 32 * n + again + odd_bytes, why);
  add_traffic(result, "primitive IDs written", outcome.ports.at("id_writer"), 4 * n, whole_lines(4 * n),
              "the last line");
}

/// Runs the pipeline. `finish(result, outcome)` reads the output back, compares, and adds its rows of traffic.
template <class Output, class Finish>
SimResult run_lbvh(const LbvhJob& job, Finish&& finish) {
  SimResult result;
  const SimConfig& config = job.request.config;
  rtl::LbvhPipeline<rtl::MachineBits, Output> pipeline(job.config);
  const auto named_ports = pipeline.ports();
  PortStalls stalls(unnamed(named_ports), job.request.machine.stalls);
  SimMemory memory(config, stalls.ports(), job.request.trace_path);
  store_primitives(job.mesh, job.config.primitives.value(), memory.store());

  bool sorted = false;
  std::uint64_t cycle = 0;
  const MachineRun run = run_machine(
      pipeline, stalls, memory, job.request.machine, 2 * job.config.count,
      [&] {
        if (!sorted && pipeline.records_merged() > 0) {
          sorted = true;
          result.phases.emplace_back("sort", cycle);
        }
        ++cycle;
        return pipeline.done() && memory.idle();
      },
      [&] { return std::min(job.config.count, pipeline.records_sorted()) + pipeline.records_merged(); });
  memory.finish();
  if (const auto refused = pipeline.morton_encoder().first_refused())
    throw golden::InputError(job.mesh.name, fmt::format("triangle {}: refused by the hardware", refused->value()));

  result.scene = job.mesh.name;
  result.triangles = job.floats.primitives;
  result.leaves = pipeline.emit_report().leaves.value();
  result.pairs = pipeline.emit_report().pairs.value();
  result.min_scale = static_cast<int>(job.config.registers.min_scale.value());
  result.phases.emplace_back("merge and emit", run.cycles);
  add_run(result, run, config, memory);
  result.runs = pipeline.runs();
  result.merge_passes = pipeline.merge_passes();
  const ModuleAccesses ports = module_accesses(named_ports, memory);
  const LbvhOutcome<Output> outcome{pipeline, memory.store(), ports};
  add_build_traffic(result, outcome);
  finish(result, outcome);
  result.baseline_bytes = golden::update_traffic(result.triangles, result.pairs, 0).lbvh.baseline_bytes;
  const auto ids = load_ids(job.config.ids.value(), job.floats.primitive_ids.size(), memory.store());
  if (result.difference.empty() && ids != job.floats.primitive_ids) result.difference = "the primitive-ID array";
  if (result.difference.empty() && (result.leaves != job.floats.leaves || result.pairs != job.floats.pairs.size()))
    result.difference = "the number of leaves or pairs";
  result.identical = result.difference.empty();
  return result;
}

/// The simulations, each in a source of its own.
SimResult simulate_float(const LbvhJob& job);
SimResult simulate_streaming_full(const LbvhJob& job);
SimResult simulate_streaming_lazy(const LbvhJob& job);
SimResult simulate_top_down(const LbvhJob& job);

/// Calls f(std::integral_constant<int, N>) for N = bits: those that fit packed pairs and are worth building hardware
/// for.
template <class F>
auto with_simulated_bits(unsigned bits, F&& f) {
  switch (bits) {
#ifndef CBVH_FEW_BITS
    case 4:
      return f(std::integral_constant<int, 4>());
    case 5:
      return f(std::integral_constant<int, 5>());
#endif
    case 6:
      return f(std::integral_constant<int, 6>());
    default:
      throw golden::InputError("bits", fmt::format("found {}: this build simulates no such machine", bits));
  }
}

}  // namespace cbvh::testbench
