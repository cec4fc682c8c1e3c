// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/tree/digest.h"
#include "golden/update/streaming.h"
#include "golden/update/top_down.h"
#include "rtl_model/lbvh/streaming_output.h"
#include "testbench/sim/lbvh_simulation.h"

namespace cbvh::testbench {

/// Reads a compressed tree back from the simulated memory and compares it with the golden's top-down one.
inline void compare_compressed(SimResult& result, const golden::FloatTree& floats, const SimConfig& config,
                               rtl::LineAddress pairs, rtl::LineAddress ids, const rtl::Context& root,
                               const rtl::LineStore& store) {
  const golden::GridRules rules{static_cast<int>(config.bits), result.min_scale, config.scale_rule};
  const golden::CompressedTree wanted = golden::compress_top_down(floats, rules, config.code);
  golden::CompressedTree found = golden::blank_compressed_tree(floats, rules, config.code);
  found.pairs = load_pairs(pairs.value(), result.pairs, store);
  found.primitive_ids = load_ids(ids.value(), found.primitive_ids.size(), store);
  for (std::size_t axis = 0; axis < 3 && result.pairs > 0; ++axis) {
    found.root[axis] = {static_cast<int>(root[axis].scale.value()), root[axis].lower.value()};
  }
  result.difference = first_difference(wanted, found);
  result.digest = fmt::format("{:016x}", golden::digest(found));
  result.golden_digest = fmt::format("{:016x}", golden::digest(wanted));
  result.tree = std::move(found);
}

/// The report of the compressor. Throws InputError when it refused the tree.
inline rtl::StreamReport accepted(const std::string& scene, const rtl::StreamReport& report) {
  if (report.status == rtl::StatusBits()) return report;
  throw golden::InputError(scene, fmt::format("the compressor refused pair {} with status {}",
                                              report.last_index.value(), report.status.value()));
}
template <class Output>
rtl::StreamReport accepted_report(const LbvhJob& job, const SimResult& result, const LbvhOutcome<Output>& outcome) {
  return result.pairs == 0 ? rtl::StreamReport() : accepted(job.mesh.name, outcome.pipeline.output().report());
}

/// The row of the node writer: pairs and repairs.
template <class Writer>
void add_node_traffic(SimResult& result, const PortAccesses& accesses, const Writer& writer) {
  const std::uint64_t full_lines = (result.pairs + 3) / 4;
  const std::uint64_t model = 16 * result.pairs + 128 * result.repairs;
  const std::uint64_t accounted = 64 * (writer.lines_written + writer.lines_read);
  add_traffic(
      result, "pairs and repairs", accesses, model, accounted,
      fmt::format("{} lines of pairs want {} writes, made {}; {} repairs want {} reads, made {}: lines leave in "
                  "parts, repairs merge on chip",
                  full_lines, full_lines + result.repairs, writer.lines_written, result.repairs, result.repairs,
                  writer.lines_read));
}

template <template <class, int> class Collector>
SimResult simulate_streaming(const LbvhJob& job) {
  const SimConfig& config = job.request.config;
  return with_simulated_bits(config.bits, [&]<int N>(std::integral_constant<int, N>) {
    using Output = rtl::StreamingOutput<rtl::MachineBits, N, Collector>;
    return run_lbvh<Output>(job, [&](SimResult& result, const auto& outcome) {
      const rtl::StreamReport report = accepted_report(job, result, outcome);
      compare_compressed(result, job.floats, config, job.config.pairs, job.config.ids, report.root, outcome.store);
      result.repairs = report.repairs.value();
      result.golden_repairs =
          golden::compress_streaming(job.floats, result.tree->rules, config.code, static_cast<int>(config.treelet))
              .counts.backtracks;
      add_node_traffic(result, outcome.ports.at("node_writer"), outcome.pipeline.output().writer());
    });
  });
}

}  // namespace cbvh::testbench
