// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "golden/build/builder.h"
#include "golden/update/async_rebuild.h"
#include "golden/update/degradation.h"

namespace cbvh::golden {

/// What becomes of a tree when its triangles move (Wald, Ize, Parker, sections 6 and 7.1).
enum class UpdatePolicy : std::uint8_t {
  refit,      ///< the first frame's tree for ever, its boxes refitted
  rebuild,    ///< a new tree for every frame
  heuristic,  ///< refitted until it has degraded by a factor since it was built, then a new tree
  async,      ///< refitted; beside it new trees are built of the last finished frame, and taken when they are done
};

inline constexpr std::array<std::string_view, 4> kUpdatePolicies{"refit", "rebuild", "heuristic", "async"};

struct UpdateOptions {
  UpdatePolicy policy = UpdatePolicy::refit;
  unsigned refit_threads = 1;
  double rebuild_above = 1.4;  ///< of `heuristic`: Degradation::of
};

/// A tree that follows moving triangles.
class AnimatedTree {
 public:
  AnimatedTree(const Builder& builder, const UpdateOptions& options);

  /// The tree of the next frame. All frames have the same triangles, moved. Throws InputError as Builder::build does,
  /// and for a frame with another number of triangles.
  const FloatTree& advance(const std::shared_ptr<const Mesh>& mesh);

  /// Frames since the one whose vertices the tree was built of; 0 for a tree built of this one.
  unsigned age() const { return age_; }
  /// Trees that were taken into use so far.
  unsigned rebuilds() const { return rebuilds_; }

 private:
  void build(const Mesh& mesh);
  void refit_or_rebuild(const Mesh& mesh);
  void take_what_is_finished();

  Builder builder_;
  UpdateOptions options_;
  std::unique_ptr<AsyncRebuild> beside_;
  std::shared_ptr<const Mesh> last_;  ///< the last finished frame
  FloatTree tree_;
  std::optional<Degradation> built_;
  unsigned age_ = 0;
  unsigned beside_age_ = 0;  ///< frames since the one whose vertices are being built of
  unsigned rebuilds_ = 0;
};

}  // namespace cbvh::golden
