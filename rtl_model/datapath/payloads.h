// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "rtl_model/bits/fields.h"

/// What travels between the modules. N is the number of bits a coordinate; widths are those of the registers in
/// hardware.
namespace cbvh::rtl {

constexpr int kScaleBits = 9;     ///< a grid exponent, -149..128
constexpr int kIndexBits = 26;    ///< a cell index at or above the exactness limit: its magnitude is at most 2^24
constexpr int kPointerBits = 27;  ///< an emission index of a pair, or an index into the primitive-ID array
constexpr int kPairsPerLine = 4;  ///< node pairs in one 64-byte memory access
constexpr int kLineBits = kPointerBits - 2;

using Scale = SInt<kScaleBits>;
using CellIndex = SInt<kIndexBits>;
using Pointer = UInt<kPointerBits>;

/// Why a unit refused its input; the first that applies. Everything else in a refused response is zero.
enum class Status : std::uint8_t {
  ok,
  not_finite,           ///< a NaN or an infinity
  inverted,             ///< lower > upper
  beyond_exactness,     ///< the minimum scale is finer than the last place of a coordinate
  scale_below_minimum,  ///< a grid finer than the minimum scale
  too_wide,             ///< more cells than a grid has
  overflow,             ///< a stack is full
  underflow             ///< a stack is empty
};
using StatusBits = UInt<3>;

/// Configuration wires, constant over a scene and sampled with every job.
struct SceneRegisters {
  Scale min_scale;   ///< e_min
  UInt<1> figure5;   ///< scale rule: 0 equation 2, 1 the loops of figures 4 and 5
  UInt<1> relative;  ///< stored codes: 0 modulo, 1 relative
  static constexpr auto fields() {
    return field_list("min_scale", &SceneRegisters::min_scale, "figure5", &SceneRegisters::figure5, "relative",
                      &SceneRegisters::relative);
  }
  bool operator==(const SceneRegisters&) const = default;
};

/// One axis of one child, as the compressor receives it. Paper fig. 5, inputs.
struct AxisJob {
  Float32 lower;  ///< finite, <= upper
  Float32 upper;
  Scale scale;  ///< grid exponent e of the node that holds the child
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("lower", &AxisJob::lower, "upper", &AxisJob::upper, "scale", &AxisJob::scale, "registers",
                      &AxisJob::registers);
  }
  bool operator==(const AxisJob&) const = default;
};

/// One axis of a child, compressed. Paper fig. 5, outputs.
template <int N>
struct AxisResult {
  UInt<N> code_lo;      ///< lower cell index modulo 2^N
  UInt<N> code_hi;      ///< exclusive upper cell index modulo 2^N
  Scale own_scale;      ///< exponent of the child's own grid
  CellIndex own_lower;  ///< the child's lower index on its own grid
  Float32 edge_lo;      ///< decoded bounds
  Float32 edge_hi;
  StatusBits status;
  static constexpr auto fields() {
    return field_list("code_lo", &AxisResult::code_lo, "code_hi", &AxisResult::code_hi, "own_scale",
                      &AxisResult::own_scale, "own_lower", &AxisResult::own_lower, "edge_lo", &AxisResult::edge_lo,
                      "edge_hi", &AxisResult::edge_hi, "status", &AxisResult::status);
  }
  bool operator==(const AxisResult&) const = default;
};

/// One axis of a node's box, as the scale estimator receives it.
struct EstimateJob {
  Float32 lower;
  Float32 upper;
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("lower", &EstimateJob::lower, "upper", &EstimateJob::upper, "registers", &EstimateJob::registers);
  }
  bool operator==(const EstimateJob&) const = default;
};

/// The grid a node would have as the root: never coarser than its true one. Rule 6.
struct EstimateResult {
  Scale scale;
  CellIndex lower;  ///< the node's lower index on that grid
  StatusBits status;
  static constexpr auto fields() {
    return field_list("scale", &EstimateResult::scale, "lower", &EstimateResult::lower, "status",
                      &EstimateResult::status);
  }
  bool operator==(const EstimateResult&) const = default;
};

/// One axis of a traversal context: a node's own grid, and its lower index on it.
struct AxisContext {
  Scale scale;
  CellIndex lower;
  static constexpr auto fields() { return field_list("scale", &AxisContext::scale, "lower", &AxisContext::lower); }
  bool operator==(const AxisContext&) const = default;
};
using Context = std::array<AxisContext, 3>;

struct FloatBox {
  std::array<Float32, 3> lower;
  std::array<Float32, 3> upper;
  static constexpr auto fields() { return field_list("lower", &FloatBox::lower, "upper", &FloatBox::upper); }
  bool operator==(const FloatBox&) const = default;
};

/// Two sibling nodes before compression.
struct FloatPair {
  std::array<FloatBox, 2> box;
  std::array<UInt<1>, 2> leaf;
  std::array<Pointer, 2> pointer;  ///< the pair below, or the first primitive ID of a leaf
  static constexpr auto fields() {
    return field_list("box", &FloatPair::box, "leaf", &FloatPair::leaf, "pointer", &FloatPair::pointer);
  }
  bool operator==(const FloatPair&) const = default;
};

/// One compressed child. The order of fields is the order of bits, lowest first (DESIGN section 4).
template <int N>
struct NodeCodes {
  std::array<UInt<N>, 3> lo;
  std::array<UInt<N>, 3> hi;
  UInt<1> leaf;
  Pointer pointer;
  static constexpr auto fields() {
    return field_list("lo", &NodeCodes::lo, "hi", &NodeCodes::hi, "leaf", &NodeCodes::leaf, "pointer",
                      &NodeCodes::pointer);
  }
  bool operator==(const NodeCodes&) const = default;
};

