// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/intervals.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "golden/quantize/quantize.h"
#include "vectors/faces/axis.h"

namespace cbvh::vectors {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();

float float_of_bits(std::uint64_t bits) { return std::bit_cast<float>(static_cast<std::uint32_t>(bits)); }

float any_finite(Random& random) {
  for (;;) {
    const float x = float_of_bits(random.next());
    if (std::isfinite(x)) return x;
  }
}

float magnitude_of(float lower, float upper) { return std::max(std::fabs(lower), std::fabs(upper)); }

rtl::SceneRegisters random_registers(Random& random, int min_scale) {
  return {rtl::Scale(min_scale), rtl::UInt<1>(random.flip()), rtl::UInt<1>(random.flip())};
}

/// A grid near the finest that holds the interval.
int holding_scale(float lower, float upper, const rtl::SceneRegisters& registers, int bits, int gap) {
  return std::min(128, golden::enclosing_scale(lower, upper, rules_of(registers, bits)) + gap);
}

/// Registers for bounds in any order, and a grid up to `most_gap` binary orders coarser than need be.
Interval around(float a, float b, Random& random, int bits, int most_gap) {
  const int gap = random.between(0, most_gap);
  const float lower = std::min(a, b);
  const float upper = std::max(a, b);
  const int limit = golden::exactness_limit(magnitude_of(lower, upper));
  const int extra = random.flip() ? 0 : random.between(0, 12);
  const rtl::SceneRegisters registers = random_registers(random, std::min(127, limit + extra));
  return {lower, upper, holding_scale(lower, upper, registers, bits, gap), registers};
}

/// Bounds given by cells: from `lower` sixteenths of a cell to `upper` sixteenths, exactly.
Interval on_grid(int lower, int upper, int scale, Random& random, int min_scale) {
  const double sixteenth = golden::power_of_two(scale - 4);
  return {static_cast<float>(lower * sixteenth), static_cast<float>(upper * sixteenth), scale,
          random_registers(random, min_scale)};
}

struct GridPlace {
  int scale;      ///< of the cells; 2^16 of them, and a sixteenth of one, are floats
  int lower;      ///< a cell index
  int min_scale;  ///< at least four below the scale
};
GridPlace random_place(Random& random) {
  const int scale = random.one_in(8) ? random.between(-145, 111) : random.between(-40, 20);
  constexpr int kRange[] = {4, 300, 60'000};
  const int range = kRange[random.below(3)];
  const int finest = std::max(-149, scale - 6);  // |index| < 2^17
  return {scale, random.between(-range, range), random.between(finest, scale - 4)};
}

/// `cells` cells, with bounds anywhere in the first and the last.
Interval of_cells(int cells, Random& random, bool on_edges) {
  const GridPlace place = random_place(random);
  const auto within = [&] { return on_edges ? 0 : random.between(0, 15); };
  const int lower = 16 * place.lower + within();
  const int upper = std::max(lower, 16 * (place.lower + cells - 1) + within());
  return on_grid(lower, upper, place.scale, random, place.min_scale);
}

float random_sign(Random& random) { return random.flip() ? 1.0F : -1.0F; }

/// 1 .. 2, times a power of two, of any sign.
float of_exponent(int exponent, Random& random) {
  const float sign = random_sign(random);
  return sign * std::ldexp(1.0F + random.unit(), exponent);
}

Interval random_exponents(Random& random, int bits) {
  const int exponent = random.between(-60, 60);
  const float a = of_exponent(exponent, random);
  if (random.flip()) return around(a, of_exponent(exponent - random.between(0, 40), random), random, bits, 2);
  return around(a, std::nextafter(a, 0.0F), random, bits, 40);
}

// One corner each. Random numbers are drawn in statements of their own: compilers order arguments differently.

Interval signed_zeros(Random& random, int bits) {
  constexpr float kZeros[] = {0.0F, -0.0F};
  const float a = kZeros[random.below(2)];
  const float b = kZeros[random.below(2)];
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return around(a, random.unit(), random, bits, 2);
  if (kind == 1) return around(a, -random.unit(), random, bits, 2);
  Interval interval = around(a, kind == 2 ? b : 0x1p-149F, random, bits, 40);
  if (kind == 2) {
    interval.lower = a;
    interval.upper = b;
  }
  return interval;
}

float tiny(Random& random) {
  const std::uint64_t magnitude = random.one_in(4) ? random.below(16) : random.below(0x00900000);
  return random_sign(random) * float_of_bits(magnitude);
}

Interval subnormals(Random& random, int bits) {
  const float a = tiny(random);
  const float b = tiny(random);
  return around(a, b, random, bits, 3);
}

Interval largest_finite(Random& random, int bits) {
  const float near = float_of_bits(0x7F7FFFFF - (random.flip() ? 0 : random.below(4)));
  const float huge = near * random_sign(random);
  const float others[] = {-kLargest, kLargest, 0.0F, any_finite(random)};
  const float other = others[random.below(4)];
  return around(huge, other, random, bits, 2);
}

Interval crossing(Random& random, int bits) {
  const float scale = std::ldexp(1.0F, random.between(-30, 30));
  const float a = -(random.unit() + 0x1p-24F) * scale;
  const float b = (random.unit() + 0x1p-24F) * scale;
  return around(a, b, random, bits, 2);
}

Interval full_grid(Random& random, int bits) {
  const auto figure5 = rtl::UInt<1>(random.flip());
  const bool on_edges = random.flip();
  Interval interval = of_cells((1 << bits) - (figure5 ? 1 : 0), random, on_edges);
  interval.registers.figure5 = figure5;
  return interval;
}

Interval degenerate(Random& random, int bits) {
  const float x = random.one_in(4) ? any_finite(random) : (random.unit() - 0.5F) * 64.0F;
  return around(x, x, random, bits, 12);
}

Interval saturated(Random& random, int bits) {
  const int cells = random.between(1, std::max(1, (1 << bits) / 4));
  Interval interval = of_cells(cells, random, random.flip());
  interval.registers.min_scale = rtl::Scale(interval.scale - static_cast<int>(random.below(2)));
  return interval;
}

Interval of_power_of_two_cells(Random& random, int bits) {
  const int cells = 1 << random.between(0, bits - 1);
  return of_cells(cells, random, random.flip());
}

Interval any_two(Random& random, int bits) {
  const float a = any_finite(random);
  const float b = any_finite(random);
  return around(a, b, random, bits, 3);
}

}  // namespace

rtl::SceneRegisters allowing(rtl::SceneRegisters registers, float magnitude) {
  const int limit = golden::exactness_limit(magnitude);
  registers.min_scale = rtl::Scale(std::max(limit, static_cast<int>(registers.min_scale.value())));
  return registers;
}

rtl::SceneRegisters too_fine_for(const Interval& interval, Random& random) {
  rtl::SceneRegisters registers = interval.registers;
  const int limit = golden::exactness_limit(magnitude_of(interval.lower, interval.upper));
  registers.min_scale = rtl::Scale(limit - 1 - (random.flip() ? 0 : random.between(0, 40)));
  return registers;
}

Interval with_special(Interval interval, Random& random) {
  constexpr std::uint32_t kSpecials[] = {0x7F800000, 0xFF800000, 0x7FC00000, 0xFFC00001, 0x7F800001, 0xFFFFFFFF};
  const float special = float_of_bits(kSpecials[random.below(6)]);
  if (!random.one_in(3)) {
    (random.flip() ? interval.lower : interval.upper) = special;
  } else {
    interval.lower = interval.upper = special;
  }
  return interval;
}

Interval inverted(Interval interval, Random& random) {
  if (interval.lower == interval.upper || random.one_in(3)) {  // by one last place
    interval.upper = interval.lower;
    interval.lower = std::nextafter(interval.upper, kLargest);
    if (!(interval.lower > interval.upper)) interval.upper = std::nextafter(interval.upper, -kLargest);
  } else {
    std::swap(interval.lower, interval.upper);
  }
  interval.registers = allowing(interval.registers, magnitude_of(interval.lower, interval.upper));
  return interval;
}

Interval make_too_wide(Random& random, int bits) {
  const int capacity = 1 << bits;
  Interval interval =
      of_cells(random.flip() ? capacity + 1 : random.between(capacity + 1, 4 * capacity), random, false);
  const int fitting = golden::enclosing_scale(interval.lower, interval.upper, rules_of(interval.registers, bits));
  const int finest = static_cast<int>(interval.registers.min_scale.value());
  interval.scale = random.flip() ? fitting - 1 : random.between(finest, fitting - 1);
  return interval;
}

Interval make_interval(IntervalCorner corner, Random& random, int bits) {
  switch (corner) {
    case IntervalCorner::signed_zero:
      return signed_zeros(random, bits);
    case IntervalCorner::subnormal:
      return subnormals(random, bits);
    case IntervalCorner::largest_finite:
      return largest_finite(random, bits);
    case IntervalCorner::sign_crossing:
      return crossing(random, bits);
    case IntervalCorner::edge_on_grid:
      return of_cells(random.between(1, (1 << bits) - 1), random, true);
    case IntervalCorner::one_cell:
      return of_cells(1, random, false);
    case IntervalCorner::power_of_two_size:
      return of_power_of_two_cells(random, bits);
    case IntervalCorner::full_grid:
      return full_grid(random, bits);
    case IntervalCorner::degenerate_axis:
      return degenerate(random, bits);
    case IntervalCorner::minimum_scale_saturation:
      return saturated(random, bits);
    case IntervalCorner::exponent_gap:
      return random_exponents(random, bits);
    case IntervalCorner::random_bits:
      break;
  }
  return any_two(random, bits);
}

}  // namespace cbvh::vectors
