// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

/// Exact sums and products of floats, and the float next to them.
namespace cbvh::vectors {

/// Multiples of 2^-kExactPlaces: a float times a float's power of two times the cells of a grid fits, on either side.
constexpr int kExactPlaces = 405;  // a subnormal's last place on the finest grid that 9 bits name
using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// Of a finite float.
Exact exact(float x);
/// cells * x * 2^scale, x finite, 0 <= cells, -256 <= scale < 256.
Exact exact_product(int cells, float x, int scale);

/// The largest float that is not above the value; minus infinity when no finite one is. Never -0.
float largest_not_above(const Exact& value);
/// The smallest float that is not below it.
inline float smallest_not_below(const Exact& value) { return 0.0F - largest_not_above(-value); }

}  // namespace cbvh::vectors
