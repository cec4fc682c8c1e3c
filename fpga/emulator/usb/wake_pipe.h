// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace cbvh::emulator {

/// The device's node. libusb polls it for writing, which the kernel grants when a transfer can be reaped; a regular
/// file is always writable, and libusb would spin. So the node is a pipe, kept full while there is nothing to reap.
class WakePipe {
 public:
  /// Makes the pipe; removes it at the end. Throws std::runtime_error when it cannot.
  explicit WakePipe(const std::string& path);
  ~WakePipe();
  WakePipe(const WakePipe&) = delete;
  WakePipe& operator=(const WakePipe&) = delete;

  void set_writable(bool writable);

 private:
  void fill() const;
  void drain() const;

  std::string path_;
  int file_;
  bool writable_ = false;
};

}  // namespace cbvh::emulator
