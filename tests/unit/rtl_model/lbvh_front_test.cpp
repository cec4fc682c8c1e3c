// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// The front of the LBVH builder as a whole: triangles in memory become sorted runs in memory, whose merge has the order
// of golden's tree.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "golden/build/lbvh.h"
#include "golden/build/morton.h"
#include "golden/scene/load.h"
#include "golden/scene/trouble_scenes.h"
#include "rtl_model/datapath/record_words.h"
#include "rtl_model/lbvh/box_builder.h"
#include "rtl_model/lbvh/morton_encoder.h"
#include "rtl_model/lbvh/primitive_reader.h"
#include "rtl_model/lbvh/run_sorter.h"
#include "rtl_model/lbvh/run_writer.h"
#include "tests/support/scene_memory.h"
#include "tests/support/stalling_port.h"
#include "vectors/convert.h"

namespace cbvh::rtl {
namespace {

struct Runs {
  std::vector<std::vector<SortRecord>> runs;
  std::uint64_t cycles = 0;
  std::uint64_t lines_written = 0;
};

Runs run_front(const golden::Mesh& mesh, const golden::Box& scene, std::size_t capacity,
               const testing::Disturbance& disturbance) {
  const std::uint64_t first_run_line = mesh.triangles.size();
  testing::StallingPort reading(disturbance, 0);
  testing::StallingPort writing(disturbance, 1);
  Channel<Primitive> primitives;
  Channel<PrimitiveBox> boxes;
  Channel<SortItem> items;
  Channel<SortItem> sorted;
  Channel<RunArea> areas;
  Channel<RunDescriptor> descriptors;
  PrimitiveReader reader(*reading.near().requests, *reading.near().answers, primitives, LineAddress(0),
                         mesh.triangles.size());
  BoxBuilder<MachineBits> builder(primitives, boxes);
  MortonEncoder<MachineBits> encoder(boxes, items, SceneBox{vectors::float_box(scene)});
  RunSorter<MachineBits> sorter(items, sorted, capacity);
  RunWriter writer(areas, sorted, *writing.near().requests, *writing.near().answers, descriptors);
  IdealLineMemory memory({reading.far(), writing.far()}, 1 << 20);
  testing::poke_primitives(memory.store, 0, mesh);
  Clock clock(reading, writing, primitives, boxes, items, sorted, areas, descriptors, reader, builder, encoder, sorter,
              writer, memory);
  areas.push({LineAddress(first_run_line), LineAddress(1)});
  std::vector<RunDescriptor> found;
  EXPECT_TRUE(testing::run_until(clock, disturbance, 10'000 + 100 * mesh.triangles.size(), [&] {
    if (descriptors.can_pop()) found.push_back(descriptors.pop());
    return !found.empty() && bool(found.back().last);
  }));
  EXPECT_EQ(encoder.first_refused(), std::nullopt);
  Runs result;
  result.cycles = clock.cycle();
  result.lines_written = memory.writes;
  for (const RunDescriptor& descriptor : found) {
    auto& run = result.runs.emplace_back();
    for (std::uint64_t i = 0; i < descriptor.records.value(); ++i) {
      const LineData line = memory.store.read(LineAddress(descriptor.first_line.value() + i / 2));
      run.push_back(record_at(line.words, i % 2));
    }
  }
  return result;
}

/// Runs are sorted; merged, the earlier run first, they are golden's records in golden's order.
void expect_golden_order(const golden::Mesh& mesh, const golden::FloatTree& tree, const Runs& found) {
  const auto boxes = golden::triangle_boxes(mesh);
  std::vector<std::tuple<std::uint64_t, std::size_t, std::size_t>> merged;
  for (std::size_t run = 0; run < found.runs.size(); ++run) {
    for (std::size_t i = 0; i < found.runs[run].size(); ++i) {
      const SortRecord& record = found.runs[run][i];
      const std::uint64_t id = record.id.value();
      ASSERT_LT(id, boxes.size());
      ASSERT_EQ(record.box, vectors::float_box(boxes[id]));
      ASSERT_EQ(record.code.value(), golden::morton_code(boxes[id], tree.scene));
      ASSERT_LE(found.runs[run][i == 0 ? 0 : i - 1].code.value(), record.code.value());
      merged.emplace_back(record.code.value(), run, i);
    }
  }
  std::sort(merged.begin(), merged.end());
  ASSERT_EQ(merged.size(), tree.primitive_ids.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    const auto [code, run, place] = merged[i];
    ASSERT_EQ(found.runs[run][place].id.value(), tree.primitive_ids[i] & ~golden::kLastOfLeaf) << i;
  }
}

TEST(LbvhFront, runs_of_small_scenes_merge_to_goldens_order_whatever_stalls) {
  std::size_t scenes = 0;
  for (const golden::Trouble trouble : golden::kTroubles) {
    const golden::Mesh mesh = golden::trouble_scene(trouble, 3, 70);
    const golden::FloatTree tree = golden::build_lbvh(mesh);
    for (const auto& disturbance : testing::stall_matrix()) {
      SCOPED_TRACE(golden::name_of(trouble));
      expect_golden_order(mesh, tree, run_front(mesh, tree.scene, 8, disturbance));
      if (HasFatalFailure()) return;
    }
    ++scenes;
  }
  EXPECT_GT(scenes, 5U);
}

TEST(LbvhFront, sorts_a_scene_of_65000_triangles_at_a_triangle_a_clock) {
  const golden::Mesh mesh = golden::load_scene("proc:cloth");
  const golden::FloatTree tree = golden::build_lbvh(mesh);
  const Runs found = run_front(mesh, tree.scene, kSorterCapacity, {});
  expect_golden_order(mesh, tree, found);
  EXPECT_LE(found.cycles, mesh.triangles.size() + kSorterCapacity + 80);
  EXPECT_LE(found.runs.size(), 1 + mesh.triangles.size() / kSorterCapacity);
  EXPECT_LE(found.lines_written, mesh.triangles.size() / 2 + found.runs.size());
}

}  // namespace
}  // namespace cbvh::rtl
