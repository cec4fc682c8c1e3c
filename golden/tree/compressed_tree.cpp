// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/compressed_tree.h"

#include "golden/build/float_tree.h"
#include "golden/quantize/scale.h"

namespace cbvh::golden {

CompressedTree blank_compressed_tree(const FloatTree& tree, const GridRules& rules, Code code) {
  check_rules(rules);
  CompressedTree compressed;
  compressed.pairs.resize(tree.pairs.size());
  compressed.primitive_ids = tree.primitive_ids;
  compressed.leaves = tree.leaves;
  compressed.primitives = tree.primitives;
  compressed.scene = tree.scene;
  compressed.code = code;
  compressed.rules = rules;
  compressed.root = root_context<Wide>(tree.scene, rules);
  return compressed;
}

}  // namespace cbvh::golden
