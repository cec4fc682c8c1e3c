// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/sim/simulate_rays.h"

#include <cmath>

#include "golden/quantize/edge.h"
#include "golden/trace/compressed_view.h"
#include "golden/trace/traverse.h"
#include "golden/update/top_down.h"
#include "rtl_model/traverse/traversal_unit.h"
#include "testbench/rtl/leaf_answerer.h"
#include "testbench/rtl/ports.h"
#include "testbench/sim/accounts.h"
#include "testbench/sim/lbvh_simulation.h"
#include "testbench/sim/memory_map.h"
#include "testbench/sim/scene_image.h"
#include "vectors/ray_tree.h"

namespace cbvh::testbench {

namespace {

using golden::Hit;

/// The triangle unit beside the simulated one: the golden's test, and each ray's nearest hit so far.
class TriangleUnit {
 public:
  TriangleUnit(const golden::Mesh& mesh, const golden::FloatTree& tree, const std::vector<golden::Ray>& rays)
      : tracer_(golden::FloatTreeView(tree), mesh), rays_(rays), hits_(rays.size()) {}

  /// The hit's t rounded up: what lies at t itself must still be found, for a triangle with a lower number.
  rtl::LeafReply intersect(const rtl::RayCandidate& candidate) {
    const std::size_t number = candidate.number.value();
    const golden::Ray& ray = rays_[number];
    tracer_.test_triangle(static_cast<std::uint32_t>(candidate.primitive.value()), golden::PreparedRay(ray),
                          golden::TriangleTest(ray), hits_[number]);
    return {candidate.slot, rtl::Float32::of(-golden::round_down(-hits_[number].t)), {}};
  }
  const std::vector<Hit>& hits() const { return hits_; }

 private:
  golden::Tracer<golden::FloatTreeView> tracer_;
  const std::vector<golden::Ray>& rays_;
  std::vector<Hit> hits_;
};

/// The traversal unit with its links to the memory, and everything around it.
template <int N>
struct RayMachine {
  rtl::LineLink pairs;
  rtl::LineLink ids;
  rtl::Channel<rtl::RayJob> jobs;
  rtl::Channel<rtl::RayCandidate> candidates;
  rtl::Channel<rtl::LeafReply> replies;
  rtl::Channel<rtl::RayReport> reports;
  rtl::TraversalUnit<rtl::MachineBits, N> unit;
  struct Intersect {
    TriangleUnit* triangles;
    rtl::LeafReply operator()(const rtl::RayCandidate& candidate) const { return triangles->intersect(candidate); }
  };
  Source<rtl::RayJob> source;
  LeafAnswerer<Intersect> answerer;
  Sink<rtl::RayReport> sink;

  RayMachine(const rtl::RayTree<N>& tree, std::size_t slots, std::span<const rtl::RayJob> rays, TriangleUnit& triangles)
      : unit({jobs, candidates, replies, reports, pairs.port(), ids.port()}, tree, slots),
        source(jobs, rays, rtl::StallPattern::never()),
        answerer(candidates, replies, {&triangles}, SinkStalls::never()),
        sink(reports, SinkStalls::never()) {}

  auto parts() { return std::tie(pairs, ids, jobs, candidates, replies, reports, unit, source, answerer, sink); }
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("jobs", "driver", "ray_scheduler", jobs);
    visit("candidates", "ray_scheduler", "triangle_unit", candidates);
    visit("replies", "triangle_unit", "ray_scheduler", replies);
    visit("reports", "ray_scheduler", "driver", reports);
    pairs.channels("ray_scheduler", visit);
    ids.channels("ray_scheduler_ids", visit);
    unit.channels(visit);
  }
};

std::vector<rtl::RayJob> jobs_of(const std::vector<golden::Ray>& rays) {
  std::vector<rtl::RayJob> jobs;
  jobs.reserve(rays.size());
  for (const golden::Ray& ray : rays) {
    rtl::RayJob& job = jobs.emplace_back();
    job.number = rtl::UInt<rtl::kRayNumberBits>(jobs.size() - 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      job.origin[axis] = rtl::Float32::of(ray.origin[static_cast<int>(axis)]);
      job.direction[axis] = rtl::Float32::of(ray.direction[static_cast<int>(axis)]);
    }
    job.t_min = rtl::Float32::of(ray.t_min);
    job.t_max = rtl::Float32::of(ray.t_max);
  }
  return jobs;
}

/// The golden's hits on the float tree beside those of the unit, and what both traversals cost.
void compare(RaysResult& result, const std::vector<Hit>& found, const golden::Mesh& mesh,
             const golden::FloatTree& floats, const golden::CompressedTree& tree,
             const std::vector<golden::Ray>& rays) {
  golden::Tracer<golden::FloatTreeView> of_floats(golden::FloatTreeView(floats), mesh);
  golden::Tracer<golden::CompressedTreeView> of_cells(golden::CompressedTreeView(tree), mesh);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit want = of_floats.trace(rays[i], golden::Stop::closest);
    of_cells.trace(rays[i], golden::Stop::closest);
    result.hits += want.primitive != Hit::kNone;
    if (found[i] == want) continue;
    if (result.wrong++ == 0) {
      result.first_wrong = fmt::format("ray {}: found triangle {} at {}, want {} at {}", i, found[i].primitive,
                                       found[i].t, want.primitive, want.t);
    }
  }
  result.float_pairs = of_floats.counts().pairs;
  result.float_triangles = of_floats.counts().triangle_tests;
  result.exact_pairs = of_cells.counts().pairs;
}

