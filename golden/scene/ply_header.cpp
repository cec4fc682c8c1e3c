// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/ply_header.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "golden/input_error.h"
#include "golden/scene/mesh_check.h"
#include "golden/scene/parse_number.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

using Words = std::vector<std::string_view>;

Words split(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  Words words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find_first_of(kBlanks)));
    line.remove_prefix(words.back().size());
  }
}

std::optional<PlyType> type_named(std::string_view name) {
  constexpr std::pair<std::string_view, PlyType> kTypes[] = {
      {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
      {"float64", PlyType::kFloat64}};
  for (const auto& [known, type] : kTypes) {
    if (name == known) return type;
  }
  return std::nullopt;
}

class HeaderParser {
 public:
  HeaderParser(std::string_view text, const std::string& file_name) : bytes(text), file(file_name) {}

  PlyHeader parse() {
    if (next_line() != "ply") fail(fmt::format("magic: found {}, wanted 'ply'", in_quotes(bytes.substr(0, 4))));
    parse_format(split(next_line()));
    while (true) {
      const Words words = split(next_line());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header" && words.size() == 1) break;
      if (words[0] == "element") {
        parse_element(words);
      } else if (words[0] == "property") {
        parse_property(words);
      } else {
        fail(fmt::format("found {}, wanted element, property, comment, obj_info or end_header", in_quotes(words[0])));
      }
    }
    header.body_offset = offset;
    header.body_line = line_number + 1;
    return std::move(header);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}", file, line_number), what);
  }

  /// Lines end with LF, or CR LF.
  std::string_view next_line() {
    ++line_number;
    const std::size_t end = bytes.find('\n', offset);
    if (end == bytes.npos)
      fail(line_number == 1 ? "magic: wanted a line 'ply'" : "header: found the end of the file, wanted end_header");
    std::string_view line = bytes.substr(offset, end - offset);
    if (line.ends_with('\r')) line.remove_suffix(1);
    offset = end + 1;
    return line;
  }

  void parse_format(const Words& words) {
    if (words.size() != 3 || words[0] != "format") fail("wanted 'format ascii 1.0' or one of its binary sisters");
    if (words[1] == "ascii") {
      header.format = PlyFormat::kAscii;
    } else if (words[1] == "binary_little_endian") {
      header.format = PlyFormat::kLittleEndian;
    } else if (words[1] == "binary_big_endian") {
      header.format = PlyFormat::kBigEndian;
    } else {
      fail(fmt::format("format: found {}, wanted ascii, binary_little_endian or binary_big_endian",
                       in_quotes(words[1])));
    }
    if (words[2] != "1.0") fail(fmt::format("format version: found {}, wanted 1.0", in_quotes(words[2])));
  }

  void parse_element(const Words& words) {
    const auto count = words.size() == 3 ? parse_integer<std::uint64_t>(words[2]) : std::nullopt;
    if (!count) fail("element: wanted a name and a count");
    if (words[1] == "vertex") check_size(0, *count, fmt::format("{}:{}", file, line_number));
    for (const PlyElement& element : header.elements) {
      if (element.name == words[1]) fail(fmt::format("element: {} appears twice", in_quotes(words[1])));
    }
    header.elements.push_back({std::string(words[1]), *count, {}});
  }

  void parse_property(const Words& words) {
    if (header.elements.empty()) fail("property: wanted an element before it");
    auto& properties = header.elements.back().properties;
    PlyProperty property;
    if (words.size() == 5 && words[1] == "list") {
      property = {std::string(words[4]), type_of(words[3]), true, type_of(words[2])};
      if (!is_integer(property.count_type))
        fail(fmt::format("property list: count type {}, wanted an integer type", in_quotes(words[2])));
    } else if (words.size() == 3) {
      property = {std::string(words[2]), type_of(words[1])};
    } else {
      fail("property: wanted a type and a name, or 'list', two types and a name");
    }
    for (const PlyProperty& other : properties) {
      if (other.name == property.name) fail(fmt::format("property: {} appears twice", in_quotes(property.name)));
    }
    properties.push_back(property);
  }

  PlyType type_of(std::string_view name) const {
    if (const auto type = type_named(name)) return *type;
    fail(fmt::format("type: found {}, wanted char, uchar, short, ushort, int, uint, float or double", in_quotes(name)));
  }

  std::string_view bytes;
  const std::string& file;
  std::size_t offset = 0;
  std::uint64_t line_number = 0;
  PlyHeader header{};
};

}  // namespace

PlyHeader parse_ply_header(std::string_view bytes, const std::string& file) {
  return HeaderParser(bytes, file).parse();
}

}  // namespace cbvh::golden
