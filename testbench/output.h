// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/command.h"
#include "testbench/report/json.h"

namespace cbvh::testbench {

/// Where a command's result goes: text for people on stdout, JSON and CSV for programs in files. With `--json -` or
/// `--csv -` that takes stdout and the text goes to stderr.
class Output {
 public:
  /// Adds --json.
  void add_option(const Command& command);
  /// Adds --csv, which not every command has.
  void add_csv_option(const Command& command);

  void text(const std::string& text) const;
  /// Writes the JSON, an object, if it was asked for, and `made_by`: the version and the command line.
  void json(const Json& json) const;
  void csv(const std::string& text) const;  ///< the same for CSV
  bool wants_json() const { return !json_path_.empty(); }

 private:
  std::string json_path_;
  std::string csv_path_;
};

/// Reads a whole file. Throws InputError.
std::string read_text_file(const std::string& path);

}  // namespace cbvh::testbench
