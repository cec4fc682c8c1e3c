// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <utility>

namespace cbvh::golden {

/// Memory for arrays that are filled once and whole, as operator new gives it. Large ones are in huge pages where the
/// system has them: most of what a builder's memory costs is its page faults.
void* allocate_unwritten(std::size_t bytes);
void free_unwritten(void* place, std::size_t bytes);

/// An allocator for arrays of trivial things that threads fill: growing a vector leaves the new ones unwritten, so that
/// whoever writes them first also pays for their pages.
template <class T>
struct Unwritten {
  using value_type = T;  // NOLINT(readability-identifier-naming): the standard's name

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_unwritten(count * sizeof(T))); }
  void deallocate(T* array, std::size_t count) { free_unwritten(array, count * sizeof(T)); }
  bool operator==(const Unwritten&) const { return true; }

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U{std::forward<Arguments>(arguments)...};
  }
};

}  // namespace cbvh::golden
