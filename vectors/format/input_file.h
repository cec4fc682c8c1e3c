// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace cbvh::vectors {

/// The bytes of a file: mapped when it is a regular one, else (a pipe) read. Throws InputError when it cannot be read.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  std::string_view bytes() const { return bytes_; }

 private:
  std::string_view bytes_;
  std::string read_;
  bool mapped_ = false;
};

}  // namespace cbvh::vectors
