// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_model/datapath/lbvh_payloads.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// What the run writer is given: the sorter's runs first, then whatever the merger gives back to be written again. The
/// two never overlap, for the merger begins when all of the sorter's runs are in memory. An item a clock, latency 1.
class ItemSelector {
 public:
  ItemSelector(Channel<SortItem>& from_sorter, Channel<SortItem>& from_merger, Channel<SortItem>& items)
      : from_sorter_(from_sorter), from_merger_(from_merger), items_(items) {}

  void tick() {
    if (!items_.can_push()) return;
    if (from_sorter_.can_pop()) {
      items_.push(from_sorter_.pop());
    } else if (from_merger_.can_pop()) {
      items_.push(from_merger_.pop());
    }
  }
  void commit(CommitKey) {}

 private:
  Channel<SortItem>& from_sorter_;
  Channel<SortItem>& from_merger_;
  Channel<SortItem>& items_;
};

/// Offers two areas of memory in turn, for one pass over the runs after the other: a pass reads what the one before it
/// wrote.
class AreaSequencer {
 public:
  AreaSequencer(Channel<RunArea>& areas, const std::array<RunArea, 2>& both) : areas_(areas), both_(both) {}

  void tick() {
    if (!areas_.can_push()) return;
    areas_.push(both_[next_]);
    next_ ^= 1u;
  }
  void commit(CommitKey) {}

 private:
  Channel<RunArea>& areas_;
  const std::array<RunArea, 2> both_;
  std::size_t next_ = 0;
};

}  // namespace cbvh::rtl
