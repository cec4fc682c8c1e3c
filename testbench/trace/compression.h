// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "golden/build/builder.h"
#include "golden/tree/compressed_tree.h"
#include "testbench/trace/traced_scene.h"

namespace cbvh::testbench {

/// A mesh's tree before and after it was compressed.
struct TreePair {
  golden::FloatTree floats;
  golden::CompressedTree compressed;
  bool identical;  ///< the compressed tree is the golden's top-down one of these floats, bit for bit
};

/// Compresses a tree by streaming or top-down; of a refitted one there has to be a mesh.
TreePair compress(golden::FloatTree floats, const TraceTrees& trees);

/// Builds a mesh's tree and compresses it. Refitted: the tree of the twisted mesh, around the mesh as it is.
TreePair build_and_compress(const golden::Mesh& mesh, const TraceTrees& trees);

}  // namespace cbvh::testbench
