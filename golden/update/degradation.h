// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "golden/build/float_tree.h"

namespace cbvh::golden {

/// How much a tree has suffered from refitting: the rebuild heuristic that Wald, Ize and Parker take over from
/// Lauterbach and others. A node culls well when its surface is small against those of its children; that ratio, taken
/// when the tree is built and again later, does not depend on the scene's size.
class Degradation {
 public:
  /// Remembers the ratio of each pair of a tree just built.
  explicit Degradation(const FloatTree& built);

  /// The mean, over the pairs, of their ratio over the one remembered; 1 for the tree that was built. The same
  /// topology with other boxes. Pairs whose children have no surface, then or now, do not count.
  double of(const FloatTree& refitted) const;

 private:
  std::vector<double> ratios_;
};

}  // namespace cbvh::golden
