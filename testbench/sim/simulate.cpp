// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/simulate.h"

#include "golden/build/lbvh.h"
#include "golden/quantize/scale.h"
#include "testbench/sim/lbvh_simulation.h"
#include "testbench/sim/memory_map.h"
#include "vectors/convert.h"

namespace cbvh::testbench {

namespace {

constexpr std::uint64_t kRecordBytes = 32;

/// Where everything lies, and every wire of the pipeline.
rtl::LbvhConfig hardware_config(const golden::FloatTree& floats, const SimConfig& config) {
  const std::uint64_t n = floats.primitives;
  const std::uint64_t pairs = floats.pairs.size();
  const std::uint64_t most_runs = n / (config.scratchpad_bytes / kRecordBytes) + 1;
  const std::uint64_t run_bytes = (n + most_runs) * kRecordBytes + most_runs * config.run_skew_lines * 64;
  MemoryMap map(std::uint64_t{config.dram.row_bytes} * config.dram.channels / 64, config.dram.capacity_bytes);
  const auto area = [&](const char* name, std::uint64_t bytes) { return rtl::LineAddress(map.add(name, bytes)); };
  rtl::LbvhConfig wires;
  wires.primitives = area("primitives", 40 * n);
  wires.count = n;
  for (rtl::RunArea& run_area : wires.run_areas)
    run_area = {area("sorted runs", run_bytes), rtl::LineAddress(config.run_skew_lines)};
  wires.ids = area("the primitive-ID array", 4 * n);
  if (config.output != PipelineOutput::floats) wires.pairs = area("node pairs", 16 * pairs);
  if (config.output != PipelineOutput::streaming) wires.float_pairs = area("float pairs", 64 * pairs);
  wires.scene = {vectors::float_box(floats.scene)};
  const int min_scale = checked_min_scale(config, floats);
  wires.registers =
      vectors::scene_registers({static_cast<int>(config.bits), min_scale, config.scale_rule}, config.code);
  wires.reader_outstanding = config.reader_outstanding;
  wires.sorter_records = config.scratchpad_bytes / kRecordBytes;
  wires.merge.scratchpad_bytes = config.scratchpad_bytes;
  wires.merge.minimum_buffer_records = config.buffer_records;
  wires.merge.refill_lines = config.refill_lines;
  wires.merge.outstanding = config.merger_outstanding;
  wires.merge.table_runs = most_runs + 1;
  wires.treelet = static_cast<int>(config.treelet);
  wires.held_lines = config.combining_lines;
  return wires;
}

}  // namespace

std::string describe_output(const SimConfig& config) {
  if (config.output == PipelineOutput::floats) return "float";
  const char* code = config.code == golden::Code::modulo ? "modulo" : "relative";
  if (config.output == PipelineOutput::floats_top_down) return fmt::format("float-top-down {}", code);
  return fmt::format("streaming {} D={} {}", code, config.treelet,
                     config.collector == Collector::full ? "full" : "lazy");
}

void check_triangles(const std::string& scene, std::uint64_t triangles, const SimConfig& config) {
  if (triangles > config.max_triangles)
    throw golden::InputError(scene, fmt::format("{} triangles, max_triangles is {}", triangles, config.max_triangles));
}

int checked_min_scale(const SimConfig& config, const golden::FloatTree& floats) {
  const int limit = golden::exactness_limit(floats.largest_magnitude);
  if (config.min_scale && *config.min_scale < limit) {
    throw golden::InputError("min_scale", fmt::format("found {}, want {} or more: the exactness limit of this scene",
                                                      *config.min_scale, limit));
  }
  return config.min_scale.value_or(limit);
}

SimResult simulate_lbvh(const golden::Mesh& mesh, const SimRequest& request) {
  check_triangles(mesh.name, mesh.triangles.size(), request.config);
  const golden::FloatTree floats = golden::build_lbvh(mesh);
  const LbvhJob job{mesh, floats, request, hardware_config(floats, request.config)};
  SimResult result;
  switch (request.config.output) {
    case PipelineOutput::floats:
      result = simulate_float(job);
      break;
    case PipelineOutput::floats_top_down:
      result = simulate_top_down(job);
      break;
    case PipelineOutput::streaming:
      result =
          request.config.collector == Collector::full ? simulate_streaming_full(job) : simulate_streaming_lazy(job);
      break;
  }
  result.output = describe_output(request.config);
  return result;
}

}  // namespace cbvh::testbench
