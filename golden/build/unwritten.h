// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <new>
#include <utility>

namespace cbvh::golden {

/// An allocator for arrays of trivial things that threads fill: growing a vector leaves the new ones unwritten, so that
/// whoever writes them first also pays for their pages.
template <class T>
struct Unwritten : std::allocator<T> {
  template <class Other>
  struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
    using other = Unwritten<Other>;
  };
  using std::allocator<T>::allocator;

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
