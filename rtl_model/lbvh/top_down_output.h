// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "rtl_model/compress/top_down_compressor.h"
#include "rtl_model/lbvh/float_node_writer.h"
#include "rtl_model/lbvh/pipeline_config.h"

namespace cbvh::rtl {

/// Starts the top-down pass when the float tree is in memory.
class TopDownStarter {
 public:
  TopDownStarter(Channel<WriteReport>& written, Channel<TopDownCommand>& commands, const SceneRegisters& registers)
      : written_(written), commands_(commands), registers_(registers) {}

  void tick() {
    if (written_.can_pop() && commands_.can_push()) commands_.push({written_.pop().items, registers_});
  }
  void commit(CommitKey) {}

 private:
  Channel<WriteReport>& written_;
  Channel<TopDownCommand>& commands_;
  const SceneRegisters registers_;
};

/// The LBVH pipeline's output for a float build that is compressed top-down afterwards: the baseline. Paper table 2,
/// second column.
template <class Bits, int N>
class TopDownOutput {
 public:
  static constexpr const char* kFirstModule = "float_node_writer";

  TopDownOutput(Channel<StreamJob>& jobs, const LbvhConfig& config)
      : writer_(jobs, float_link_.requests, float_link_.answers, written_, config.float_pairs),
        starter_(written_, commands_, config.registers),
        compressor_(commands_, read_link_.port(), write_link_.port(), reports_, {config.float_pairs, config.pairs}) {}

  auto parts() {
    return std::tie(writer_, float_link_, written_, starter_, commands_, compressor_, read_link_, write_link_,
                    reports_);
  }
  template <class Visit>
  void channels(Visit&& visit) const {
    float_link_.channels("float_node_writer", visit);
    visit("written", "float_node_writer", "top_down_starter", written_);
    visit("commands", "top_down_starter", "top_down_scheduler", commands_);
    read_link_.channels("top_down_scheduler", visit);
    write_link_.channels("top_down_scheduler", visit);
    compressor_.channels(visit);
  }
  std::vector<NamedPort> ports() {
    return {{"float_node_writer", float_link_.port()},
            {"top_down_read", read_link_.port()},
            {"top_down_write", write_link_.port()}};
  }
  bool done() const { return reports_.can_pop(); }
  const StreamReport& report() const { return reports_.front(); }

 private:
  LineLink float_link_;
  LineLink read_link_;
  LineLink write_link_;
  Channel<WriteReport> written_;
  Channel<TopDownCommand> commands_;
  Channel<StreamReport> reports_;
  FloatNodeWriter writer_;
  TopDownStarter starter_;
  TopDownCompressor<Bits, N> compressor_;
};

}  // namespace cbvh::rtl
