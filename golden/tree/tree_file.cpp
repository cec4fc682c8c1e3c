// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/tree_file.h"

#include <algorithm>

#include "golden/build/float_tree.h"
#include "golden/quantize/scale.h"
#include "golden/scene/read_file.h"
#include "golden/tree/atomic_file.h"
#include "golden/tree/byte_order.h"
#include "golden/tree/node_pair_format.h"
#include "golden/tree/validate.h"

namespace cbvh::golden {
namespace {

constexpr std::string_view kMagic{
    "\x89"
    "CBVH\r\n\x1a",
    8};
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kEndianness = 0x01020304;  // as stored: 04 03 02 01
constexpr std::uint32_t kPairs = 0x52494150;       // "PAIR"
constexpr std::uint32_t kIds = 0x44495250;         // "PRID"
constexpr std::size_t kRulesOffset = 16;
constexpr std::uint32_t kPackedPair = 16;
constexpr std::uint32_t kUnpackedPair = 24;
constexpr std::uint32_t kId = 4;

std::uint32_t pair_bytes(const GridRules& rules) { return rules.bits <= kMostPackedBits ? kPackedPair : kUnpackedPair; }

void put_pair(ByteWriter& out, const CompressedPair& pair, std::uint32_t size) {
  if (size == kPackedPair) {
    for (const std::uint64_t word : pack_node_pair(pair)) out.u64(word);
    return;
  }
  for (const CompressedChild& child : pair.child) {
    for (const AxisCodes& codes : child.codes) out.u8(codes.lower);
    for (const AxisCodes& codes : child.codes) out.u8(codes.upper);
    out.u8(child.leaf ? 1 : 0);
    out.u8(0);
    out.u32(child.pointer);
  }
}

CompressedPair take_pair(ByteReader& in, std::uint32_t size) {
  if (size == kPackedPair) {
    const std::uint64_t first = in.u64();
    return unpack_node_pair({first, in.u64()});
  }
  CompressedPair pair{};
  for (CompressedChild& child : pair.child) {
    for (AxisCodes& codes : child.codes) codes.lower = in.u8();
    for (AxisCodes& codes : child.codes) codes.upper = in.u8();
    const std::uint8_t leaf = in.u8();
    if (leaf > 1) in.fail(in.offset() - 1, fmt::format("leaf flag {}, want 0 or 1", leaf));
    child.leaf = leaf == 1;
    if (const std::uint8_t zero = in.u8(); zero != 0) in.fail(in.offset() - 1, fmt::format("found {}, want 0", zero));
    child.pointer = in.u32();
  }
  return pair;
}

/// Tag, record size, count, records, CRC-32C of all of them.
template <class PutRecords>
void put_section(ByteWriter& out, std::uint32_t tag, std::uint32_t record_bytes, std::uint64_t count,
                 PutRecords put_records) {
  const std::size_t begin = out.bytes.size();
  out.u32(tag);
  out.u32(record_bytes);
  out.u64(count);
  put_records();
  out.u32(crc32c(std::string_view(out.bytes).substr(begin)));
}

void check_crc(ByteReader& in, std::size_t begin, const char* part) {
  const std::uint32_t wanted = crc32c(in.between(begin, in.offset()));
  const std::size_t at = in.offset();
  const std::uint32_t found = in.u32();
  if (found != wanted) in.fail(at, fmt::format("CRC-32C of the {}: found {:08x}, want {:08x}", part, found, wanted));
}

/// The counts that a section may have.
struct CountRange {
  std::uint64_t least;
  std::uint64_t most;  ///< 2^27 and less
};

template <class TakeRecord>
void take_section(ByteReader& in, std::uint32_t tag, std::uint32_t record_bytes, CountRange range, const char* part,
                  TakeRecord take_record) {
  const std::size_t begin = in.offset();
  const auto expect = [&](std::uint64_t found, std::uint64_t wanted, const char* field) {
    if (found != wanted) in.fail(begin, fmt::format("{} of the {}: found {}, want {}", field, part, found, wanted));
  };
  expect(in.u32(), tag, "tag");
  expect(in.u32(), record_bytes, "record size");
  const std::uint64_t count = in.u64();
  if (count < range.least || count > range.most) {
    in.fail(begin, fmt::format("record count of the {}: found {}, want {}{}", part, count, range.least,
                               range.most > range.least ? fmt::format(" to {}", range.most) : ""));
  }
  in.need(count * record_bytes + 4);
  for (std::uint64_t i = 0; i < count; ++i) take_record();
  check_crc(in, begin, part);
}

void put_header(ByteWriter& out, const CompressedTree& tree) {
  out.bytes += kMagic;
  out.u32(kVersion);
  out.u32(kEndianness);
  out.u8(static_cast<std::uint8_t>(tree.rules.bits));
  out.u8(static_cast<std::uint8_t>(tree.code));
  out.u8(static_cast<std::uint8_t>(tree.rules.scale_rule));
  out.u8(0);
  out.i32(tree.rules.min_scale);
  for (const AxisContext<Wide>& axis : tree.root) out.i32(axis.scale);
  for (const AxisContext<Wide>& axis : tree.root) out.i320(axis.lower);
  for (int axis = 0; axis < 3; ++axis) out.f32(tree.scene.lower[axis]);
  for (int axis = 0; axis < 3; ++axis) out.f32(tree.scene.upper[axis]);
  out.u32(tree.leaves);
  out.u32(tree.primitives);
  out.u32(crc32c(out.bytes));
}

/// One byte that names an alternative: 0 or 1.
std::uint8_t take_choice(ByteReader& in, const char* field) {
  const std::size_t at = in.offset();
  const std::uint8_t value = in.u8();
  if (value > 1) in.fail(at, fmt::format("{}: found {}, want 0 or 1", field, value));
  return value;
}

CompressedTree take_header(ByteReader& in) {
  in.need(kMagic.size());
  if (in.between(0, kMagic.size()) != kMagic) in.fail(0, "not a .cbvh file: wrong magic");
  in.u64();
  if (const std::uint32_t version = in.u32(); version != kVersion) {
    in.fail(8, fmt::format("format version {}, this reader knows {}", version, kVersion));
  }
  if (const std::uint32_t mark = in.u32(); mark != kEndianness) {
    in.fail(12, fmt::format("endianness mark {:08x}, want {:08x}", mark, kEndianness));
  }
  CompressedTree tree;
  tree.rules.bits = in.u8();
  tree.code = static_cast<Code>(take_choice(in, "code"));
  tree.rules.scale_rule = static_cast<ScaleRule>(take_choice(in, "scale rule"));
  if (const std::uint8_t zero = in.u8(); zero != 0) in.fail(19, fmt::format("found {}, want 0", zero));
  tree.rules.min_scale = in.i32();
  for (AxisContext<Wide>& axis : tree.root) axis.scale = in.i32();
  for (AxisContext<Wide>& axis : tree.root) axis.lower = in.i320();
  for (int axis = 0; axis < 3; ++axis) tree.scene.lower[axis] = in.f32();
  for (int axis = 0; axis < 3; ++axis) tree.scene.upper[axis] = in.f32();
  const std::size_t counts = in.offset();
  tree.leaves = in.u32();
  tree.primitives = in.u32();
  check_crc(in, 0, "header");
  try {
    check_rules(tree.rules);
  } catch (const InputError& error) {
    in.fail(kRulesOffset, error.what());
  }
  if (tree.primitives == 0 || tree.primitives > kMaxCount || tree.leaves == 0 || tree.leaves > kMaxCount) {
    in.fail(counts, fmt::format("{} leaves of {} primitives, want 1 .. 2^27 of both", tree.leaves, tree.primitives));
  }
  return tree;
}

}  // namespace

std::string tree_to_bytes(const CompressedTree& tree) {
  ByteWriter out;
  const std::uint32_t record = pair_bytes(tree.rules);
  out.bytes.reserve(256 + tree.pairs.size() * record + tree.primitive_ids.size() * kId);
  put_header(out, tree);
  put_section(out, kPairs, record, tree.pairs.size(), [&] {
    for (const CompressedPair& pair : tree.pairs) put_pair(out, pair, record);
  });
  put_section(out, kIds, kId, tree.primitive_ids.size(), [&] {
    for (const std::uint32_t id : tree.primitive_ids) out.u32(id);
  });
  return std::move(out.bytes);
}

CompressedTree tree_from_bytes(std::string_view bytes, const std::string& name) {
  ByteReader in(bytes, name);
  CompressedTree tree = take_header(in);
  const std::uint32_t record = pair_bytes(tree.rules);
  const std::size_t pairs_at = in.offset() + 16;
  const std::uint64_t pairs = tree.leaves - 1;
  take_section(in, kPairs, record, {pairs, pairs}, "node pairs", [&] { tree.pairs.push_back(take_pair(in, record)); });
  const std::size_t ids_at = in.offset() + 16;
  const CountRange ids{std::max(tree.primitives, tree.leaves), kMaxCount};
  take_section(in, kIds, kId, ids, "primitive IDs", [&] { tree.primitive_ids.push_back(in.u32()); });
  if (in.left() != 0) in.fail(in.offset(), fmt::format("{} bytes after the end", in.left()));

  const std::vector<Violation> violations = validate(tree, 1);
  if (violations.empty()) return tree;
  const Violation& first = violations.front();
  std::size_t at = kRulesOffset;
  if (first.where == Violation::Where::pair) {
    at = pairs_at + std::size_t{first.index} * record + (first.child == 1 ? record / 2 : 0);
  }
  if (first.where == Violation::Where::primitive_id) at = ids_at + std::size_t{first.index} * kId;
  in.fail(at, to_string(first));
}

void write_tree(const std::string& path, const CompressedTree& tree) {
  write_file_atomically(path, tree_to_bytes(tree));
}

CompressedTree read_tree(const std::string& path) { return tree_from_bytes(read_file(path), path); }

}  // namespace cbvh::golden
