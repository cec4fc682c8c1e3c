// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/invocation.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace cbvh::testbench {

namespace {

std::string& recorded() {
  static std::string line = "cbvh";
  return line;
}

bool is_plain(char c) {
  constexpr std::string_view kPlain = "-_./:,=+@%";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || kPlain.find(c) != std::string_view::npos;
}

}  // namespace

std::string shell_quote(const std::string& argument) {
  if (!argument.empty() && std::all_of(argument.begin(), argument.end(), is_plain)) return argument;
  std::string quoted = "'";
  for (const char c : argument) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

const std::string& command_line() { return recorded(); }

void record_command_line(int argc, const char* const* argv) {
  std::string line = "cbvh";
  for (int i = 1; i < argc; ++i) line += " " + shell_quote(argv[i]);
  recorded() = line;
}

}  // namespace cbvh::testbench
