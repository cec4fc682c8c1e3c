// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "golden/build/builder.h"

namespace cbvh::golden {

/// Builds trees beside whoever draws frames (Wald, Ize, Parker, section 6). One tree at a time; its builder uses its
/// own threads. What is handed over are pointers: the vertices of a finished frame in, a finished tree out.
class AsyncRebuild {
 public:
  explicit AsyncRebuild(const Builder& builder);
  /// Waits for the tree that is being built.
  ~AsyncRebuild();
  AsyncRebuild(const AsyncRebuild&) = delete;
  AsyncRebuild& operator=(const AsyncRebuild&) = delete;

  /// Begins a tree of these vertices. Only when no tree is being built and none waits to be taken.
  void start(std::shared_ptr<const Mesh> mesh);

  /// The finished tree, once; nothing while it is being built. Throws what the builder threw.
  std::optional<FloatTree> take();

  /// Nothing is being built, and nothing waits.
  bool idle() const;

  /// Returns when take() has a tree, at once when idle.
  void wait() const;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace cbvh::golden
