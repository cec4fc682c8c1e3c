// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/build/two_level/object_tree.h"
#include "golden/options/options.h"
#include "golden/scene/instances.h"

namespace cbvh::golden {

/// A scene and the trees of its objects, in their order.
struct InstancedTrees {
  const TwoLevelScene* scene;  ///< as check_scene accepts it
  std::vector<std::unique_ptr<ObjectTree>> trees;
};

/// What a leaf of a top level refers to: a subtree of an object, where an instance places it.
struct SubtreeReference {
  std::uint32_t instance;
  ObjectNode node;
};

/// A tree over subtrees. Its primitives are the references, one a leaf, numbered from left to right; a leaf's box is a
/// conservative world box of the subtree, so that the tree is compressed like any other.
struct TopLevel {
  FloatTree tree;
  std::vector<SubtreeReference> references;
};

/// A way to build a top level, with its options.
struct TopLevelKind {
  std::string name;
  std::string meaning;  ///< in a line, and the paper's place
  std::vector<Option> options;
  TopLevel (*build)(const InstancedTrees& trees, const OptionValues& options);
};

/// All kinds, in the order in which help and reports name them.
const std::vector<TopLevelKind>& top_level_kinds();

/// A kind with values for its options.
class TopLevelBuilder {
 public:
  /// From "NAME[,key=value...]", as "rebraid,width=4". Throws InputError at `place`.
  TopLevelBuilder(const std::string& place, std::string_view description);

  const std::string& text() const { return text_; }
  const TopLevelKind& kind() const { return *kind_; }

  /// Throws InputError when a tree does not have its object's triangles, and when options cannot be kept.
  TopLevel build(const InstancedTrees& trees) const;

 private:
  std::string text_;
  const TopLevelKind* kind_;
  OptionValues options_;
};

/// The kinds and their options, for help.
std::string top_level_help();

}  // namespace cbvh::golden
