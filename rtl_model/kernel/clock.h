// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include "rtl_model/kernel/commit_key.h"
#include "rtl_model/kernel/random.h"

namespace cbvh::rtl {

/// A part made of parts: its parts() are ticked and committed in its place, and those of them that are composite
/// likewise.
template <class T>
concept Composite = requires(T& part) {
  part.parts();
};

template <class T>
concept Ticking = requires(T& part) {
  part.tick();
};

namespace detail {
template <class T>
auto leaf_parts(T& part) {
  if constexpr (Composite<T>) {
    return std::apply([](auto&... inner) { return std::tuple_cat(leaf_parts(inner)...); }, part.parts());
  } else {
    return std::tuple<T&>(part);
  }
}
}  // namespace detail

/// The two-phase clock of one design. A step ticks every part, which reads what was registered and writes what will be,
/// then commits all registers at once. Order cannot matter; `shuffle` evaluates in a new random order every cycle to
/// show that it does not.
template <class... Parts>
class Clock {
 public:
  explicit Clock(Parts&... parts) : leaves_(std::tuple_cat(detail::leaf_parts(parts)...)) {}

  void step() {
    std::apply([](auto&... leaf) { (tick(leaf), ...); }, leaves_);
    commit();
  }
  void step_shuffled(SplitMix64& random) {
    for (std::size_t i = kLeaves; i-- > 1;) std::swap(order_[i], order_[random.below(i + 1)]);
    for (const std::size_t index : order_) kTicks[index](leaves_);
    commit();
  }

  std::uint64_t cycle() const { return cycle_; }

 private:
  using Leaves = decltype(std::tuple_cat(detail::leaf_parts(std::declval<Parts&>())...));
  static constexpr std::size_t kLeaves = std::tuple_size_v<Leaves>;
  using Tick = void (*)(Leaves&);

  template <class T>
  static void tick(T& leaf) {
    if constexpr (Ticking<T>) leaf.tick();
  }
  template <std::size_t... I>
  static constexpr std::array<Tick, kLeaves> tick_table(std::index_sequence<I...>) {
    return {[](Leaves& leaves) { tick(std::get<I>(leaves)); }...};
  }
  template <std::size_t... I>
  static constexpr std::array<std::size_t, kLeaves> identity(std::index_sequence<I...>) {
    return {I...};
  }
  void commit() {
    std::apply([](auto&... leaf) { (leaf.commit(CommitKey()), ...); }, leaves_);
    ++cycle_;
  }

  static constexpr std::array<Tick, kLeaves> kTicks = tick_table(std::make_index_sequence<kLeaves>());
  Leaves leaves_;
  std::array<std::size_t, kLeaves> order_ = identity(std::make_index_sequence<kLeaves>());
  std::uint64_t cycle_ = 0;
};

}  // namespace cbvh::rtl
