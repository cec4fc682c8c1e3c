// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "rtl_model/compress/context_stack.h"
#include "rtl_model/datapath/hierarchy.h"
#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Sorted records become node pairs in emission order (left subtree, right subtree, the pair) and the primitive-ID
/// array. Records with equal codes are one leaf. A stack holds the subtrees that wait for their right sibling; what is
/// emitted is what the next record's code closes. A clock closes one pair, and takes the next record when nothing is
/// left to close: about 1.5 clocks a leaf, 2 at worst. Whether a record is the last of its leaf is told by the next
/// one, so its ID leaves when that is taken. Holds one node and a stack of 30. Paper section 5.2, after [LGS*09].
template <class Bits>
class HierarchyEmitter {
 public:
  /// `registers` are passed on with every pair.
  HierarchyEmitter(Channel<SortItem>& items, Channel<StreamJob>& jobs, Channel<IdEntry>& ids,
                   Channel<EmitReport>& reports, const SceneRegisters& registers)
      : items_(items), jobs_(jobs), ids_(ids), reports_(reports), registers_(registers) {}

  void tick() {
    if (finishing_) return finish();
    if (!items_.can_pop()) return;
    const SortItem& next = items_.front();
    if (primitives_ == 0) return take_leaf();
    const PrefixLength prefix = common_prefix<Bits>(code_, next.record.code);
    if (taken<Bits>(Corner::emitter_joins_leaf, prefix.value() == kMortonBits)) {
      if (!ids_.can_push()) return;
      send_id(false);
      current_.box = unite_boxes<Bits>(current_.box, next.record.box);
      take_record();
      return;
    }
    if (closes(prefix)) {
      if (!jobs_.can_push()) return;
      close(false);
      if (taken<Bits>(Corner::emitter_closes_several, closes(prefix))) return;
    }
    if (!ids_.can_push()) return;
    send_id(true);
    stack_.push() = {current_, prefix};
    deepest_ = std::max(deepest_, stack_.depth());
    take_leaf();
  }
  void commit(CommitKey) {}

 private:
  struct Node {
    FloatBox box;
    UInt<1> leaf;
    Pointer pointer;
  };
  /// A subtree whose right sibling is not complete.
  struct OpenSubtree {
    Node node;
    PrefixLength prefix;  ///< what its last code shares with the code after it; rises towards the top
  };

  /// Whether the subtree on top and `current_` are siblings, given what `current_` shares with the record after it.
  bool closes(PrefixLength prefix) { return stack_.depth() > 0 && stack_.top().prefix.value() >= prefix.value(); }

  void close(bool root) {
    const Node& left = stack_.top().node;
    jobs_.push({{{left.box, current_.box}, {left.leaf, current_.leaf}, {left.pointer, current_.pointer}},
                UInt<1>(root),
                registers_});
    current_ = {unite_boxes<Bits>(left.box, current_.box), UInt<1>(0), Pointer(pairs_++)};
    stack_.drop(1);
  }
  void send_id(bool last_of_leaf) { ids_.push({id_, UInt<1>(last_of_leaf), UInt<1>(finishing_)}); }

  void take_leaf() {
    const SortRecord& record = items_.front().record;
    current_ = {record.box, UInt<1>(1), Pointer(primitives_)};
    code_ = record.code;
    ++leaves_;
    take_record();
  }
  void take_record() {
    const SortItem& item = items_.pop();
    id_ = item.record.id;
    ++primitives_;
    finishing_ = id_waits_ = bool(item.last);
  }

  /// Behind the last record: everything closes.
  void finish() {
    const bool complete = !id_waits_ && stack_.depth() == 0;
    if (id_waits_ && ids_.can_push()) {
      send_id(true);
      id_waits_ = false;
    }
    if (stack_.depth() > 0 && jobs_.can_push()) close(stack_.depth() == 1);
    if (complete && reports_.can_push()) report();
  }
  void report() {
    taken<Bits>(Corner::emitter_single_leaf, pairs_ == 0);
    reports_.push({UInt<kPointerBits + 1>(pairs_), UInt<kPointerBits + 1>(leaves_), UInt<kPointerBits + 1>(primitives_),
                   current_.box, UInt<5>(deepest_)});
    pairs_ = leaves_ = primitives_ = 0;
    deepest_ = 0;
    finishing_ = false;
  }

  Channel<SortItem>& items_;
  Channel<StreamJob>& jobs_;
  Channel<IdEntry>& ids_;
  Channel<EmitReport>& reports_;
  const SceneRegisters registers_;
  StackStorage<OpenSubtree, kMortonBits> stack_;
  Node current_;             ///< the leaf being filled, or the subtree being closed
  UInt<kMortonBits> code_;   ///< of the record taken last
  Pointer id_;               ///< likewise; not sent yet
  std::uint64_t pairs_ = 0;  ///< sent
  std::uint64_t leaves_ = 0;
  std::uint64_t primitives_ = 0;  ///< taken
  std::size_t deepest_ = 0;
  bool id_waits_ = false;
  bool finishing_ = false;
};

}  // namespace cbvh::rtl
