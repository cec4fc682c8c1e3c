// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/rtl/stream_tree.h"

#include "golden/input_error.h"
#include "golden/quantize/scale.h"
#include "testbench/rtl/run.h"
#include "vectors/convert.h"
#include "vectors/unit.h"

namespace cbvh::testbench {

namespace {

template <int N>
StreamedTree stream(const golden::FloatTree& floats, const StreamOptions& options) {
  StreamedTree result{golden::blank_compressed_tree(floats, options.rules, options.code), 0, 0};
  if (floats.pairs.empty()) return result;  // one leaf: nothing to compress
  const rtl::SceneRegisters registers = vectors::scene_registers(options.rules, options.code);
  std::vector<rtl::StreamJob> jobs;
  jobs.reserve(floats.pairs.size());
  for (std::size_t i = 0; i < floats.pairs.size(); ++i) jobs.push_back(vectors::stream_job(floats, i, registers));
  const StreamTrace<N> trace = run_stream<N>(options.collector, options.treelet, jobs, options.run, 0, false);
  if (trace.hung || trace.reports.empty())
    throw golden::InputError("stream_compressor", "hung: no report for the tree");
  const rtl::StreamReport& report = trace.reports[0].report;
  if (report.status != rtl::StatusBits()) {
    throw golden::InputError("stream_compressor", fmt::format("refused pair {} with status {}",
                                                              report.last_index.value(), report.status.value()));
  }
  if (trace.memory.size() < floats.pairs.size()) throw golden::InputError("stream_compressor", "wrote too few pairs");
  for (std::size_t i = 0; i < floats.pairs.size(); ++i)
    result.tree.pairs[i] = vectors::compressed_pair<N>(trace.memory[i]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.tree.root[axis] = {static_cast<int>(report.root[axis].scale.value()), report.root[axis].lower.value()};
  }
  result.repairs = report.repairs.value();
  result.cycles = trace.cycles - options.run.drain_cycles;
  return result;
}

}  // namespace

StreamedTree stream_tree(const golden::FloatTree& tree, const StreamOptions& options) {
  const int limit = golden::exactness_limit(tree.largest_magnitude);
  if (options.rules.min_scale < limit) {
    throw golden::InputError(
        "--min-scale",
        fmt::format(
            "{} is below the exactness limit of this scene, {}: the hardware refuses it; --streaming golden studies it",
            options.rules.min_scale, limit));
  }
  return vectors::with_bits(options.rules.bits, [&](auto n) { return stream<decltype(n)::value>(tree, options); });
}

}  // namespace cbvh::testbench
