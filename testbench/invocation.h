// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cbvh::testbench {

/// The command line this process runs, as a shell takes it: "cbvh", then the arguments, quoted where they must be.
/// "cbvh" alone before it is recorded, as in a program that only links the library.
const std::string& command_line();

/// Called once, before anything is run.
void record_command_line(int argc, const char* const* argv);

/// An argument as a POSIX shell takes it.
std::string shell_quote(const std::string& argument);

}  // namespace cbvh::testbench
