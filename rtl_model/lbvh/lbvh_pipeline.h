// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "rtl_model/lbvh/box_builder.h"
#include "rtl_model/lbvh/hierarchy_emitter.h"
#include "rtl_model/lbvh/id_writer.h"
#include "rtl_model/lbvh/item_selector.h"
#include "rtl_model/lbvh/morton_encoder.h"
#include "rtl_model/lbvh/pipeline_config.h"
#include "rtl_model/lbvh/primitive_reader.h"
#include "rtl_model/lbvh/run_merger.h"
#include "rtl_model/lbvh/run_sorter.h"
#include "rtl_model/lbvh/run_writer.h"

namespace cbvh::rtl {

/// The whole builder: triangles in memory become node pairs and a primitive-ID array in memory. First all primitives
/// are read, coded, and written as sorted runs; then the runs are merged, and the hierarchy leaves in emission order
/// while they are. `Output` takes the float pairs from there: float_output.h, top_down_output.h, streaming_output.h.
/// One scene, from reset. Paper section 5.3; the builder is [VKJ*15]'s.
template <class Bits, class Output>
class LbvhPipeline {
 public:
  explicit LbvhPipeline(const LbvhConfig& config)
      : reader_(reader_link_.requests, reader_link_.answers, primitives_, config.primitives, config.count,
                config.reader_outstanding),
        box_builder_(primitives_, boxes_),
        encoder_(boxes_, coded_, config.scene),
        sorter_(coded_, runs_, config.sorter_records),
        selector_(runs_, rewritten_, to_write_),
        areas_source_(areas_, config.run_areas),
        run_writer_(areas_, to_write_, writer_link_.requests, writer_link_.answers, descriptors_),
        merger_(descriptors_, merger_link_.requests, merger_link_.answers, sorted_, rewritten_, config.merge),
        emitter_(sorted_, jobs_, ids_, emit_reports_, config.registers),
        id_writer_(ids_, id_link_.requests, id_link_.answers, id_reports_, config.ids),
        output_(jobs_, config) {}

  auto parts() {
    return std::tie(reader_link_, reader_, primitives_, box_builder_, boxes_, encoder_, coded_, sorter_, runs_,
                    selector_, to_write_, areas_source_, areas_, run_writer_, writer_link_, descriptors_, merger_link_,
                    merger_, rewritten_, sorted_, emitter_, jobs_, ids_, emit_reports_, id_writer_, id_link_,
                    id_reports_, output_);
  }

  template <class Visit>
  void channels(Visit&& visit) const {
    reader_link_.channels("primitive_reader", visit);
    visit("primitives", "primitive_reader", "box_builder", primitives_);
    visit("boxes", "box_builder", "morton_encoder", boxes_);
    visit("items", "morton_encoder", "run_sorter", coded_);
    visit("sorted", "run_sorter", "item_selector", runs_);
    visit("items", "item_selector", "run_writer", to_write_);
    writer_link_.channels("run_writer", visit);
    visit("runs", "run_writer", "run_merger", descriptors_);
    merger_link_.channels("run_merger", visit);
    visit("rewritten", "run_merger", "item_selector", rewritten_);
    visit("sorted", "run_merger", "hierarchy_emitter", sorted_);
    visit("jobs", "hierarchy_emitter", Output::kFirstModule, jobs_);
    visit("ids", "hierarchy_emitter", "id_writer", ids_);
    id_link_.channels("id_writer", visit);
    output_.channels(visit);
  }

  /// Ports of the memory, in the order in which it must be given them.
  std::vector<NamedPort> ports() {
    std::vector<NamedPort> ports = {{"primitive_reader", reader_link_.port()},
                                    {"run_writer", writer_link_.port()},
                                    {"run_merger", merger_link_.port()},
                                    {"id_writer", id_link_.port()}};
    for (const NamedPort& port : output_.ports()) ports.push_back(port);
    return ports;
  }

  /// Everything is in memory. A scene that is a single leaf has no pairs, so nothing to wait for at the output.
  bool done() const {
    return emit_reports_.can_pop() && id_reports_.can_pop() &&
           (emit_reports_.front().pairs.value() == 0 || output_.done());
  }

  const EmitReport& emit_report() const { return emit_reports_.front(); }
  const Output& output() const { return output_; }
  const MortonEncoder<Bits>& morton_encoder() const { return encoder_; }
  const RunWriter& run_writer() const { return run_writer_; }
  /// So far: records given to the run writer by the sorter and again by earlier passes, and records merged.
  std::uint64_t records_sorted() const { return runs_.pops(); }
  std::uint64_t records_rewritten() const { return rewritten_.pops(); }
  std::uint64_t records_merged() const { return sorted_.pops(); }
  std::uint64_t runs() const { return descriptors_.pops(); }
  /// The run writer takes the next area as soon as it has written a pass.
  std::uint64_t merge_passes() const { return areas_.pops() - 1; }

 private:
  LineLink reader_link_;
  LineLink writer_link_;
  LineLink merger_link_;
  LineLink id_link_;
  Channel<Primitive> primitives_;
  Channel<PrimitiveBox> boxes_;
  Channel<SortItem> coded_;
  Channel<SortItem> runs_;
  Channel<SortItem> rewritten_;
  Channel<SortItem> to_write_;
  Channel<RunArea> areas_;
  Channel<RunDescriptor> descriptors_;
  Channel<SortItem> sorted_;
  Channel<StreamJob> jobs_;
  Channel<IdEntry> ids_;
  Channel<EmitReport> emit_reports_;
  Channel<WriteReport> id_reports_;
  PrimitiveReader reader_;
  BoxBuilder<Bits> box_builder_;
  MortonEncoder<Bits> encoder_;
  RunSorter<Bits> sorter_;
  ItemSelector selector_;
  AreaSequencer areas_source_;
  RunWriter run_writer_;
  RunMerger<Bits> merger_;
  HierarchyEmitter<Bits> emitter_;
  IdWriter id_writer_;
  Output output_;
};

}  // namespace cbvh::rtl