void add_reports(RaysResult& result, const std::vector<rtl::RayReport>& reports) {
  for (const rtl::RayReport& report : reports) {
    if (report.status != rtl::StatusBits()) {
      throw golden::InputError(result.scene,
                               fmt::format("the unit refused ray {} with status {} at pair {}", report.number.value(),
                                           report.status.value(), report.place.value()));
    }
    result.pairs += report.pairs.value();
    result.leaves += report.leaves.value();
  }
}

}  // namespace

RaysResult simulate_rays(const golden::Mesh& mesh, const golden::FloatTree& floats,
                         const std::vector<golden::Ray>& rays, unsigned slots, const SimRequest& request) {
  check_sim_config(request.config);
  constexpr unsigned kMostSlots = 1U << rtl::kRaySlotBits;
  if (slots < 1 || slots > kMostSlots) {
    throw golden::InputError("--slots", fmt::format("found {}, want 1..{}", slots, kMostSlots));
  }
  if (rays.empty()) throw golden::InputError(mesh.name, "no rays: the camera's rays hit nothing");
  const SimConfig& config = request.config;
  const golden::GridRules rules{static_cast<int>(config.bits), checked_min_scale(config, floats), config.scale_rule};
  const golden::CompressedTree tree = golden::compress_top_down(floats, rules, config.code);
  return with_simulated_bits(config.bits, [&]<int N>(std::integral_constant<int, N>) {
    MemoryMap map(std::uint64_t{config.dram.row_bytes} * config.dram.channels / 64, config.dram.capacity_bytes);
    const std::uint64_t pairs_line = map.add("node pairs", 16 * tree.pairs.size());
    const std::uint64_t ids_line = map.add("the primitive-ID array", 4 * tree.primitive_ids.size());
    TriangleUnit triangles(mesh, floats, rays);
    const std::vector<rtl::RayJob> jobs = jobs_of(rays);
    RayMachine<N> machine(vectors::ray_tree<N>(tree, pairs_line, ids_line), slots, jobs, triangles);
    PortStalls stalls({machine.pairs.port(), machine.ids.port()}, request.machine.stalls);
    SimMemory memory(config, stalls.ports(), request.trace_path);
    store_pairs(tree, pairs_line, memory.store());
    store_ids(tree.primitive_ids, ids_line, memory.store());
    const MachineRun run = run_machine(
        machine, stalls, memory, request.machine, rays.size(),
        [&] { return machine.sink.items.size() == rays.size() && memory.idle(); },
        [&] { return machine.sink.items.size(); });
    memory.finish();

    RaysResult result;
    result.scene = mesh.name;
    result.rays = rays.size();
    result.tree_pairs = tree.pairs.size();
    add_reports(result, machine.sink.items);
    result.candidates = machine.answerer.met.size();
    result.pair_lines = memory.port_accesses(0).reads;
    result.id_lines = memory.port_accesses(1).reads;
    result.cycles = run.cycles;
    result.bound_cycles = memory.bound_cycles();
    result.clock_mhz = config.dram.core_clock_mhz;
    result.seconds = run.seconds;
    result.memory = memory.statistics();
    result.utilisation = run.utilisation;
    compare(result, triangles.hits(), mesh, floats, tree, rays);
    return result;
  });
}

}  // namespace cbvh::testbench
