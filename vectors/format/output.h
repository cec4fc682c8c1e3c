// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

#include "vectors/format/crc32c.h"

namespace cbvh::vectors {

/// Bytes on their way to a string or a file, and their CRC. Writers append to buffer() and call flush_when_large().
class Output {
 public:
  /// To this string.
  explicit Output(std::string& text) : text_(&text) {}
  /// To a temporary file beside `path`, which commit() renames; without commit() nothing is left. Throws InputError.
  static Output to_file(const std::string& path) { return Output(File{path}); }
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  fmt::memory_buffer& buffer() { return buffer_; }
  void append(std::string_view bytes) { buffer_.append(bytes.data(), bytes.data() + bytes.size()); }
  void flush_when_large() {
    if (buffer_.size() >= (1 << 20)) flush();
  }
  /// The CRC-32C of everything appended so far.
  std::uint32_t crc();
  /// Writes what is left; a file is synchronized and takes its name.
  void commit();

 private:
  struct File {
    const std::string& path;
  };
  explicit Output(const File& file);
  void flush();
  [[noreturn]] void fail(const char* action);

  fmt::memory_buffer buffer_;
  Crc32c crc_;
  std::string* text_ = nullptr;
  std::string path_;
  std::string temporary_;
  int file_ = -1;
};

}  // namespace cbvh::vectors
