// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/tree_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "golden/build/lbvh.h"
#include "golden/input_error.h"
#include "golden/quantize/scale.h"
#include "golden/scene/read_file.h"
#include "golden/scene/trouble_scenes.h"
#include "golden/tree/byte_order.h"
#include "golden/tree/node_pair_format.h"
#include "golden/update/top_down.h"

namespace cbvh::golden {
namespace {

constexpr std::size_t kHeaderBytes = 192;
constexpr std::size_t kPairsAt = kHeaderBytes + 16;

CompressedTree example(std::uint64_t seed, int bits = 6, Code code = Code::modulo, Trouble trouble = Trouble::lattice) {
  const FloatTree tree = build_lbvh(trouble_scene(trouble, seed, 40));
  return compress_top_down(tree, {bits, exactness_limit(tree.largest_magnitude), ScaleRule::equation2}, code);
}

/// A tree with a few pairs and an inner child in its root pair.
CompressedTree example_with_pairs(int bits = 6) {
  for (std::uint64_t seed = 0;; ++seed) {
    CompressedTree tree = example(seed, bits);
    if (tree.pairs.size() >= 8 && !tree.pairs.back().child[0].leaf) return tree;
  }
}

std::string reason(std::string_view bytes) {
  try {
    tree_from_bytes(bytes, "t.cbvh");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// The same file with its three checksums made right again.
std::string with_new_checksums(std::string bytes, const CompressedTree& tree) {
  const std::size_t pair_bytes = tree.rules.bits <= 6 ? 16 : 24;
  const std::size_t ids_at = kPairsAt + tree.pairs.size() * pair_bytes + 4;
  const auto fix = [&](std::size_t begin, std::size_t end) {
    ByteWriter crc;
    crc.u32(crc32c(std::string_view(bytes).substr(begin, end - begin)));
    bytes.replace(end, 4, crc.bytes);
  };
  fix(0, kHeaderBytes - 4);
  fix(kHeaderBytes, ids_at - 4);
  fix(ids_at, bytes.size() - 4);
  return bytes;
}

TEST(TreeFile, crc32c_of_the_check_string_is_the_published_one) { EXPECT_EQ(crc32c("123456789"), 0xE3069283U); }

TEST(TreeFile, what_is_written_is_what_is_read_for_every_kind_of_trouble) {
  int checks = 0;
  for (std::uint64_t id = 0; id < 336; ++id) {
    const FloatTree floats = build_lbvh(trouble_scene(kTroubles[id % kTroubles.size()], id));
    GridRules rules{2 + static_cast<int>(id % 7), exactness_limit(floats.largest_magnitude), ScaleRule::equation2};
    if (id % 5 == 0) rules.min_scale = -149;
    if (id % 5 == 1) rules.scale_rule = ScaleRule::figure5;
    const CompressedTree tree = compress_top_down(floats, rules, id % 2 == 0 ? Code::modulo : Code::relative);
    const std::string bytes = tree_to_bytes(tree);
    ASSERT_EQ(reason(bytes), "");
    const CompressedTree found = tree_from_bytes(bytes, "memory");
    ASSERT_TRUE(found.pairs == tree.pairs);
    ASSERT_EQ(found.primitive_ids, tree.primitive_ids);
    ASSERT_EQ(found.root, tree.root);
    ASSERT_EQ(found.code, tree.code);
    ASSERT_EQ(found.rules.bits, rules.bits);
    ASSERT_EQ(found.rules.min_scale, rules.min_scale);
    ASSERT_EQ(found.rules.scale_rule, rules.scale_rule);
    ASSERT_EQ(found.scene.lower, tree.scene.lower);
    ASSERT_EQ(found.scene.upper, tree.scene.upper);
    ASSERT_EQ(tree_to_bytes(found), bytes);
    ++checks;
  }
  EXPECT_EQ(checks, 336);
}

TEST(TreeFile, every_changed_byte_every_truncation_and_every_trailing_byte_is_refused) {
  for (const int bits : {6, 8}) {
    const std::string bytes = tree_to_bytes(example_with_pairs(bits));
    ASSERT_EQ(reason(bytes), "");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
      ASSERT_TRUE(reason(changed).starts_with("t.cbvh:offset ")) << "byte " << i << ": " << reason(changed);
      ASSERT_NE(reason(std::string_view(bytes).substr(0, i)), "") << "truncated to " << i;
    }
    EXPECT_EQ(reason(bytes + "x"), fmt::format("t.cbvh:offset {}: 1 bytes after the end", bytes.size()));
    EXPECT_NE(reason(std::string_view(bytes).substr(0, 100)).find("offset 100: the file ends here"), std::string::npos);
  }
  EXPECT_NE(reason("").find("offset 0"), std::string::npos);
}

TEST(TreeFile, header_fields_are_refused_where_they_stand) {
  const CompressedTree tree = example_with_pairs();
  const std::string bytes = tree_to_bytes(tree);
  const auto patched = [&](std::size_t at, std::uint8_t value) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(value);
    return reason(with_new_checksums(changed, tree));
  };
  EXPECT_NE(patched(0, 'x').find("offset 0: not a .cbvh file"), std::string::npos);
  EXPECT_NE(patched(8, 2).find("offset 8: format version 2"), std::string::npos);
  EXPECT_NE(patched(12, 1).find("offset 12: endianness"), std::string::npos);
  EXPECT_NE(patched(16, 9).find("offset 16: bits"), std::string::npos);
  EXPECT_NE(patched(17, 2).find("offset 17: code"), std::string::npos);
  EXPECT_NE(patched(18, 2).find("offset 18: scale rule"), std::string::npos);
  EXPECT_NE(patched(19, 1).find("offset 19"), std::string::npos);
  EXPECT_NE(patched(24, static_cast<std::uint8_t>(bytes[24] + 1)).find("the root's grid"), std::string::npos);
  EXPECT_NE(patched(36, static_cast<std::uint8_t>(bytes[36] + 1)).find("the root's grid"), std::string::npos);
  EXPECT_NE(patched(159, 0x7F).find("scene box"), std::string::npos) << "lower above upper";
}

/// Breaks a valid tree and expects the reader to say so, at that pair or entry.
void expect_refused(const std::function<std::size_t(CompressedTree&)>& damage, const std::string& what) {
  CompressedTree tree = example_with_pairs();
  const std::size_t offset = damage(tree);
  const std::string found = reason(tree_to_bytes(tree));
  EXPECT_NE(found.find(what), std::string::npos) << "found: " << found;
  EXPECT_NE(found.find(fmt::format("offset {}: ", offset)), std::string::npos) << "found: " << found;
}

TEST(TreeFile, damaged_trees_with_good_checksums_are_refused_with_their_place) {
  const auto root_at = [](const CompressedTree& tree) { return kPairsAt + (tree.pairs.size() - 1) * 16; };
  const auto entry_at = [](const CompressedTree& tree, std::size_t i) {
    return kPairsAt + tree.pairs.size() * 16 + 20 + i * 4;
  };
  expect_refused(
      [&](CompressedTree& tree) {
        tree.pairs.back().child[0].pointer = 1000;
        return root_at(tree);
      },
      "pointer 1000, want below");
  expect_refused(
      [&](CompressedTree& tree) {
        tree.pairs.back().child[0].pointer = static_cast<std::uint32_t>(tree.pairs.size() - 1);
        return root_at(tree);
      },
      "a cycle");
  expect_refused(
      [&](CompressedTree& tree) {
        tree.pairs.back().child[0].leaf = true;
        tree.pairs.back().child[0].pointer = 0;
        return kPairsAt;
      },
      "not reached");
  expect_refused(
      [&](CompressedTree& tree) {
        tree.primitive_ids[0] ^= (tree.primitive_ids[0] ^ tree.primitive_ids[1]) & ~kLastOfLeaf;
        return entry_at(tree, 1);
      },
      "a second time");
  expect_refused(
      [&](CompressedTree& tree) {
        tree.primitive_ids[2] = (tree.primitive_ids[2] & kLastOfLeaf) | tree.primitives;
        return entry_at(tree, 2);
      },
      "want below");
  expect_refused(
      [&](CompressedTree& tree) {
        std::size_t pair = 0;
        while (!tree.pairs[pair].child[1].leaf) ++pair;
        std::swap(tree.pairs[pair].child[1].codes[0].lower, tree.pairs[pair].child[1].codes[0].upper);
        return kPairsAt + pair * 16 + 8;
      },
      "axis x");
}

TEST(TreeFile, overlapping_leaves_and_boxes_outside_their_parent_are_refused) {
  const CompressedTree good = example_with_pairs();
  CompressedTree overlapping = good;
  for (CompressedPair& pair : overlapping.pairs) {
    for (CompressedChild& child : pair.child) {
      if (child.leaf) child.pointer = 0;
    }
  }
  EXPECT_NE(reason(tree_to_bytes(overlapping)).find("leaf overlaps another"), std::string::npos);
  int outside = 0;
  for (std::size_t i = 0; i < good.pairs.size(); ++i) {
    for (int step = 1; step < 64; ++step) {
      CompressedTree moved = good;
      AxisCodes& codes = moved.pairs[i].child[0].codes[1];
      codes.upper = static_cast<std::uint8_t>((codes.upper + step) % 64);
      outside += reason(tree_to_bytes(moved)).find("outside its parent") != std::string::npos;
    }
  }
  EXPECT_GT(outside, 0);
}

TEST(TreeFile, writing_is_all_or_nothing) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("cbvh-tree-file-{}", ::getpid());
  std::filesystem::create_directories(folder);
  const CompressedTree tree = example_with_pairs();
  const std::string path = folder / "t.cbvh";
  write_tree(path, tree);
  EXPECT_TRUE(read_tree(path).pairs == tree.pairs);
  write_tree(path, tree);  // replaces
  EXPECT_EQ(read_file(path), tree_to_bytes(tree));
  std::filesystem::create_directories(folder / "taken.cbvh" / "inside");
  EXPECT_THROW(write_tree(folder / "taken.cbvh", tree), InputError) << "a folder stands there";
  EXPECT_THROW(write_tree(folder / "missing" / "t.cbvh", tree), InputError);
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++entries;
  EXPECT_EQ(entries, 2U) << "no temporary file is left behind";
  EXPECT_THROW(read_tree(folder / "none.cbvh"), InputError);
  std::filesystem::remove_all(folder);
}

TEST(NodePairFormat, fields_stand_where_design_section_4_puts_them) {
  CompressedPair pair{};
  pair.child[0] = {{{{1, 8}, {2, 16}, {4, 32}}}, true, 5};
  pair.child[1] = {{{{63, 0}, {0, 63}, {63, 0}}}, false, (1U << 27) - 1};
  const NodePairWords words = pack_node_pair(pair);
  EXPECT_EQ(words[0], 1U | 2U << 6 | 4U << 12 | 8U << 18 | 16U << 24 | std::uint64_t{32} << 30 |
                          std::uint64_t{1} << 36 | std::uint64_t{5} << 37);
  EXPECT_EQ(words[1], 63U | 63U << 12 | 63U << 24 | std::uint64_t{(1U << 27) - 1} << 37);
  EXPECT_EQ(unpack_node_pair(words), pair);
  for (const CompressedPair& p : example_with_pairs().pairs) EXPECT_EQ(unpack_node_pair(pack_node_pair(p)), p);
  pair.child[0].pointer = 1U << 27;
  EXPECT_THROW(pack_node_pair(pair), InputError);
  pair.child[0] = {{{{64, 0}, {0, 0}, {0, 0}}}, true, 5};
  EXPECT_THROW(pack_node_pair(pair), InputError);
}

}  // namespace
}  // namespace cbvh::golden
