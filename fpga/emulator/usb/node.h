// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include "fpga/emulator/link/descriptors.h"
#include "fpga/emulator/link/function.h"
#include "fpga/emulator/usb/urb.h"
#include "fpga/emulator/usb/wake_pipe.h"

namespace cbvh::emulator {

/// A device that is plugged in, as programs see it: a file below /dev/bus/usb whose ioctls are answered here. Those
/// come from a thread of umockdev's; transfers are carried out by whoever calls serve().
class UsbNode {
 public:
  /// `port` is where it is plugged in, `number` the device's on the bus, 2 or more. Throws std::runtime_error when
  /// umockdev refuses.
  UsbNode(UMockdevTestbed& testbed, Transport transport, Function& function, unsigned port, unsigned number);
  ~UsbNode();
  UsbNode(const UsbNode&) = delete;
  UsbNode& operator=(const UsbNode&) = delete;

  /// Carries out what can be now. True when a transfer has ended.
  bool serve();
  /// Waits for a new transfer, or until the time. True when transfers wait.
  void wait(Time until);
  bool has_pending();
  /// Ends the wait.
  void interrupt();
  /// Unplugs: all transfers end, and every ioctl fails with ENODEV. Programs are told.
  void unplug();

 private:
  using UrbPointer = std::unique_ptr<Urb>;
  struct Result {
    long value;
    int error;
  };

  static gboolean on_ioctl(UMockdevIoctlBase* handler, UMockdevIoctlClient* client, gpointer node);
  static void on_vanished(UMockdevIoctlBase* handler, UMockdevIoctlClient* client, gpointer node);

  Result ioctl(UMockdevIoctlClient& client);
  Result submit(UMockdevIoctlClient& client, UMockdevIoctlData& argument);
  Result discard(gulong address);
  Result reap(UMockdevIoctlClient& client, UMockdevIoctlData& argument);
  Result claim(UMockdevIoctlClient& client, unsigned interface, bool with_driver);
  Result release(UMockdevIoctlClient& client, unsigned interface);
  Result driver_name(UMockdevIoctlData& argument);
  Result driver_request(UMockdevIoctlData& argument);
  void forget(UMockdevIoctlClient& client);

  /// Whether the transfer has ended.
  bool carry_out(Urb& urb);
  bool carry_out_control(Urb& urb);
  void finish(UrbPointer urb, int status);
  void show_reapable();

  UMockdevTestbed& testbed_;
  const Transport transport_;
  Function& function_;
  const UsbIdentity identity_;
  std::string device_path_;
  std::string node_path_;
  Reference<UMockdevIoctlBase> handler_;
  std::unique_ptr<WakePipe> pipe_;
  std::mutex function_mutex_;  ///< never taken while mutex_ is held

  std::mutex mutex_;  ///< everything below
  std::condition_variable changed_;
  std::deque<UrbPointer> pending_;
  Urb* carried_out_ = nullptr;
  std::map<UMockdevIoctlClient*, std::deque<UrbPointer>> done_;
  std::map<unsigned, UMockdevIoctlClient*> claimed_;  ///< by interface
  std::set<unsigned> drivers_;                        ///< interfaces that a driver of the kernel has
  bool gone_ = false;
  bool interrupted_ = false;
};

}  // namespace cbvh::emulator
