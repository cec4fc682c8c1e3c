// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/refit_payloads.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Where a refit finds its arrays, each from the beginning of a line on.
struct RefitAddresses {
  LineAddress pairs;       ///< packed node pairs; the new ones take the old ones' places
  LineAddress ids;         ///< the primitive-ID array
  LineAddress primitives;  ///< ten words each
};

/// Starts the readers and the walker of a refit, and joins their two reports: that of the walk, and that of the
/// compressor once memory has everything. A tree at a time.
class RefitControl {
 public:
  RefitControl(Channel<RefitCommand>& commands, Channel<ReadCommand>& tree, Channel<ReadCommand>& ids,
               Channel<ReadCommand>& primitives, Channel<SceneRegisters>& starts, Channel<WalkReport>& walked,
               Channel<StreamReport>& written, Channel<RefitReport>& reports, const RefitAddresses& addresses)
      : commands_(commands),
        tree_(tree),
        ids_(ids),
        primitives_(primitives),
        starts_(starts),
        walked_(walked),
        written_(written),
        reports_(reports),
        addresses_(addresses) {}

  void tick() {
    if (running_) {
      if (!walked_.can_pop() || !written_.can_pop() || !reports_.can_push()) return;
      reports_.push({written_.pop(), walked_.pop()});
      running_ = false;
    } else if (commands_.can_pop()) {  // everything is idle: there is room for a command
      const RefitCommand& command = commands_.pop();
      tree_.push({addresses_.pairs, command.pairs});
      ids_.push({addresses_.ids, command.primitives});
      primitives_.push({addresses_.primitives, command.primitives});
      starts_.push(command.registers);
      running_ = true;
    }
  }
  void commit(CommitKey) {}

 private:
  Channel<RefitCommand>& commands_;
  Channel<ReadCommand>& tree_;
  Channel<ReadCommand>& ids_;
  Channel<ReadCommand>& primitives_;
  Channel<SceneRegisters>& starts_;
  Channel<WalkReport>& walked_;
  Channel<StreamReport>& written_;
  Channel<RefitReport>& reports_;
  const RefitAddresses addresses_;
  bool running_ = false;
};

}  // namespace cbvh::rtl
