// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "fpga/host/usb/stream.h"

namespace cbvh::host {

/// A board on USB: finds it, opens it, and finds it again when it has gone and come back.
class UsbTransport : public Transport {
 public:
  UsbTransport(std::shared_ptr<UsbContext> context, const BoardInfo& board)
      : context_(std::move(context)), board_(board) {}

  /// To be called once, before all others. Throws LinkError.
  void connect(FoundBoard found);

  std::string device() const override { return board_.device(); }
  bool send(Bytes bytes, Milliseconds timeout) override;
  Bytes receive(Milliseconds timeout) override;
  void restart() override;
  bool reconnect(Milliseconds timeout) override;

 protected:
  /// Interfaces below are not the board's.
  virtual int first_interface() const { return 0; }
  /// Sets up a device that has just been opened. Throws LinkError.
  virtual void configure() {}
  /// Empties the device's own buffers.
  virtual void purge() {}
  /// The data of a transfer, which may be empty.
  virtual Bytes data_of(Bytes transfer) const { return transfer; }

  UsbStream& stream() const { return *stream_; }
  const BoardInfo& board() const { return board_; }
  const Endpoints& endpoints() const { return endpoints_; }

 private:
  void check_state();

  std::shared_ptr<UsbContext> context_;
  BoardInfo board_;
  Endpoints endpoints_;
  std::unique_ptr<UsbStream> stream_;
};

/// FT2232H or FT232H between USB and the board: a UART on the second channel, or a 245 FIFO.
class FtdiTransport final : public UsbTransport {
 public:
  FtdiTransport(std::shared_ptr<UsbContext> context, const BoardInfo& board, std::uint32_t baud)
      : UsbTransport(std::move(context), board), baud_(baud) {}

 private:
  int first_interface() const override { return board().kind == BoardKind::ftdi_uart ? 1 : 0; }
  void configure() override;
  void purge() override;
  Bytes data_of(Bytes transfer) const override;
  void request(std::uint8_t request, std::uint16_t value, std::uint8_t index_high = 0);

  std::uint32_t baud_;
};

}  // namespace cbvh::host
