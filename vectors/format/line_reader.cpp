// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/line_reader.h"

#include <algorithm>
#include <limits>

#include "vectors/format/printable.h"
#include "vectors/registry.h"

namespace cbvh::vectors {

constexpr std::string_view kMagic = "cbvh-vectors ";
constexpr std::uint64_t kVersion = 1;
constexpr std::ptrdiff_t kChunk = 1 << 14;  ///< of the CRC: still in the cache
constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

std::string header_line(const VectorSet& set) {
  const Parameters& parameters = set.parameters();
  return fmt::format("{}{} unit={} bits={} treelet={} seed={} fields={}", kMagic, kVersion, set.unit().name,
                     parameters.bits, parameters.treelet, set.seed(), set.unit().field_names(parameters.bits));
}

std::string trailer_line(const Counts& counts) {
  return fmt::format("end cases={} checks={} crc32c=", counts.cases, counts.checks);
}

LineReader::LineReader(std::string_view bytes, std::string name, std::string_view mark)
    : at_(bytes.data()),
      end_(bytes.data() + bytes.size()),
      name_(std::move(name)),
      mark_(mark),
      line_begin_(at_),
      crc_done_(at_) {
  read_header();
}

void LineReader::fail(const char* at, const std::string& what) const {
  throw golden::InputError(fmt::format("{}:{}:{}", name_, line_, at - line_begin_ + 1), what);
}

void LineReader::fail_expecting(std::string_view text) const {
  if (at_ == end_) fail(at_, fmt::format("the file ends here, want {}", printable(text)));
  fail(at_, fmt::format("found {}, want {}", printable({at_, std::min(left(), text.size())}), printable(text)));
}

void LineReader::fail_at_end_of_line() const {
  if (at_ == end_) fail(at_, "the file ends here, want the end of the line");
  fail(at_, fmt::format("found {}, want the end of the line", printable(word_at(at_))));
}

std::string_view LineReader::word_at(const char* at) const {
  const char* stop = at;
  while (stop != end_ && *stop != ' ' && *stop != '\n') ++stop;
  return {at, static_cast<std::size_t>(stop - at)};
}

std::uint64_t LineReader::read_number(const char* name, std::uint64_t most) {
  const char* const start = at_;
  std::uint64_t value = 0;
  while (at_ != end_ && *at_ >= '0' && *at_ <= '9') {
    const auto digit = static_cast<std::uint64_t>(*at_ - '0');
    if (value > (most - digit) / 10) fail(start, fmt::format("{}: more than {}", name, most));
    value = value * 10 + digit;
    ++at_;
  }
  if (at_ == start) fail(start, fmt::format("{}: found {}, want a number", name, printable(word_at(start))));
  if (*start == '0' && at_ - start > 1) fail(start, fmt::format("{}: a number has no leading zeros", name));
  return value;
}

void LineReader::read_head(VectorSet& batch) {
  const char* const id_at = at_;
  const std::uint64_t id = read_number("id", kMost);
  if (counts_.cases > 0 && id == last_id_) fail(id_at, fmt::format("duplicate id {}", id));
  if (counts_.cases > 0 && id < last_id_) fail(id_at, fmt::format("id {} comes after {}: ids must rise", id, last_id_));
  expect(" ");
  const auto& classes = unit_->classes;
  std::size_t found = id % unit_->generated_classes();  // what the generator gives
  const auto is_here = [this](std::string_view name) {
    return left() > name.size() && (at_[name.size()] == ' ' || at_[name.size()] == '\n') && starts_with(name);
  };
  if (!is_here(classes[found])) {
    found = static_cast<std::size_t>(std::find_if(classes.begin(), classes.end(), is_here) - classes.begin());
  }
  if (found == classes.size()) fail(at_, fmt::format("unknown class {} of {}", printable(word_at(at_)), unit_->name));
  at_ += classes[found].size();
  batch.begin_case(id, static_cast<std::uint16_t>(found));
  ++counts_.cases;
  last_id_ = id;
}

std::uint32_t LineReader::read_latency() {
  expect("@");
  if (starts_with("-")) {
    ++at_;
    return kLatencyNotStated;
  }
  const char* const start = at_;
  const auto latency = static_cast<std::uint32_t>(read_number("latency", std::numeric_limits<std::uint32_t>::max()));
  if (latency == kLatencyNotStated) fail(start, "latency: found 0, want 1 or more, or '-'");
  return latency;
}

std::string_view LineReader::read_value(std::string_view key) {
  expect(key);
  const std::string_view value = word_at(at_);
  at_ += value.size();
  return value;
}

void LineReader::read_header() {
  expect(mark_);
  expect(kMagic);
  const char* const version_at = at_;
  const std::uint64_t version = read_number("version", kMost);
  if (version != kVersion) fail(version_at, fmt::format("version: found {}, want {}", version, kVersion));
  const std::string_view unit = read_value(" unit=");
  const auto placed = [&](std::string_view value, auto&& action) {
    try {
      action();
    } catch (const golden::InputError& error) {
      fail(value.data(), error.what());
    }
  };
  placed(unit, [&] { unit_ = &find_unit(printable_short(unit)); });
  expect(" bits=");
  const std::string_view parameters_place(at_, at_);
  parameters_.bits = static_cast<int>(read_number("bits", 1000));
  expect(" treelet=");
  parameters_.treelet = static_cast<int>(read_number("treelet", 1000));
  placed(parameters_place, [&] { make_set(*unit_, parameters_, 0); });
  expect(" seed=");
  seed_ = read_number("seed", kMost);
  const std::string_view fields = read_value(" fields=");
  const std::string want = unit_->field_names(parameters_.bits);
  if (fields != want) {
    const auto differ = std::mismatch(fields.begin(), fields.end(), want.begin(), want.end()).first;
    fail(fields.data() + (differ - fields.begin()), fmt::format("the fields of {} are {}", unit_->name, want));
  }
  end_line();
  response_leaves_ = unit_->response(parameters_.bits).leaves.size();
}

bool LineReader::next(VectorSet& batch, std::size_t max_cases) {
  batch.clear();
  if (finished_) return false;
  while (batch.size() < max_cases) {
    if (starts_with(mark_)) {
      finished_ = true;
      break;
    }
    if (at_ == end_)
      fail(at_, fmt::format("the file ends here, want a case or {}", printable(std::string(mark_) + "end")));
    read_case(batch);
    if (at_ - crc_done_ > kChunk) update_crc();
  }
  counts_.checks += batch.response_count() * response_leaves_;
  if (finished_) {
    read_trailer();
  }
  return !batch.empty();
}

void LineReader::update_crc() {
  crc_.update({crc_done_, static_cast<std::size_t>(at_ - crc_done_)});
  crc_done_ = at_;
}

void LineReader::read_trailer() {
  expect(mark_);
  expect("end cases=");
  const auto expect_count = [this](const char* name, std::uint64_t counted) {
    const char* const start = at_;
    const std::uint64_t said = read_number(name, kMost);
    if (said != counted) fail(start, fmt::format("the trailer says {} {}, the file has {}", said, name, counted));
    if (said == 0) fail(start, fmt::format("no {}", name));
  };
  expect_count("cases", counts_.cases);
  expect(" checks=");
  expect_count("checks", counts_.checks);
  expect(" crc32c=");
  update_crc();
  const std::string want = fmt::format("{:08X}", crc_.value());
  if (!starts_with(want)) fail(at_, fmt::format("crc32c: found {}, want {}", printable(word_at(at_)), want));
  at_ += want.size();
  end_line();
  if (at_ != end_) fail(at_, "bytes after the trailer");
}

}  // namespace cbvh::vectors
