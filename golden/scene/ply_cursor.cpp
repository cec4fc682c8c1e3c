// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/ply_cursor.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "golden/input_error.h"
#include "golden/scene/parse_number.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text;
}

/// Least and greatest value of an integer type.
std::pair<std::int64_t, std::int64_t> range(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return {std::numeric_limits<std::int8_t>::min(), std::numeric_limits<std::int8_t>::max()};
    case PlyType::kUint8:
      return {0, std::numeric_limits<std::uint8_t>::max()};
    case PlyType::kInt16:
      return {std::numeric_limits<std::int16_t>::min(), std::numeric_limits<std::int16_t>::max()};
    case PlyType::kUint16:
      return {0, std::numeric_limits<std::uint16_t>::max()};
    case PlyType::kInt32:
      return {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};
    default:
      return {0, std::numeric_limits<std::uint32_t>::max()};
  }
}

}  // namespace

// ---- ascii
// ---------------------------------------------------------------------------------------------------------------------------

void PlyAsciiCursor::begin_item() {
  while (!rest.empty()) {
    ++line_number;
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    line = without_blanks(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!line.empty()) return;
  }
}

void PlyAsciiCursor::end_item() {
  line = without_blanks(line);
  if (!line.empty())
    throw InputError(place(),
                     fmt::format("found {} after the item's last value, wanted the end of the line", in_quotes(line)));
}

void PlyAsciiCursor::end_body() {
  begin_item();
  if (!line.empty())
    throw InputError(place(), fmt::format("found {} after the last item, wanted the end of the file", in_quotes(line)));
}

std::string_view PlyAsciiCursor::next_token() {
  line = without_blanks(line);
  if (line.empty())
    throw InputError(place(), rest.empty() ? "found the end of the file, wanted a value"
                                           : "found the end of the line, wanted a value");
  const std::string_view token = line.substr(0, line.find_first_of(kBlanks));
  line.remove_prefix(token.size());
  return token;
}

float PlyAsciiCursor::real(PlyType type) {
  if (is_integer(type)) return static_cast<float>(integer(type));
  const std::string_view token = next_token();
  const auto value = parse_float(token);
  if (!value) throw InputError(place(), fmt::format("found {}, wanted a number", in_quotes(token)));
  return *value;
}

std::int64_t PlyAsciiCursor::integer(PlyType type) {
  const std::string_view token = next_token();
  const auto [least, greatest] = range(type);
  const auto value = parse_integer<std::int64_t>(token);
  if (!value || *value < least || *value > greatest) {
    throw InputError(place(),
                     fmt::format("found {}, wanted an integer from {} to {}", in_quotes(token), least, greatest));
  }
  return *value;
}

std::string PlyAsciiCursor::place() const { return fmt::format("{}:{}", file, line_number); }

// ---- binary
// --------------------------------------------------------------------------------------------------------------------------

void PlyBinaryCursor::end_body() {
  if (bytes_left() != 0)
    throw InputError(place(), fmt::format("{} bytes after the last item, wanted the end of the file", bytes_left()));
}

std::uint64_t PlyBinaryCursor::raw(PlyType type) {
  const std::size_t count = byte_count(type);
  if (bytes_left() < count)
    throw InputError(place(), fmt::format("found the end of the file, wanted a value of {} bytes", count));
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t shift = 8 * (swap ? count - 1 - i : i);
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[offset + i])) << shift;
  }
  offset += count;
  return value;
}

float PlyBinaryCursor::real(PlyType type) {
  if (type == PlyType::kFloat32) return std::bit_cast<float>(static_cast<std::uint32_t>(raw(type)));
  if (type == PlyType::kFloat64) return static_cast<float>(std::bit_cast<double>(raw(type)));
  return static_cast<float>(integer(type));
}

std::int64_t PlyBinaryCursor::integer(PlyType type) {
  const std::uint64_t value = raw(type);
  switch (type) {
    case PlyType::kInt8:
      return static_cast<std::int8_t>(value);
    case PlyType::kInt16:
      return static_cast<std::int16_t>(value);
    case PlyType::kInt32:
      return static_cast<std::int32_t>(value);
    default:
      return static_cast<std::int64_t>(value);
  }
}

std::string PlyBinaryCursor::place() const { return fmt::format("{}:offset {}", file, offset); }

}  // namespace cbvh::golden
