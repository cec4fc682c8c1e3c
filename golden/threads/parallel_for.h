// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace cbvh::golden {

/// Calls work(0) .. work(count - 1), each once, on `threads` threads (0: one a core), in rising order of start. Plain
/// threads and one atomic counter: the pieces are large, and the thread sanitizer can see all of it. The first
/// exception is rethrown after all threads have stopped.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace cbvh::golden
