// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cbvh::rtl {

/// Only the clock can make one, so only the clock moves registers on.
class CommitKey {
  CommitKey() = default;
  template <class... Parts>
  friend class Clock;
};

}  // namespace cbvh::rtl
