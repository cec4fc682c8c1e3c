// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/faces/collector.h"

namespace cbvh::vectors {
namespace {

using rtl::Status;
using Context = golden::Context<Index>;

/// One tree as it arrives.
class Tree {
 public:
  Tree(int levels, int bits, const CompressionObserver& observer, std::vector<FinalAnswer>& finals)
      : levels_(levels), bits_(bits), observer_(observer), finals_(finals) {}

  void arrive(const rtl::StreamJob& job) {
    const std::size_t known = finals_.size();
    take(job);
    for (std::size_t i = known; i < finals_.size(); ++i) finals_[i].arrival = arrivals_;
    ++arrivals_;
  }

 private:
  void take(const rtl::StreamJob& job) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({&job, {}, {}, false});
    if (status_ == Status::ok) {
      accept(index);
      if (status_ != Status::ok) refused_ = index;
    }
    if (job.root) finish(index);
  }

  struct Node {
    const rtl::StreamJob* job;
    std::array<std::uint32_t, 2> child;  ///< of inner children
    Context written;                     ///< when final: the context it was written with
    bool is_final;
  };
  struct Compressed {
    std::uint32_t index;
    PairAnswer answer;
  };

  bool is_inner(std::uint32_t index, std::size_t c) const { return !nodes_[index].job->pair.leaf[c]; }

  /// Takes the subtrees of the inner children off the stack; the right one is on top.
  void link(std::uint32_t index) {
    const std::size_t inner = std::size_t{is_inner(index, 0)} + std::size_t{is_inner(index, 1)};
    if (inner > open_.size()) {
      status_ = Status::underflow;
    } else if (open_.size() - inner >= rtl::kContextStackDepth) {
      status_ = Status::overflow;
    } else {
      for (const std::size_t c : {std::size_t{1}, std::size_t{0}}) {
        if (!is_inner(index, c)) continue;
        nodes_[index].child[c] = open_.back();
        open_.pop_back();
      }
      open_.push_back(index);
    }
  }

  Compressed compress(std::uint32_t index, const std::optional<Context>& given) {
    const rtl::StreamJob& job = *nodes_[index].job;
    Compressed compressed{index, compress_pair(job.pair, given, job.registers, bits_)};
    if (observer_) {
      const rtl::Context context = given ? to_wires(*given) : rtl::Context{};
      observer_({job.pair, rtl::UInt<1>(given.has_value()), context, job.registers}, compressed.answer);
    }
    return compressed;
  }

  /// The arriving pair's treelet, level by level; its last level becomes final.
  void accept(std::uint32_t index) {
    link(index);
    if (status_ != Status::ok) return;
    std::vector<Compressed> level = {compress(index, std::nullopt)};
    for (int number = 1;; ++number) {
      for (const Compressed& pair : level) {
        if (status_ == Status::ok) status_ = pair.answer.status;
      }
      if (status_ != Status::ok) return;
      if (number == levels_) break;
      std::vector<Compressed> below;
      for (const Compressed& pair : level) {
        for (std::size_t c = 0; c < 2; ++c) {
          if (is_inner(pair.index, c))
            below.push_back(compress(nodes_[pair.index].child[c], pair.answer.child_context[c]));
        }
      }
      level = std::move(below);
    }
    for (const Compressed& pair : level) finalize(pair);
  }

  void finalize(const Compressed& pair) {
    Node& node = nodes_[pair.index];
    const rtl::SceneRegisters& registers = node.job->registers;
    FinalAnswer answer;
    answer.index = pair.index;
    answer.pair = stored_pair(node.job->pair, pair.answer, registers, bits_);
    answer.registers = registers;
    for (std::size_t c = 0; c < 2; ++c) {
      if (!is_inner(pair.index, c)) continue;
      const Node& child = nodes_[node.child[c]];
      const Context& now = pair.answer.child_context[c];
      if (!child.is_final || !is_invalidated(child.written, now, code_of(registers))) continue;
      answer.repair[c] = true;
      answer.before[c] = child.written;
      answer.after[c] = now;
    }
    node.is_final = true;
    node.written = pair.answer.context;
    finals_.push_back(answer);
  }

  /// What is left, from the root's true context downwards.
  void flush(const Compressed& pair) {
    if (nodes_[pair.index].is_final) return;
    finalize(pair);
    for (std::size_t c = 0; c < 2; ++c) {
      if (!is_inner(pair.index, c) || nodes_[nodes_[pair.index].child[c]].is_final) continue;
      flush(compress(nodes_[pair.index].child[c], pair.answer.child_context[c]));
    }
  }

  void finish(std::uint32_t root) {
    if (status_ != Status::ok) {
      FinalAnswer refusal;
      refusal.index = refused_;
      refusal.status = status_;
      refusal.registers = nodes_[root].job->registers;
      finals_.push_back(refusal);
    } else {
      const rtl::StreamJob& job = *nodes_[root].job;
      const PairAnswer answer = compress_pair(job.pair, std::nullopt, job.registers, bits_);
      flush({root, answer});
      finals_.back().root = answer.context;
    }
    finals_.back().last = true;
    nodes_.clear();
    open_.clear();
    status_ = Status::ok;
  }

  const int levels_;
  const int bits_;
  const CompressionObserver& observer_;
  std::vector<FinalAnswer>& finals_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> open_;
  Status status_ = Status::ok;
  std::uint32_t refused_ = 0;
  std::size_t arrivals_ = 0;
};

}  // namespace

std::vector<FinalAnswer> collect(std::span<const rtl::StreamJob> jobs, int levels, int bits,
                                 const CompressionObserver& observer) {
  std::vector<FinalAnswer> finals;
  Tree tree(levels, bits, observer, finals);
  for (const rtl::StreamJob& job : jobs) tree.arrive(job);
  return finals;
}

}  // namespace cbvh::vectors
