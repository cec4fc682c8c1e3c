// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "golden/scene/ply_header.h"

namespace cbvh::golden {

/// Reads the values of an ascii body, where each item of an element is a line.
class PlyAsciiCursor {
 public:
  PlyAsciiCursor(std::string_view bytes, const PlyHeader& header, const std::string& file_name)
      : rest(bytes.substr(header.body_offset)), line_number(header.body_line - 1), file(file_name) {}

  void begin_item();  ///< moves to the next line that is not blank
  void end_item();    ///< refuses values left on the line
  void end_body();    ///< refuses lines left
  float real(PlyType type);
  std::int64_t integer(PlyType type);
  std::string place() const;
  std::size_t bytes_left() const { return rest.size() + line.size(); }

 private:
  std::string_view next_token();

  std::string_view rest;  ///< after the current line
  std::string_view line;  ///< what is left of the current line
  std::uint64_t line_number;
  const std::string& file;
};

/// Reads the values of a binary body.
class PlyBinaryCursor {
 public:
  PlyBinaryCursor(std::string_view all, const PlyHeader& header, const std::string& file_name)
      : bytes(all), offset(header.body_offset), swap(header.format == PlyFormat::kBigEndian), file(file_name) {}

  void begin_item() {}
  void end_item() {}
  void end_body();
  float real(PlyType type);
  std::int64_t integer(PlyType type);
  std::string place() const;
  std::size_t bytes_left() const { return bytes.size() - offset; }

 private:
  std::uint64_t raw(PlyType type);

  std::string_view bytes;
  std::size_t offset;
  bool swap;  ///< big-endian
  const std::string& file;
};

}  // namespace cbvh::golden
