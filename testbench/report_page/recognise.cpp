// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/recognise.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "golden/input_error.h"

namespace cbvh::testbench {

namespace {

constexpr std::size_t kKeysNamed = 8;

/// "file:line:column" of a byte.
std::string place_of(const std::string& place, const std::string& bytes, std::size_t offset) {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(offset, bytes.size()));
  const auto line = std::count(bytes.begin(), end, '\n') + 1;
  const auto column = end - std::find(std::make_reverse_iterator(end), bytes.rend(), '\n').base() + 1;
  return fmt::format("{}:{}:{}", place, line, column);
}

Json parse(const std::string& place, const std::string& bytes) {
  try {
    return Json::parse(bytes);
  } catch (const Json::parse_error& error) {
    const std::size_t offset = error.byte == 0 ? 0 : error.byte - 1;
    const std::string found = offset < bytes.size()
                                  ? fmt::format("byte 0x{:02x}", static_cast<unsigned char>(bytes[offset]))
                                  : "the end of the file";
    throw golden::InputError(place_of(place, bytes, offset),
                             fmt::format("found {}, want JSON that cbvh wrote, or a PNG picture", found));
  } catch (const Json::exception& error) {
    throw golden::InputError(place, fmt::format("found {}, want numbers that binary64 can hold", error.what()));
  }
}

std::string keys_of(const Json& json) {
  if (!json.is_object()) return fmt::format("JSON that is {}", json.is_array() ? "an array" : json.type_name());
  std::string keys;
  std::size_t count = 0;
  for (const auto& [key, value] : json.items()) {
    if (++count > kKeysNamed) return keys + ", ...";
    keys += (keys.empty() ? "" : ", ") + key;
  }
  return "an object with " + (keys.empty() ? "no keys" : keys);
}

bool fits(const ResultKind& kind, const Json& json) {
  return std::all_of(kind.keys.begin(), kind.keys.end(), [&](const std::string& key) { return json.contains(key); });
}

ResultKind kind_of(const std::string& place, const Json& json) {
  std::string known;
  for (const ResultKind& kind : result_kinds()) {
    if (json.is_object() && fits(kind, json)) return kind;
    known += (known.empty() ? "" : ", ") + kind.command;
  }
  throw golden::InputError(place, fmt::format("found {}, want the JSON of one of: {}", keys_of(json), known));
}

/// Of `made_by`, which older files lack.
std::string made_by(const Json& json, const std::string& key) {
  return json.contains("made_by") ? json.at("made_by").at(key).get<std::string>() : "-";
}

}  // namespace

std::vector<ResultKind> result_kinds() {
  return {checks_kind(),     units_kind(), lockstep_kind(),  evaluation_kind(), build_kind(),
          simulation_kind(), refit_kind(), animation_kind(), bench_kind(),      trace_kind()};
}

void recognise(const std::string& place, const std::string& bytes, Contents& contents) {
  if (is_png(bytes)) {
    contents.pictures.push_back(read_picture(place, bytes));
    return;
  }
  const Json json = parse(place, bytes);
  const ResultKind kind = kind_of(place, json);
  try {
    Figures nowhere;
    kind.tally(json);
    kind.show(json, nowhere);
    contents.results.push_back({place, kind, json, made_by(json, "version"), made_by(json, "command_line")});
  } catch (const std::exception& error) {
    throw golden::InputError(
        place, fmt::format("found a broken {}: {}; want it as {} writes it", kind.name, error.what(), kind.command));
  }
}

}  // namespace cbvh::testbench
