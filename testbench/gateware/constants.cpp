// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/gateware/constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "rtl_model/datapath/traverse_payloads.h"
#include "vectors/payloads.h"

namespace cbvh::testbench {

namespace {

/// A field, or a group of them, in the packed bits of a payload: lowest bit and width.
struct Range {
  std::string path;
  int low;
  int width;
};

template <class T>
void list_ranges(const std::string& path, int& at, std::vector<Range>& ranges) {
  const std::size_t self = ranges.size();
  ranges.push_back({path, at, 0});
  if constexpr (rtl::Leaf<T>) {
    at += T::kWidth;
  } else if constexpr (rtl::detail::IsArray<T>::value) {
    constexpr std::size_t kSize = std::tuple_size_v<T>;
    for (std::size_t i = 0; i < kSize; ++i) {
      list_ranges<typename T::value_type>(path + "_" + rtl::detail::element_name<kSize>(i), at, ranges);
    }
  } else {
    std::apply(
        [&](auto... field) {
          (list_ranges<std::remove_cvref_t<decltype(std::declval<T>().*field.member)>>(path + "_" + field.name, at,
                                                                                       ranges),
           ...);
        },
        T::fields());
  }
  ranges[self].width = at - ranges[self].low;
}

/// `constant` plus `times` N.
struct Linear {
  int constant;
  int times;
  /// The line through the values at N = 2 and N = 3.
  static Linear through(int at_2, int at_3) { return {at_2 - 2 * (at_3 - at_2), at_3 - at_2}; }
  std::string text() const {
    if (times == 0) return fmt::format("{}", constant);
    const std::string product = times == 1 ? "N" : fmt::format("{}*N", times);
    return constant == 0 ? product : fmt::format("{}{:+}", product, constant);
  }
};

std::string upper_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

void define(std::string& text, const std::string& name, const std::string& value) {
  text += fmt::format("`define CBVH_{} {}\n", upper_case(name), value);
}

/// The width of a payload and the bit range of every field. Widths are linear in N.
template <class At2, class At3>
void define_payload(std::string& text, const std::string& name) {
  std::vector<Range> narrow;
  std::vector<Range> wide;
  int width_2 = 0;
  int width_3 = 0;
  list_ranges<At2>(name, width_2, narrow);
  list_ranges<At3>(name, width_3, wide);
  text += "\n";
  define(text, name + "_width", fmt::format("({})", Linear::through(width_2, width_3).text()));
  for (std::size_t i = 1; i < narrow.size(); ++i) {
    const Linear low = Linear::through(narrow[i].low, wide[i].low);
    const Linear high = Linear::through(narrow[i].low + narrow[i].width - 1, wide[i].low + wide[i].width - 1);
    define(text, narrow[i].path, fmt::format("{}:{}", high.text(), low.text()));
  }
}
template <class T>
void define_payload(std::string& text, const std::string& name) {
  define_payload<T, T>(text, name);
}

void define_status(std::string& text, const std::string& name, rtl::Status status) {
  define(text, "status_" + name, fmt::format("{}'d{}", rtl::StatusBits::kWidth, static_cast<int>(status)));
}

}  // namespace

std::string gateware_constants() {
  std::string text =
      "// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0\n"
      "// Made by `cbvh gateware` from the C++ model. A payload's fields are given as bit ranges, where N is the\n"
      "// parameter of the module that uses them.\n"
      "`ifndef CBVH_CONSTANTS\n"
      "`define CBVH_CONSTANTS\n\n";
  define(text, "scale_bits", fmt::format("{}", rtl::kScaleBits));
  define(text, "index_bits", fmt::format("{}", rtl::kIndexBits));
  define(text, "pointer_bits", fmt::format("{}", rtl::kPointerBits));
  define(text, "status_bits", fmt::format("{}", rtl::StatusBits::kWidth));
  define(text, "pairs_per_line", fmt::format("{}", rtl::kPairsPerLine));
  define(text, "line_bits", fmt::format("{}", rtl::kLineBits));
  define(text, "context_stack_depth", fmt::format("{}", rtl::kContextStackDepth));
  text += "\n";
  define_status(text, "ok", rtl::Status::ok);
  define_status(text, "not_finite", rtl::Status::not_finite);
  define_status(text, "inverted", rtl::Status::inverted);
  define_status(text, "beyond_exactness", rtl::Status::beyond_exactness);
  define_status(text, "scale_below_minimum", rtl::Status::scale_below_minimum);
  define_status(text, "too_wide", rtl::Status::too_wide);
  define_status(text, "overflow", rtl::Status::overflow);
  define_status(text, "underflow", rtl::Status::underflow);
  define_payload<rtl::SceneRegisters>(text, "scene_registers");
  define_payload<rtl::AxisContext>(text, "axis_context");
  define_payload<rtl::Context>(text, "context");
  define_payload<rtl::AxisJob>(text, "axis_job");
  define_payload<rtl::AxisResult<2>, rtl::AxisResult<3>>(text, "axis_result");
  define_payload<rtl::EstimateJob>(text, "estimate_job");
  define_payload<rtl::EstimateResult>(text, "estimate_result");
  define_payload<rtl::PairJob>(text, "pair_job");
  define_payload<rtl::PairResult<2>, rtl::PairResult<3>>(text, "pair_result");
  define_payload<rtl::StackOperation>(text, "stack_operation");
  define_payload<rtl::StackReply>(text, "stack_reply");
  define_payload<rtl::FloatPair>(text, "float_pair");
  define_payload<rtl::NodeCodes<2>, rtl::NodeCodes<3>>(text, "node_codes");
  define_payload<rtl::NodePair<2>, rtl::NodePair<3>>(text, "node_pair");
  define_payload<rtl::RepairJob>(text, "repair_job");
  define_payload<rtl::MemoryRequest<2>, rtl::MemoryRequest<3>>(text, "memory_request");
  define_payload<rtl::MemoryLine<2>, rtl::MemoryLine<3>>(text, "memory_line");
  define_payload<rtl::StreamJob>(text, "stream_job");
  define_payload<rtl::FinalPair<2>, rtl::FinalPair<3>>(text, "final_pair");
  define_payload<rtl::StreamReport>(text, "stream_report");
  define_payload<vectors::BacktrackStep<2>, vectors::BacktrackStep<3>>(text, "backtrack_step");
  define_payload<vectors::BacktrackEvent<2>, vectors::BacktrackEvent<3>>(text, "backtrack_event");
  define_payload<vectors::StreamEvent<2>, vectors::StreamEvent<3>>(text, "stream_event");
  define_payload<rtl::DecodeJob<2>, rtl::DecodeJob<3>>(text, "decode_job");
  define_payload<rtl::DecodeResult>(text, "decode_result");
  return text + "\n`endif\n";
}

}  // namespace cbvh::testbench
