// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/compress/stream_compressor.h"
#include "rtl_model/lbvh/box_builder.h"
#include "rtl_model/memory/node_writer.h"
#include "rtl_model/refit/id_reader.h"
#include "rtl_model/refit/primitive_gatherer.h"
#include "rtl_model/refit/refit_control.h"
#include "rtl_model/refit/refit_walker.h"
#include "rtl_model/refit/tree_reader.h"

namespace cbvh::rtl {

struct RefitConfig {
  RefitAddresses addresses;
  int treelet_levels = 4;        ///< D
  std::size_t outstanding = 16;  ///< reads in flight at each of the sequential ports
  GathererConfig gatherer;
  std::size_t written_lines = 128;  ///< held for combining writes
};

/// A refit's ports to memory.
struct RefitPorts {
  LinePort tree;
  LinePort ids;
  LinePort primitives;
  LinePort nodes;
};

/// Wald's refit as a stream: reads an existing compressed tree, the IDs and the primitives where they are now, and
/// leaves the compressed tree with the new boxes in the old one's place. The result equals the top-down compression of
/// the refitted float tree bit for bit. The scene's registers are the new scene's (driver's work, as the paper has it).
/// A tree that is one leaf has no pairs and is not refitted here. Memory accesses: those of the paper's section 5.2.
///
/// In place without a hazard, whatever memory does: of the old pairs only the tree reader reads, each line once. Pair i
/// is sent on only when the whole line it lies in has arrived here. Pair i is written, final or repaired, only after
/// the walker has taken it from that line, and a request that writes to a line writes only such pairs. So a write to a
/// line comes after its only read has been answered; treelets and write combining delay writes further. Repairs read
/// what this tree has written: these reads go through the node writer's port, behind the writes.
template <class Bits, int N, template <class, int> class Collector = TreeletCollector>
class RefitUnit {
 public:
  RefitUnit(Channel<RefitCommand>& commands, Channel<RefitReport>& reports, const RefitPorts& ports,
            const RefitConfig& config)
      : control_(commands, tree_commands_, id_commands_, primitive_commands_, starts_, walked_, written_, reports,
                 config.addresses),
        tree_reader_(tree_commands_, ports.tree, topology_, config.outstanding),
        id_reader_(id_commands_, ports.ids, ids_, config.outstanding),
        gatherer_(primitive_commands_, ids_, ports.primitives, primitives_, marks_, config.gatherer),
        box_builder_(primitives_, boxes_),
        walker_(starts_, topology_, boxes_, marks_, jobs_, walked_),
        compressor_(jobs_, requests_, lines_, compressed_, config.treelet_levels),
        writer_(requests_, lines_, compressed_, ports.nodes, written_, {config.addresses.pairs, config.written_lines}) {
  }

  auto parts() {
    return std::tie(control_, tree_commands_, id_commands_, primitive_commands_, starts_, tree_reader_, topology_,
                    id_reader_, ids_, gatherer_, primitives_, marks_, box_builder_, boxes_, walker_, walked_, jobs_,
                    compressor_, requests_, lines_, compressed_, writer_, written_);
  }

  /// The channels between the parts (rtl_model/kernel/netlist.h).
  template <class Visit>
  void channels(Visit&& visit) const {
    visit("tree_commands", "refit_control", "tree_reader", tree_commands_);
    visit("id_commands", "refit_control", "id_reader", id_commands_);
    visit("primitive_commands", "refit_control", "primitive_gatherer", primitive_commands_);
    visit("starts", "refit_control", "refit_walker", starts_);
    visit("topology", "tree_reader", "refit_walker", topology_);
    visit("ids", "id_reader", "primitive_gatherer", ids_);
    visit("primitives", "primitive_gatherer", "box_builder", primitives_);
    visit("marks", "primitive_gatherer", "refit_walker", marks_);
    visit("boxes", "box_builder", "refit_walker", boxes_);
    visit("jobs", "refit_walker", "treelet_collector", jobs_);
    compressor_.channels(visit);
    visit("requests", "line_combiner", "node_writer", requests_);
    visit("lines", "node_writer", "backtrack_unit", lines_);
    visit("compressed", "line_combiner", "node_writer", compressed_);
    visit("walked", "refit_walker", "refit_control", walked_);
    visit("written", "node_writer", "refit_control", written_);
  }

  const PrimitiveGatherer<Bits>& gatherer() const { return gatherer_; }
  const NodeWriter<Bits, N>& writer() const { return writer_; }

 private:
  Channel<ReadCommand> tree_commands_;
  Channel<ReadCommand> id_commands_;
  Channel<ReadCommand> primitive_commands_;
  Channel<SceneRegisters> starts_;
  Channel<TopologyPair> topology_;
  Channel<IdEntry> ids_;
  Channel<Primitive> primitives_;
  Channel<LeafMark> marks_;
  Channel<PrimitiveBox> boxes_;
  Channel<StreamJob> jobs_;
  Channel<MemoryRequest<N>> requests_;
  Channel<MemoryLine<N>> lines_;
  Channel<StreamReport> compressed_;
  Channel<StreamReport> written_;
  Channel<WalkReport> walked_;
  RefitControl control_;
  TreeReader tree_reader_;
  IdReader id_reader_;
  PrimitiveGatherer<Bits> gatherer_;
  BoxBuilder<Bits> box_builder_;
  RefitWalker<Bits> walker_;
  StreamCompressor<Bits, N, Collector> compressor_;
  NodeWriter<Bits, N> writer_;
};

}  // namespace cbvh::rtl