/// Two compressed siblings: 16 bytes in memory when N <= 6.
template <int N>
struct NodePair {
  std::array<NodeCodes<N>, 2> child;
  static constexpr auto fields() { return field_list("child", &NodePair::child); }
  bool operator==(const NodePair&) const = default;
};

/// A pair and the grid to compress it on: its own estimate, or a given context.
struct PairJob {
  FloatPair pair;
  UInt<1> given_context;  ///< 0: estimate
  Context context;        ///< used when given_context is set
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pair", &PairJob::pair, "given_context", &PairJob::given_context, "context", &PairJob::context,
                      "registers", &PairJob::registers);
  }
  bool operator==(const PairJob&) const = default;
};

template <int N>
struct PairResult {
  NodePair<N> pair;
  Context context;                       ///< the one the pair was compressed with
  std::array<Context, 2> child_context;  ///< the contexts its children have in it
  StatusBits status;
  static constexpr auto fields() {
    return field_list("pair", &PairResult::pair, "context", &PairResult::context, "child_context",
                      &PairResult::child_context, "status", &PairResult::status);
  }
  bool operator==(const PairResult&) const = default;
};

/// A pair in memory was written with one context and must read with another.
struct RepairJob {
  Pointer pointer;
  Context before;
  Context after;  ///< on no axis finer than `before`
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pointer", &RepairJob::pointer, "before", &RepairJob::before, "after", &RepairJob::after,
                      "registers", &RepairJob::registers);
  }
  bool operator==(const RepairJob&) const = default;
};

/// A float pair of the stream, in emission order.
struct StreamJob {
  FloatPair pair;
  UInt<1> root;  ///< the last pair of its tree
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("pair", &StreamJob::pair, "root", &StreamJob::root, "registers", &StreamJob::registers);
  }
  bool operator==(const StreamJob&) const = default;
};

/// A pair that is ready for memory, and what its arrival there invalidates below it.
template <int N>
struct FinalPair {
  Pointer index;
  NodePair<N> pair;
  std::array<UInt<1>, 2> repair;  ///< the child pair was written with `before` and must be re-encoded to `after`
  std::array<Context, 2> before;  ///< zero where repair is clear
  std::array<Context, 2> after;
  UInt<1> last;       ///< the last pair of its tree
  Context root;       ///< the root\'s context; zero unless `last` is set
  StatusBits status;  ///< of the tree so far; once it is not ok the pair is void and only `last` counts
  SceneRegisters registers;
  static constexpr auto fields() {
    return field_list("index", &FinalPair::index, "pair", &FinalPair::pair, "repair", &FinalPair::repair, "before",
                      &FinalPair::before, "after", &FinalPair::after, "last", &FinalPair::last, "root",
                      &FinalPair::root, "status", &FinalPair::status, "registers", &FinalPair::registers);
  }
  bool operator==(const FinalPair&) const = default;
};

/// Contexts that the stack of open subtrees can hold: a 30-bit Morton code allows 31 levels.
constexpr int kContextStackDepth = 32;

/// One cycle of the context stack: take up to two contexts away, then add one.
struct StackOperation {
  UInt<2> pops;  ///< 0..2
  UInt<1> push;
  Context context;  ///< pushed when `push` is set
  static constexpr auto fields() {
    return field_list("pops", &StackOperation::pops, "push", &StackOperation::push, "context",
                      &StackOperation::context);
  }
  bool operator==(const StackOperation&) const = default;
};

/// What the operation took. A refused operation changes nothing.
struct StackReply {
  std::array<Context, 2> popped;  ///< the top first; zero where nothing was taken
  UInt<6> depth;                  ///< contexts held afterwards
  StatusBits status;              ///< ok, overflow or underflow
  static constexpr auto fields() {
    return field_list("popped", &StackReply::popped, "depth", &StackReply::depth, "status", &StackReply::status);
  }
  bool operator==(const StackReply&) const = default;
};

/// One 64-byte access. Reads return the line, of which one pair is wanted, that of the mask; writes change the pairs of
/// the mask and return nothing.
template <int N>
struct MemoryRequest {
  UInt<1> write;
  UInt<kLineBits> line;
  UInt<kPairsPerLine> mask;
  std::array<NodePair<N>, kPairsPerLine> pairs;
  static constexpr auto fields() {
    return field_list("write", &MemoryRequest::write, "line", &MemoryRequest::line, "mask", &MemoryRequest::mask,
                      "pairs", &MemoryRequest::pairs);
  }
  bool operator==(const MemoryRequest&) const = default;
};

/// The end of a tree, or of a repair job.
struct StreamReport {
  Pointer last_index;  ///< emission index of the root pair; of the first bad pair when status is not ok
  UInt<32> repairs;    ///< node pairs that were re-encoded
  Context root;        ///< the root's context, by which the tree is read
  StatusBits status;
  static constexpr auto fields() {
    return field_list("last_index", &StreamReport::last_index, "repairs", &StreamReport::repairs, "root",
                      &StreamReport::root, "status", &StreamReport::status);
  }
  bool operator==(const StreamReport&) const = default;
};

template <int N>
struct MemoryLine {
  std::array<NodePair<N>, kPairsPerLine> pairs;
  static constexpr auto fields() { return field_list("pairs", &MemoryLine::pairs); }
  bool operator==(const MemoryLine&) const = default;
};

}  // namespace cbvh::rtl
