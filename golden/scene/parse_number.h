// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace cbvh::golden {

/// All of `text` as an integer in T's range, with an optional sign.
template <class T>
std::optional<T> parse_integer(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// All of `text` as the nearest binary32, ties to even; "nan" and "inf" are numbers here. Too large for binary32:
/// infinity.
inline std::optional<float> parse_float(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const char* const last = text.data() + text.size();
  float value{};
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc() && end == last) return value;
  if (error != std::errc::result_out_of_range || end != last) return std::nullopt;
  // from_chars does not say at which end of the range; binary64 has room to tell.
  double wide{};
  if (std::from_chars(text.data(), last, wide).ec != std::errc()) return std::nullopt;
  return static_cast<float>(wide);
}

}  // namespace cbvh::golden
