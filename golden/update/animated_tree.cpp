// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/update/animated_tree.h"

#include "golden/update/refit.h"

namespace cbvh::golden {

AnimatedTree::AnimatedTree(const Builder& builder, const UpdateOptions& options)
    : builder_(builder), options_(options) {
  if (options.policy == UpdatePolicy::async) beside_ = std::make_unique<AsyncRebuild>(builder);
}

const FloatTree& AnimatedTree::advance(const std::shared_ptr<const Mesh>& mesh) {
  if (last_ == nullptr || options_.policy == UpdatePolicy::rebuild) {
    build(*mesh);
  } else if (options_.policy == UpdatePolicy::async) {
    take_what_is_finished();
    ++age_;
    refit_in_place(tree_, *mesh, options_.refit_threads);
  } else {
    refit_or_rebuild(*mesh);
  }
  last_ = mesh;
  return tree_;
}

void AnimatedTree::build(const Mesh& mesh) {
  tree_ = builder_.build(mesh);
  if (options_.policy == UpdatePolicy::heuristic) built_.emplace(tree_);
  age_ = 0;
  ++rebuilds_;
}

void AnimatedTree::refit_or_rebuild(const Mesh& mesh) {
  refit_in_place(tree_, mesh, options_.refit_threads);
  ++age_;
  if (options_.policy == UpdatePolicy::heuristic && built_->of(tree_) > options_.rebuild_above) build(mesh);
}

void AnimatedTree::take_what_is_finished() {
  ++beside_age_;
  if (std::optional<FloatTree> finished = beside_->take()) {
    tree_ = std::move(*finished);
    age_ = beside_age_ - 1;
    ++rebuilds_;
  }
  if (beside_->idle()) {
    beside_->start(last_);
    beside_age_ = 1;
  }
}

}  // namespace cbvh::golden
