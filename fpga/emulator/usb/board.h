// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "fpga/emulator/link/link.h"
#include "fpga/emulator/usb/node.h"

namespace cbvh::emulator {

/// A mocked system with one USB bus. Programs started with environment() see nothing but what is plugged in there; so
/// does this process if it was started that way itself (umockdev-wrapper).
class UsbSystem {
 public:
  UsbSystem();

  UMockdevTestbed& testbed() { return *testbed_; }
  /// Where the mocked /sys and /dev are.
  std::string root() const;

 private:
  Reference<UMockdevTestbed> testbed_;
};

/// A board on the bus, from construction to destruction, but for what its link's faults do to the plug.
class UsbBoard {
 public:
  /// `port` of the bus, 1 to 4: boards that are plugged in at the same time need different ones.
  UsbBoard(UsbSystem& system, Transport transport, Link& link, unsigned port = 1);
  ~UsbBoard();
  UsbBoard(const UsbBoard&) = delete;
  UsbBoard& operator=(const UsbBoard&) = delete;

  /// How often it has been plugged in.
  unsigned plugged() const { return plugged_; }

 private:
  void run();
  /// Carries out transfers until the plug moves or the end is near.
  Plug serve(UsbNode& node);

  UsbSystem& system_;
  const Transport transport_;
  Link& link_;
  const unsigned port_;
  std::unique_ptr<Function> function_;
  std::vector<std::unique_ptr<UsbNode>> nodes_;  ///< the last is plugged in; programs may still hold the others
  std::atomic<bool> ends_ = false;
  std::atomic<unsigned> plugged_ = 0;
  std::mutex mutex_;  ///< of nodes_
  std::thread thread_;
};

}  // namespace cbvh::emulator
