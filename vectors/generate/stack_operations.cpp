// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/stack_operations.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t { kRandomWalk, kFill, kDrain, kReplace, kThreePops, kPostOrder, kSingle };

class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  void operator()(std::uint64_t pops, bool push) {
    rtl::StackOperation operation{rtl::UInt<2>(pops), rtl::UInt<1>(push), {}};
    if (push || random_.flip()) {  // contexts that are not pushed must not matter
      for (auto& axis : operation.context) {
        axis = {rtl::Scale::of_raw(random_.next()), rtl::CellIndex::of_raw(random_.next())};
      }
    }
    operations.push_back(operation);
  }

  std::vector<rtl::StackOperation> operations;

 private:
  Random& random_;
};

/// What the stream compressor does for a random tree: each pair takes the contexts of its inner children away.
void post_order(Random& random, int levels, Writer& operate) {
  std::uint64_t inner = 0;
  for (int child = 0; child < 2; ++child) {
    if (levels > 1 && !random.one_in(3)) {
      post_order(random, levels - 1, operate);
      ++inner;
    }
  }
  operate(inner, true);
}

}  // namespace

std::vector<rtl::StackOperation> make_stack_operations(std::size_t case_class, Random& random) {
  Writer operate(random);
  const auto fill = [&](int count) {
    for (int i = 0; i < count; ++i) operate(0, true);
  };
  switch (case_class) {
    case kRandomWalk:
      for (int i = random.between(1, 60); i > 0; --i) {
        const bool push = random.flip();
        operate(random.below(random.one_in(8) ? 4 : 3), push);
      }
      break;
    case kFill:
      fill(rtl::kContextStackDepth + random.between(1, 3));
      operate(1, true);  // room again: one out, one in
      operate(random.below(3), true);
      operate(0, true);
      break;
    case kDrain: {
      const int held = random.between(1, 12);
      fill(held);
      for (int i = 0; i < held / 2 + 2; ++i) operate(2, random.one_in(6));
      operate(1, true);
      operate(2, true);
      break;
    }
    case kReplace:
      fill(random.flip() ? rtl::kContextStackDepth : random.between(2, rtl::kContextStackDepth));
      for (int i = random.between(2, 12); i > 0; --i) operate(1 + random.below(2), true);
      break;
    case kThreePops:
      fill(random.between(0, 6));
      operate(3, random.flip());
      operate(random.below(3), true);
      break;
    case kPostOrder:
      post_order(random, random.between(1, 6), operate);
      break;
    default:
      operate(random.below(4), true);
  }
  return operate.operations;
}

}  // namespace cbvh::vectors
