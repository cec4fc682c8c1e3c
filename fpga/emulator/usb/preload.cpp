// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/usb/preload.h"

#include <unistd.h>

#include <cstdlib>
#include <string>

namespace cbvh::emulator {

void preload_umockdev(char** argv) {
  const std::string library = "libumockdev-preload.so.0";
  const char* const before = std::getenv("LD_PRELOAD");
  const std::string others = before == nullptr ? "" : before;
  if (others.find(library) != std::string::npos) return;
  // Behind the others: a sanitizer's library wants to be first.
  setenv("LD_PRELOAD", others.empty() ? library.c_str() : (others + ":" + library).c_str(), 1);
  execv("/proc/self/exe", argv);
}

}  // namespace cbvh::emulator
