// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "golden/input_error.h"
#include "golden/tree/atomic_file.h"
#include "testbench/invocation.h"
#include "testbench/version.h"

namespace cbvh::testbench {

namespace {

void write(const std::string& path, const std::string& text) {
  if (path != "-") return golden::write_file_atomically(path, text);
  std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace

void Output::add_option(const Command& command) {
  command
      .add_option("--json", json_path_,
                  "also write the result as JSON to this file; - is stdout, and the text goes to stderr")
      .type_name("FILE");
}

void Output::add_csv_option(const Command& command) {
  command
      .add_option("--csv", csv_path_,
                  "also write every figure as CSV to this file; - is stdout, and the text goes to stderr")
      .type_name("FILE")
      .check([this](const std::string& path) {
        return path == "-" && json_path_ == "-" ? std::string("found - for --json too, want one of them on stdout")
                                                : std::string();
      });
}

void Output::text(const std::string& text) const {
  std::FILE* const stream = json_path_ == "-" || csv_path_ == "-" ? stderr : stdout;
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
}

void Output::json(const Json& json) const {
  if (json_path_.empty()) return;
  Json signed_json = json;
  signed_json["made_by"] = {{"version", kVersion}, {"command_line", command_line()}};
  write(json_path_, signed_json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

void Output::csv(const std::string& text) const {
  if (!csv_path_.empty()) write(csv_path_, text);
}

std::string read_text_file(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file || std::filesystem::is_directory(path)) {
    throw golden::InputError(path, fmt::format("cannot read: {}", std::strerror(errno != 0 ? errno : EISDIR)));
  }
  return content;
}

}  // namespace cbvh::testbench
