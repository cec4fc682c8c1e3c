// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/frame_reader.h"

#include <algorithm>

namespace cbvh::host {

void FrameReader::feed(ByteSpan bytes) {
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  append(buffer_, bytes);
}

void FrameReader::clear() {
  buffer_.clear();
  begin_ = 0;
  header_.reset();
}

void FrameReader::skip(std::size_t bytes) {
  begin_ += bytes;
  counters_.skipped += bytes;
}

/// Skips to a good header. False when that needs more bytes.
bool FrameReader::find_header() {
  for (;;) {
    const ByteSpan bytes = unread();
    const auto magic = std::find(bytes.begin(), bytes.end(), kMagic[0]);
    skip(static_cast<std::size_t>(magic - bytes.begin()));
    const ByteSpan found = unread();
    if (found.size() >= 2 && found[1] != kMagic[1]) {
      skip(1);
      continue;
    }
    if (found.size() < kHeaderBytes) return false;
    if (crc32c(found.first(12)) == read_at<std::uint32_t>(found, 12)) {
      header_ = Header{found[2], static_cast<FrameType>(found[3]), read_at<std::uint32_t>(found, 4),
                       read_at<std::uint32_t>(found, 8)};
      return true;
    }
    skip(1);
  }
}

std::optional<FrameReader::Frame> FrameReader::next() {
  for (;;) {
    if (!header_ && !find_header()) return std::nullopt;
    const Header header = *header_;
    if (header.version != kProtocolVersion || header.length > greatest_payload_) {
      begin_ += kHeaderBytes;
      header_.reset();
      return Frame{header.version != kProtocolVersion ? Kind::other_version : Kind::too_long, header, {}};
    }
    const ByteSpan bytes = unread();
    if (bytes.size() < frame_bytes(header.length)) return std::nullopt;
    begin_ += frame_bytes(header.length);
    header_.reset();
    const ByteSpan payload = bytes.subspan(kHeaderBytes, header.length);
    if (header.length > 0 && crc32c(payload) != read_at<std::uint32_t>(bytes, kHeaderBytes + header.length)) {
      ++counters_.corrupted;
      continue;
    }
    return Frame{Kind::whole, header, payload};
  }
}

bool FrameReader::give_up_unfinished() {
  if (unread().empty()) return false;
  header_.reset();
  skip(1);
  return true;
}

}  // namespace cbvh::host
