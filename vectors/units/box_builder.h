// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "golden/build/float_tree.h"
#include "vectors/convert.h"
#include "vectors/generate/primitives.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// The box of a triangle, or why it has none.
struct BoxBuilder : StatelessUnit<BoxBuilder, rtl::Primitive, rtl::PrimitiveBox> {
  static constexpr std::string_view kName = "box_builder";
  static constexpr std::string_view kSummary = "a triangle to its box";
  static constexpr std::string_view kLatencyText = "2";
  static constexpr std::uint32_t kLatency = 2;
  static constexpr const auto& kClasses = kPrimitiveClasses;

  static rtl::Primitive generate_one(std::size_t case_class, Random& random, const Parameters&) {
    return make_primitive(case_class, random);
  }

  static rtl::PrimitiveBox respond_one(const rtl::Primitive& primitive, const Parameters&) {
    rtl::PrimitiveBox result;
    result.id = primitive.id;
    result.last = primitive.last;
    std::array<golden::Box, 3> points{};
    for (int vertex = 0; vertex < 3; ++vertex) {
      for (int axis = 0; axis < 3; ++axis) {
        const float coordinate =
            primitive.vertex[static_cast<std::size_t>(vertex)][static_cast<std::size_t>(axis)].value();
        if (!std::isfinite(coordinate)) {
          result.status = rtl::StatusBits(static_cast<std::uint64_t>(rtl::Status::not_finite));
          return result;
        }
        golden::Box& point = points[static_cast<std::size_t>(vertex)];
        point.lower[axis] = point.upper[axis] = coordinate + 0.0F;  // -0 + 0 is 0
      }
    }
    result.box = float_box(golden::unite(golden::unite(points[0], points[1]), points[2]));
    return result;
  }
};

}  // namespace cbvh::vectors
