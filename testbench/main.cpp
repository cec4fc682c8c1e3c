// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/command_line.h"

int main(int argc, char** argv) { return cbvh::testbench::run_command_line(argc, argv); }
