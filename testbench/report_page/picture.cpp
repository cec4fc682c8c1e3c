// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <filesystem>
#include <string_view>

#include "golden/input_error.h"

namespace cbvh::testbench {

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kAround = 12;  ///< bytes of a chunk's length, type and checksum

std::uint32_t big_endian(const std::string& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
  return value;
}

[[noreturn]] void fail(const std::string& place, std::size_t offset, const std::string& what) {
  throw golden::InputError(fmt::format("{}:offset {}", place, offset), "PNG: " + what);
}

struct Chunk {
  std::string type;
  std::size_t size;  ///< of the whole chunk
};

Chunk read_chunk(const std::string& place, const std::string& bytes, std::size_t offset) {
  const std::size_t left = bytes.size() - offset;
  if (left < kAround) fail(place, offset, fmt::format("found {} bytes, want a chunk of {} or more", left, kAround));
  const std::size_t length = big_endian(bytes, offset);
  if (length > left - kAround)
    fail(place, offset, fmt::format("found a chunk of {} bytes, want {} at most", length, left - kAround));
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data() + offset + 4, length + 4);
  const std::uint32_t found = big_endian(bytes, offset + 8 + length);
  if (found != crc.checksum())
    fail(place, offset + 8 + length, fmt::format("found checksum {:08x}, want {:08x}", found, crc.checksum()));
  return {bytes.substr(offset + 4, 4), length + kAround};
}

}  // namespace

bool is_png(const std::string& bytes) { return bytes.starts_with(kSignature); }

Picture read_picture(const std::string& place, const std::string& bytes) {
  Picture picture{place, bytes};
  std::size_t offset = kSignature.size();
  bool pixels = false;
  while (true) {
    const Chunk chunk = read_chunk(place, bytes, offset);
    if ((offset == kSignature.size()) != (chunk.type == "IHDR"))
      fail(place, offset, "found another chunk than a header, or a second, want one, first");
    if (chunk.type == "IHDR") {
      if (chunk.size != kAround + 13)
        fail(place, offset, fmt::format("found a header of {} bytes, want 13", chunk.size - kAround));
      picture.width = big_endian(bytes, offset + 8);
      picture.height = big_endian(bytes, offset + 12);
      if (picture.width == 0 || picture.height == 0)
        fail(place, offset, fmt::format("found {} x {} pixels, want 1 or more", picture.width, picture.height));
    }
    pixels = pixels || chunk.type == "IDAT";
    offset += chunk.size;
    if (chunk.type == "IEND") break;
  }
  if (!pixels) fail(place, offset, "found no pixels, want an IDAT chunk");
  if (offset != bytes.size())
    fail(place, offset, fmt::format("found {} bytes behind the end, want none", bytes.size() - offset));
  return picture;
}

Markup show_picture(const Picture& picture, const std::string& command_line) {
  const std::string name = std::filesystem::path(picture.place).filename().string();
  const std::string size = fmt::format("{} × {} pixels", picture.width, picture.height);
  Markup content = element("img", {{"src", "data:image/png;base64," + base64(picture.bytes)},
                                   {"alt", fmt::format("Picture {}, {}", name, size)},
                                   {"width", std::to_string(picture.width)},
                                   {"height", std::to_string(picture.height)}});
  Markup caption = element("strong", name);
  caption += Markup::text(" " + size + " ");
  if (!command_line.empty()) caption += element("code", command_line);
  content += element("figcaption", Attributes{}, caption);
  return element("figure", {{"class", "picture"}}, content);
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    const std::size_t digits = std::min<std::size_t>(bytes.size() - i, 3) + 1;
    for (std::size_t j = 0; j < 4; ++j) text += j < digits ? kDigits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

}  // namespace cbvh::testbench
