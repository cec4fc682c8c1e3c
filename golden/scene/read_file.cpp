// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/read_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

bool prints(char c) { return c >= ' ' && c <= '~'; }

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path, "no such file");
  if (!std::filesystem::is_regular_file(status)) throw InputError(path, "not a regular file");
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path, fmt::format("cannot be read: {}", error.message()));

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw InputError(path, fmt::format("cannot be read: {}", std::strerror(errno)));
  std::string bytes(size, '\0');
  const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (count != bytes.size()) {
    throw InputError(path, fmt::format("cannot be read: found {} bytes, wanted {}", count, bytes.size()));
  }
  return bytes;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, kLongest)) {
    if (prints(c)) {
      result += c;
    } else {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return result + (text.size() > kLongest ? "...'" : "'");
}

std::string one_line(std::string_view text) {
  constexpr std::size_t kLongest = 400;
  std::string result;
  for (const char c : text.substr(0, kLongest)) {
    const bool keep = static_cast<unsigned char>(c) >= ' ';
    if (keep) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

}  // namespace cbvh::golden
