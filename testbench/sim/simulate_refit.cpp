// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/refit.h"

#include "golden/quantize/scale.h"
#include "rtl_model/compress/lazy_treelet_collector.h"
#include "rtl_model/compress/treelet_collector.h"
#include "rtl_model/refit/refit_unit.h"
#include "testbench/sim/memory_map.h"
#include "testbench/sim/streaming_simulation.h"
#include "vectors/convert.h"

namespace cbvh::testbench {

namespace {

/// The refit unit with its links to the memory, and the driver's two channels.
template <int N, template <class, int> class Collector>
struct RefitMachine {
  rtl::LineLink tree;
  rtl::LineLink ids;
  rtl::LineLink primitives;
  rtl::LineLink nodes;
  rtl::Channel<rtl::RefitCommand> commands;
  rtl::Channel<rtl::RefitReport> reports;
  rtl::RefitUnit<rtl::MachineBits, N, Collector> unit;

  explicit RefitMachine(const rtl::RefitConfig& config)
      : unit(commands, reports, {tree.port(), ids.port(), primitives.port(), nodes.port()}, config) {}

  auto parts() { return std::tie(tree, ids, primitives, nodes, commands, reports, unit); }
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("commands", "driver", "refit_control", commands);
    tree.channels("tree_reader", visit);
    ids.channels("id_reader", visit);
    primitives.channels("primitive_gatherer", visit);
    nodes.channels("node_writer", visit);
    unit.channels(visit);
  }
  std::vector<rtl::NamedPort> ports() {
    return {{"tree_reader", tree.port()},
            {"id_reader", ids.port()},
            {"primitive_gatherer", primitives.port()},
            {"node_writer", nodes.port()}};
  }
};

/// A float tree of the same shape, for the golden to refit.
golden::FloatTree shape_of(const golden::CompressedTree& tree) {
  golden::FloatTree shape;
  shape.primitive_ids = tree.primitive_ids;
  shape.leaves = tree.leaves;
  shape.primitives = tree.primitives;
  for (const golden::CompressedPair& pair : tree.pairs) {
    shape.pairs.push_back(
        {{}, {pair.child[0].leaf, pair.child[1].leaf}, {pair.child[0].pointer, pair.child[1].pointer}});
  }
  return shape;
}

struct RefitJob {
  const golden::CompressedTree& tree;
  const golden::Mesh& mesh;
  const golden::FloatTree& floats;  ///< the golden's, refitted
  const SimRequest& request;
  SimConfig config;  ///< with the tree's N, code and scale rule
  int min_scale;
};

void add_refit_traffic(SimResult& result, const ModuleAccesses& ports, std::uint64_t gathered_lines) {
  const std::uint64_t n = result.triangles;
  const std::uint64_t pair_bytes = 16 * result.pairs;
  add_traffic(result, "old pairs read", ports.at("tree_reader"), pair_bytes, whole_lines(pair_bytes), "the last line");
  add_traffic(result, "primitive IDs read", ports.at("id_reader"), 4 * n, whole_lines(4 * n), "the last line");
  add_traffic(result, "primitives read", ports.at("primitive_gatherer"), 40 * n, 64 * gathered_lines,
              fmt::format("{} whole lines, each read again when its place was taken in between", gathered_lines));
}

template <template <class, int> class Collector>
SimResult refit(const RefitJob& job) {
  return with_simulated_bits(job.config.bits, [&]<int N>(std::integral_constant<int, N>) {
    SimResult result;
    const std::uint64_t n = job.floats.primitives;
    MemoryMap map(std::uint64_t{job.config.dram.row_bytes} * job.config.dram.channels / 64,
                  job.config.dram.capacity_bytes);
    rtl::RefitConfig config;
    config.addresses.primitives = rtl::LineAddress(map.add("primitives", 40 * n));
    config.addresses.ids = rtl::LineAddress(map.add("the primitive-ID array", 4 * n));
    config.addresses.pairs = rtl::LineAddress(map.add("node pairs", 16 * job.tree.pairs.size()));
    config.treelet_levels = static_cast<int>(job.config.treelet);
    config.outstanding = job.config.reader_outstanding;
    config.gatherer.held_lines = job.config.gather_lines;
    config.gatherer.outstanding = job.config.gather_outstanding;
    config.gatherer.queue = job.config.gather_queue;
    config.written_lines = job.config.combining_lines;
    RefitMachine<N, Collector> machine(config);
    const auto named_ports = machine.ports();
    PortStalls stalls(unnamed(named_ports), job.request.machine.stalls);
    SimMemory memory(job.config, stalls.ports(), job.request.trace_path);
    store_primitives(job.mesh, config.addresses.primitives.value(), memory.store());
    store_ids(job.tree.primitive_ids, config.addresses.ids.value(), memory.store());
    store_pairs(job.tree, config.addresses.pairs.value(), memory.store());
    const golden::GridRules rules{N, job.min_scale, job.config.scale_rule};
    machine.commands.push(
        {rtl::ItemCount(job.tree.pairs.size()), rtl::ItemCount(n), vectors::scene_registers(rules, job.config.code)});

    const MachineRun run = run_machine(
        machine, stalls, memory, job.request.machine, n, [&] { return machine.reports.can_pop() && memory.idle(); },
        [&] { return std::min<std::uint64_t>(n, machine.ids.answers.pops() * rtl::kWordsPerLine); });
    memory.finish();
    const rtl::RefitReport report = machine.reports.front();
    if (report.walk != rtl::WalkReport()) {
      throw golden::InputError(job.mesh.name, fmt::format("the tree does not belong to the primitives: fault {} at {}",
                                                          report.walk.fault.value(), report.walk.place.value()));
    }
    result.scene = job.mesh.name;
    result.output = "refit " + describe_output(job.config);
    result.triangles = n;
    result.leaves = job.tree.leaves;
    result.pairs = job.tree.pairs.size();
    result.min_scale = job.min_scale;
    add_run(result, run, job.config, memory);
    compare_compressed(result, job.floats, job.config, config.addresses.pairs, config.addresses.ids,
                       accepted(job.mesh.name, report.tree).root, memory.store());
    result.identical = result.difference.empty();
    result.repairs = report.tree.repairs.value();
    result.golden_repairs =
        golden::compress_streaming(job.floats, rules, job.config.code, static_cast<int>(job.config.treelet))
            .counts.backtracks;
    const ModuleAccesses accesses = module_accesses(named_ports, memory);
    add_refit_traffic(result, accesses, machine.unit.gatherer().lines_read);
    add_node_traffic(result, accesses.at("node_writer"), machine.unit.writer());
    result.baseline_bytes = golden::update_traffic(n, result.pairs, 0).refit.baseline_bytes;
    return result;
  });
}

}  // namespace

SimResult simulate_refit(const golden::CompressedTree& tree, const golden::Mesh& mesh, const SimRequest& request) {
  SimConfig config = request.config;
  config.output = PipelineOutput::streaming;
  config.bits = static_cast<unsigned>(tree.rules.bits);
  config.code = tree.code;
  config.scale_rule = tree.rules.scale_rule;
  check_sim_config(config);
  check_triangles(mesh.name, mesh.triangles.size(), config);
  if (tree.pairs.empty()) throw golden::InputError(mesh.name, "the tree is one leaf: there is nothing to refit");
  const golden::FloatTree floats = golden::refit(shape_of(tree), mesh);
  const RefitJob job{tree, mesh, floats, request, config, checked_min_scale(config, floats)};
  return config.collector == Collector::full ? refit<rtl::TreeletCollector>(job)
                                             : refit<rtl::LazyTreeletCollector>(job);
}

}  // namespace cbvh::testbench
