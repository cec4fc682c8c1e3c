// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/unwritten.h"

#include <sys/mman.h>

namespace cbvh::golden {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;

}  // namespace

void* allocate_unwritten(std::size_t bytes) {
  if (bytes < kHugePage) return ::operator new(bytes);
  void* const place = ::operator new (bytes, std::align_val_t{kHugePage});
  madvise(place, bytes, MADV_HUGEPAGE);  // a wish: nothing depends on the answer
  return place;
}

void free_unwritten(void* place, std::size_t bytes) {
  if (bytes < kHugePage) return ::operator delete(place);
  ::operator delete (place, std::align_val_t{kHugePage});
}

}  // namespace cbvh::golden
