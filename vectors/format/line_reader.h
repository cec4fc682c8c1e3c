// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <string>
#include <string_view>

#include "vectors/format/crc32c.h"
#include "vectors/format/format.h"

namespace cbvh::vectors {

/// What the first line of a text or hex file says after its comment mark.
std::string header_line(const VectorSet& set);
/// The last line up to and including "crc32c=", after its comment mark.
std::string trailer_line(const Counts& counts);

/// What text and hex files share: header, ids, classes, latencies, trailer and the place of an error.
class LineReader : public SetReader {
 public:
  /// `mark` starts comment lines: "# " or "// ".
  LineReader(std::string_view bytes, std::string name, std::string_view mark);
  bool next(VectorSet& batch, std::size_t max_cases) final;

 protected:
  /// Reads the case at the cursor, which is not at the trailer.
  virtual void read_case(VectorSet& batch) = 0;

  [[noreturn]] void fail(const char* at, const std::string& what) const;
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  bool starts_with(std::string_view text) const {
    return left() >= text.size() && std::memcmp(at_, text.data(), text.size()) == 0;
  }
  /// Passes over this text or fails, naming it.
  void expect(std::string_view text) {
    if (!starts_with(text)) fail_expecting(text);
    at_ += text.size();
  }
  void end_line() {
    if (at_ == end_ || *at_ != '\n') fail_at_end_of_line();
    ++at_;
    ++line_;
    line_begin_ = at_;
  }
  /// An unsigned decimal without leading zeros, up to `most`.
  std::uint64_t read_number(const char* name, std::uint64_t most);
  /// "id class": checks that ids rise and that the unit has the class.
  void read_head(VectorSet& batch);
  /// "@3" or "@-".
  std::uint32_t read_latency();
  /// The word up to a blank or the end of the line.
  std::string_view word_at(const char* at) const;

  const char* at_;
  const char* end_;

 private:
  [[noreturn]] void fail_expecting(std::string_view text) const;
  [[noreturn]] void fail_at_end_of_line() const;
  void read_header();
  std::string_view read_value(std::string_view key);
  void read_trailer();
  void update_crc();

  std::string name_;
  std::string_view mark_;
  const char* line_begin_;
  std::uint64_t line_ = 1;
  const char* crc_done_;
  Crc32c crc_;
  Counts counts_;
  std::uint64_t last_id_ = 0;
  std::size_t response_leaves_ = 0;
  bool finished_ = false;
};

}  // namespace cbvh::vectors
