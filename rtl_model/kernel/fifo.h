// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace cbvh::rtl {

/// A queue inside one module: a ring whose size is fixed at reset. It crosses no module border, so it needs no clock of
/// its own.
template <class T>
class Fifo {
 public:
  explicit Fifo(std::size_t capacity) : entries_(capacity) {}

  std::size_t capacity() const { return entries_.size(); }
  std::size_t size() const { return size_; }
  std::size_t free() const { return capacity() - size_; }
  bool empty() const { return size_ == 0; }
  const T& front() const { return entries_[head_]; }

  /// The new last entry, to be filled in place.
  T& push() {
    assert(free() > 0);
    const std::size_t slot = head_ + size_++;
    return entries_[slot < capacity() ? slot : slot - capacity()];
  }
  void pop() {
    assert(!empty());
    head_ = head_ + 1 == capacity() ? 0 : head_ + 1;
    --size_;
  }

 private:
  std::vector<T> entries_;
  std::size_t head_ = 0;
  std::size_t size_ = 0;
};

}  // namespace cbvh::rtl
