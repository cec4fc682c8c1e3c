// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <usbredirparser.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fpga/emulator/link/function.h"

namespace cbvh::emulator {

/// When a device is pulled out, for the test of what the host then says.
struct Unplugging {
  std::uint64_t after_bytes = 0;  ///< that the host has been given; 0: never
};

/// An emulated board on one connection of the usbredir protocol 0.7, whose other end is a USB host
/// controller: QEMU's `usb-redir` device. So the frames go through a real USB stack: libusb, usbfs, xHCI.
/// One thread; the socket must not block.
class UsbredirDevice {
 public:
  UsbredirDevice(Function& function, Transport transport, int socket, Unplugging unplugging);

  /// Serves until the other end closes the connection. Throws std::runtime_error when that breaks the protocol.
  void serve();

  std::uint64_t bytes_from_host() const { return from_host_; }
  std::uint64_t bytes_to_host() const { return to_host_; }

 private:
  struct DestroyParser {
    void operator()(usbredirparser* parser) const { usbredirparser_destroy(parser); }
  };
  /// A transfer that the host waits for.
  struct Waiting {
    std::uint64_t id;
    usb_redir_bulk_packet_header header;
    std::vector<std::uint8_t> bytes;  ///< for the board
  };

  static std::unique_ptr<usbredirparser, DestroyParser> make_parser(UsbredirDevice& self);
  void connect();
  void unplug();
  void control(std::uint64_t id, usb_redir_control_packet_header header);
  void bulk(std::uint64_t id, const usb_redir_bulk_packet_header& header, std::vector<std::uint8_t> bytes);
  void cancel(std::uint64_t id);
  void answer(const Waiting& transfer, std::uint8_t status, std::vector<std::uint8_t> bytes);
  /// Transfers that can happen now, in order, those of each endpoint by themselves.
  void move_transfers();
  bool move(Waiting& transfer);
  int read_socket(std::uint8_t* data, int size);
  int write_socket(const std::uint8_t* data, int size);

  Function& function_;
  Transport transport_;
  int socket_;
  Unplugging unplugging_;
  std::unique_ptr<usbredirparser, DestroyParser> parser_;
  std::map<std::uint8_t, std::deque<Waiting>> waiting_;  ///< by endpoint address
  bool connected_ = false;
  bool closed_ = false;
  std::string error_;
  std::uint64_t from_host_ = 0;
  std::uint64_t to_host_ = 0;
};

}  // namespace cbvh::emulator
