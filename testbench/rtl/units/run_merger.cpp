// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/lbvh/run_merger.h"

#include "rtl_model/lbvh/run_writer.h"
#include "testbench/rtl/counting_bits.h"
#include "testbench/rtl/in_out_bench.h"
#include "testbench/rtl/line_memory.h"
#include "vectors/units/run_merger.h"

namespace cbvh::testbench {

namespace {

constexpr std::uint64_t kScene = 5;             ///< the line where the runs begin
constexpr std::uint64_t kLinesAPass = 1 << 12;  ///< further lines for each pass that goes back to memory
constexpr std::uint64_t kPasses = kMemoryLines / kLinesAPass - 1;

/// Passes the runs of the scene on, then those of later passes.
class JoinRuns {
 public:
  JoinRuns(rtl::Channel<rtl::RunDescriptor>& scene, rtl::Channel<rtl::RunDescriptor>& rewritten,
           rtl::Channel<rtl::RunDescriptor>& both)
      : scene_(scene), rewritten_(rewritten), both_(both) {}
  void tick() {
    if (!both_.can_push()) return;
    if (scene_.can_pop()) {
      both_.push(scene_.pop());
    } else if (rewritten_.can_pop()) {
      both_.push(rewritten_.pop());
    }
  }
  void commit(rtl::CommitKey) {}

 private:
  rtl::Channel<rtl::RunDescriptor>& scene_;
  rtl::Channel<rtl::RunDescriptor>& rewritten_;
  rtl::Channel<rtl::RunDescriptor>& both_;
};

/// Notes what is taken out of a channel.
class ItemMonitor {
 public:
  explicit ItemMonitor(const rtl::Channel<rtl::SortItem>& channel) : channel_(channel) {}
  void commit(rtl::CommitKey) {
    if (channel_.pops() != items.size()) items.push_back(channel_.last_popped());
  }

  std::vector<rtl::SortItem> items;

 private:
  const rtl::Channel<rtl::SortItem>& channel_;
};

/// Writes the runs from kScene on, and tells where they lie.
std::vector<rtl::RunDescriptor> store_runs(std::span<const rtl::SortItem> items, rtl::LineStore& store) {
  std::vector<rtl::RunDescriptor> runs;
  std::uint64_t line = kScene;
  std::uint64_t records = 0;
  for (const rtl::SortItem& item : items) {
    rtl::LineWords words{};
    rtl::put_record(item.record, words, 0);
    const std::uint64_t first = line * rtl::kWordsPerLine + records++ * rtl::kWordsPerRecord;
    for (std::size_t i = 0; i < rtl::kWordsPerRecord; ++i) {
      store.poke(first + i, static_cast<std::uint32_t>(words[i].value()));
    }
    if (!item.last_of_run && !item.last) continue;
    runs.push_back({rtl::LineAddress(line), rtl::UInt<rtl::kPointerBits + 1>(records), item.last});
    line += (records + 1) / rtl::kRecordsPerLine;
    records = 0;
  }
  return runs;
}

bool run_scene(std::span<const rtl::SortItem> items, const RunOptions& options, std::uint64_t number,
               Responses& responses) {
  rtl::Channel<rtl::RunDescriptor> scene_runs;
  rtl::Channel<rtl::RunDescriptor> new_runs;
  rtl::Channel<rtl::RunDescriptor> runs;
  rtl::Channel<rtl::RunArea> areas;
  rtl::Channel<rtl::LineRequest> reads;
  rtl::Channel<rtl::LineRequest> writes;
  rtl::Channel<rtl::LineData> answers;
  rtl::Channel<rtl::LineData> acknowledgements;
  rtl::Channel<rtl::SortItem> sorted;
  rtl::Channel<rtl::SortItem> rewritten;
  rtl::RunMerger<CountingBits> unit(runs, reads, answers, sorted, rewritten, vectors::kMergerConfig);
  rtl::RunWriter writer(areas, rewritten, writes, acknowledgements, new_runs);
  auto memory = make_line_memory({{&reads, &answers}, {&writes, &acknowledgements}}, options, number);
  const std::vector<rtl::RunDescriptor> descriptors = store_runs(items, memory.store);
  std::vector<rtl::RunArea> passes;
  for (std::uint64_t pass = 1; pass <= kPasses; ++pass) passes.push_back({rtl::LineAddress(pass * kLinesAPass), {}});
  AcceptanceMonitor<rtl::RunDescriptor> acceptance(runs);
  ItemMonitor went_back(rewritten);
  Source<rtl::RunDescriptor> source(scene_runs, descriptors, source_stalls(options, number));
  Source<rtl::RunArea> area_source(areas, passes, source_stalls(options, number + 1));
  JoinRuns join(scene_runs, new_runs, runs);
  Sink<rtl::SortItem> sink(sorted, sink_stalls(options, number));
  rtl::Clock clock(source, area_source, scene_runs, new_runs, areas, join, runs, acceptance, unit, writer, reads,
                   writes, answers, acknowledgements, memory, sorted, rewritten, went_back, sink);
  Runner runner(clock, options);
  const bool finished =
      runner.run_until([&] { return sink.items.size() >= items.size(); },
                       [&] { return runs.pops() + memory.reads + rewritten.pops() + sink.items.size(); });
  runner.drain();
  for (const rtl::SortItem& item : went_back.items) {
    const vectors::MergeEvent event{rtl::UInt<1>(1), item};
    responses.add(&event, vectors::kLatencyNotStated);
  }
  for (std::size_t i = 0; i < sink.items.size(); ++i) {
    const vectors::MergeEvent event{{}, sink.items[i]};
    responses.add(&event, to_latency(acceptance.first(), sink.cycles[i]));
  }
  responses.cycles += clock.cycle();
  return finished;
}

}  // namespace

UnitDriver run_merger_driver() {
  return {"run_merger", [](const vectors::VectorSet& set, const RunOptions& options) {
            Responses responses(sizeof(vectors::MergeEvent));
            for (std::size_t index = 0; index < set.size(); ++index) {
              const auto items = typed_stimuli<rtl::SortItem, vectors::MergeEvent>(set, set.stimulus_range(index));
              responses.end_case(!run_scene(items, options, set.head(index).id, responses));
            }
            return responses;
          }};
}

}  // namespace cbvh::testbench
