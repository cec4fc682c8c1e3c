// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace cbvh::testbench {

/// A folder of its own below the system's folder for temporary files; removed with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Whether a program of this name is in $PATH.
bool program_exists(const std::string& name);

/// Runs a program of $PATH to its end, its stdout and stderr into a file. Gives its exit code, 128 and more after a
/// signal. Throws std::runtime_error when it cannot be started.
int run_program(const std::vector<std::string>& command, const std::string& output_file);

/// Processor time of the programs that this thread has run since the last call.
double take_program_seconds();

}  // namespace cbvh::testbench
