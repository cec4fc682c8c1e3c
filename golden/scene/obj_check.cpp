// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/obj_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "golden/input_error.h"
#include "golden/scene/mesh_check.h"
#include "golden/scene/parse_number.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

/// Statements without triangles, which are skipped.
constexpr std::array kSkipped = std::to_array<std::string_view>(
    {"vn",        "vt",     "vp",     "g",      "o",     "s",        "mg",       "l",    "p",
     "usemtl",    "mtllib", "usemap", "maplib", "bevel", "c_interp", "d_interp", "lod",  "shadow_obj",
     "trace_obj", "ctech",  "stech",  "cstype", "deg",   "bmat",     "step",     "curv", "curv2",
     "surf",      "parm",   "trim",   "hole",   "scrv",  "sp",       "end",      "con"});

/// Cuts the next piece off `text`: up to a blank, after any blanks. Blanks are what tinyobjloader takes for them.
std::string_view next_token(std::string_view& text) {
  constexpr std::string_view kBlanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view token = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(token.size());
  return token;
}

/// Cuts the next line off `text`; a line ends with LF, CR or both, as in tinyobjloader.
std::string_view next_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  if (text.starts_with("\r\n")) {
    text.remove_prefix(2);
  } else if (!text.empty()) {
    text.remove_prefix(1);
  }
  return line;
}

class LineChecker {
 public:
  explicit LineChecker(const std::string& file_name) : file(file_name) {}

  void check(std::string_view line) {
    ++line_number;
    if (line.find('\0') != line.npos) fail("found a zero byte, wanted text");
    const std::string_view keyword = next_token(line);
    if (keyword.empty() || keyword.front() == '#') return;
    if (keyword == "v") {
      check_vertex(line);
    } else if (keyword == "f") {
      check_face(line);
    } else if (std::find(kSkipped.begin(), kSkipped.end(), keyword) == kSkipped.end()) {
      fail(fmt::format("statement: found {}, wanted one of OBJ", in_quotes(keyword)));
    }
    check_size(counts.triangles, counts.vertices, file);
  }

  ObjCounts finish() const {
    if (highest_index > counts.vertices) {
      throw InputError(fmt::format("{}:{}", file, highest_index_line),
                       fmt::format("f: vertex {}, wanted at most {}", highest_index, counts.vertices));
    }
    return counts;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}", file, line_number), what);
  }

  void check_vertex(std::string_view rest) {
    for (int i = 0;; ++i) {
      const std::string_view token = next_token(rest);
      if (i >= 3 && (token.empty() || token.front() == '#')) break;
      if (token.empty()) fail(fmt::format("v: found {} numbers, wanted 3", i));
      const std::string name = i < 3 ? std::string(1, "xyz"[i]) : fmt::format("number {}", i + 1);
      const auto value = parse_float(token);
      if (!value) fail(fmt::format("v: {} is {}, wanted a number", name, in_quotes(token)));
      if (!std::isfinite(*value)) fail(fmt::format("v: {} is {}, wanted a finite number", name, in_quotes(token)));
    }
    ++counts.vertices;
  }

  void check_face(std::string_view rest) {
    std::uint64_t corners = 0;
    for (std::string_view token = next_token(rest); !token.empty(); token = next_token(rest)) {
      check_corner(token);
      ++corners;
    }
    if (corners < 3) fail(fmt::format("f: found {} corners, wanted 3 or more", corners));
    counts.triangles += corners - 2;
  }

  /// i, i/t, i//n or i/t/n; only i is used.
  void check_corner(std::string_view token) {
    const std::size_t slash = token.find('/');
    const auto index = parse_integer<int>(token.substr(0, slash));
    bool good = index.has_value();
    if (good && slash != token.npos) {
      const std::string_view rest = token.substr(slash + 1);
      const std::size_t second = rest.find('/');
      const std::string_view texture = rest.substr(0, second);
      const std::string_view normal = second == rest.npos ? "" : rest.substr(second + 1);
      good = second == rest.npos ? parse_integer<int>(texture).has_value()
                                 : (texture.empty() || parse_integer<int>(texture)) && parse_integer<int>(normal);
    }
    if (!good) fail(fmt::format("f: found {}, wanted a corner as 1, 1/2, 1//3 or 1/2/3", in_quotes(token)));
    if (*index == 0) fail("f: vertex 0, wanted 1 or more, or a negative number");
    if (*index < 0 && static_cast<std::uint64_t>(-static_cast<std::int64_t>(*index)) > counts.vertices) {
      fail(fmt::format("f: vertex {}, wanted at least -{}", *index, counts.vertices));
    }
    if (*index > 0 && static_cast<std::uint64_t>(*index) > highest_index) {
      highest_index = static_cast<std::uint64_t>(*index);
      highest_index_line = line_number;
    }
  }

  const std::string& file;
  std::uint64_t line_number = 0;
  ObjCounts counts;
  std::uint64_t highest_index = 0;  ///< a face may come before its vertices, so this is compared at the end
  std::uint64_t highest_index_line = 0;
};

}  // namespace

ObjCounts check_obj(std::string_view text, const std::string& file) {
  LineChecker checker(file);
  while (!text.empty()) checker.check(next_line(text));
  return checker.finish();
}

}  // namespace cbvh::golden
