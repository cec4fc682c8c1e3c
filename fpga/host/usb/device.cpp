// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/usb/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "fpga/host/link_error.h"

namespace cbvh::host {

namespace {

constexpr std::uint16_t kFtdi = 0x0403;
constexpr std::uint16_t kFt232h = 0x6014;

struct ProductId {
  std::uint16_t vendor;
  std::uint16_t product;
};
constexpr std::array<ProductId, 3> kProductIds = {{{0x1209, 0xB5C0}, {kFtdi, 0x6010}, {kFtdi, kFt232h}}};

BoardKind kind_of(const libusb_device_descriptor& descriptor) {
  if (descriptor.idVendor != kFtdi) return BoardKind::bulk;
  return descriptor.idProduct == kFt232h ? BoardKind::ftdi_fifo : BoardKind::ftdi_uart;
}

std::string speed_name(int speed) {
  switch (speed) {
    case LIBUSB_SPEED_LOW:
      return "low (1.5 Mbit/s)";
    case LIBUSB_SPEED_FULL:
      return "full (12 Mbit/s)";
    case LIBUSB_SPEED_HIGH:
      return "high (480 Mbit/s)";
    case LIBUSB_SPEED_SUPER:
    case LIBUSB_SPEED_SUPER_PLUS:
      return "super (5 Gbit/s or more)";
    default:
      return "unknown";
  }
}

bool may_be_meant(const BoardInfo& info, const BoardChoice& choice) {
  switch (choice.by) {
    case BoardChoice::By::product_id:
      return info.vendor == choice.vendor && info.product == choice.product;
    case BoardChoice::By::address:
      return info.bus == choice.bus && info.address == choice.address;
    default:
      return std::any_of(kProductIds.begin(), kProductIds.end(),
                         [&](const ProductId& id) { return info.vendor == id.vendor && info.product == id.product; });
  }
}

std::string problem_of(int error) {
  return error == LIBUSB_ERROR_ACCESS
             ? "no permission to open it: copy fpga/host/60-cbvh.rules to /etc/udev/rules.d, run 'udevadm control "
               "--reload' and plug it in again"
             : fmt::format("cannot be opened: {}", libusb_strerror(error));
}

std::string read_string(libusb_device_handle* handle, std::uint8_t index) {
  if (index == 0) return {};
  std::array<unsigned char, 256> text{};
  const int length = libusb_get_string_descriptor_ascii(handle, index, text.data(), static_cast<int>(text.size()));
  return length > 0 ? std::string(text.begin(), text.begin() + length) : std::string();
}

void read_strings(FoundBoard& board, const libusb_device_descriptor& descriptor) {
  libusb_device_handle* opened = nullptr;
  const int error = libusb_open(board.device.get(), &opened);
  if (error != 0) {
    board.info.problem = problem_of(error);
    return;
  }
  const UsbHandle handle(opened);
  board.info.product_name = read_string(opened, descriptor.iProduct);
  board.info.serial = read_string(opened, descriptor.iSerialNumber);
}

std::string list_of(const std::vector<FoundBoard>& boards) {
  std::string text;
  for (const FoundBoard& board : boards) text += (text.empty() ? "" : "; ") + board.info.device();
  return text;
}

std::string place_of(const BoardChoice& choice) { return choice.text.empty() ? "board" : "board " + choice.text; }

}  // namespace

std::vector<FoundBoard> find_boards(libusb_context* context, const BoardChoice& choice) {
  libusb_device** list = nullptr;
  const ssize_t count = libusb_get_device_list(context, &list);
  std::vector<FoundBoard> boards;
  for (ssize_t i = 0; i < count; ++i) {
    libusb_device_descriptor descriptor{};
    if (libusb_get_device_descriptor(list[i], &descriptor) != 0) continue;
    FoundBoard board;
    board.info.kind = kind_of(descriptor);
    board.info.vendor = descriptor.idVendor;
    board.info.product = descriptor.idProduct;
    board.info.bus = libusb_get_bus_number(list[i]);
    board.info.address = libusb_get_device_address(list[i]);
    board.info.speed = speed_name(libusb_get_device_speed(list[i]));
    if (!may_be_meant(board.info, choice)) continue;
    board.device.reset(libusb_ref_device(list[i]));
    read_strings(board, descriptor);
    boards.push_back(std::move(board));
  }
  if (list != nullptr) libusb_free_device_list(list, 1);
  return boards;
}

FoundBoard choose_board(libusb_context* context, const BoardChoice& choice) {
  std::vector<FoundBoard> boards = find_boards(context, choice);
  std::string closed;  // boards that might be the one, if they could be asked
  std::erase_if(boards, [&](const FoundBoard& board) {
    if (choice.by == BoardChoice::By::product_id || choice.by == BoardChoice::By::address) return false;
    if (!board.info.problem.empty()) {
      // An FTDI chip that cannot be asked is probably somebody else's.
      if (board.info.vendor == kFtdi && choice.by == BoardChoice::By::only_one) return true;
      closed = board.info.device() + ": " + board.info.problem;
      return true;
    }
    return choice.by == BoardChoice::By::serial ? board.info.serial != choice.serial : !board.info.ours();
  });
  if (boards.size() == 1) return std::move(boards[0]);
  if (boards.size() > 1) {
    throw LinkError(
        LinkFault::ambiguous, place_of(choice),
        fmt::format("{} fit: {}; choose with --device BUS:ADDRESS or serial=TEXT", boards.size(), list_of(boards)));
  }
  if (!closed.empty()) throw LinkError(LinkFault::no_permission, place_of(choice), closed);
  throw LinkError(LinkFault::no_device, place_of(choice),
                  choice.by == BoardChoice::By::only_one
                      ? "no board is plugged in (1209:b5c0, or an FTDI chip whose product name begins with 'cbvh'); "
                        "'lsusb' lists what is, --device chooses another"
                      : "no such device is plugged in; 'cbvh board list' shows those that are");
}

void fail_usb(const BoardInfo& board, int error, const char* action) {
  switch (error) {
    case LIBUSB_ERROR_ACCESS:
      throw LinkError(LinkFault::no_permission, board.device(), problem_of(error));
    case LIBUSB_ERROR_BUSY:
      throw LinkError(LinkFault::busy, board.device(),
                      fmt::format("another program has it: 'fuser -v /dev/bus/usb/{:03}/{:03}' names it", board.bus,
                                  board.address));
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      throw LinkError(LinkFault::gone, board.device(), "it was unplugged, or has lost its power");
    default:
      throw LinkError(LinkFault::gone, board.device(), fmt::format("{}: {}", action, libusb_strerror(error)));
  }
}

UsbHandle open_device(const FoundBoard& board) {
  libusb_device_handle* handle = nullptr;
  const int error = libusb_open(board.device.get(), &handle);
  if (error != 0) fail_usb(board.info, error, "cannot be opened");
  return UsbHandle(handle);
}

Endpoints find_endpoints(const FoundBoard& board, int first_interface) {
  libusb_config_descriptor* read = nullptr;
  const int error = libusb_get_active_config_descriptor(board.device.get(), &read);
  if (error != 0) fail_usb(board.info, error, "its descriptors cannot be read");
  const std::unique_ptr<libusb_config_descriptor, void (*)(libusb_config_descriptor*)> config(
      read, &libusb_free_config_descriptor);
  for (int i = first_interface; i < config->bNumInterfaces; ++i) {
    if (config->interface[i].num_altsetting < 1) continue;
    const libusb_interface_descriptor& setting = config->interface[i].altsetting[0];
    if (setting.bInterfaceClass != LIBUSB_CLASS_VENDOR_SPEC) continue;
    Endpoints found;
    found.interface = setting.bInterfaceNumber;
    for (int e = 0; e < setting.bNumEndpoints; ++e) {
      const libusb_endpoint_descriptor& endpoint = setting.endpoint[e];
      if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK) continue;
      if ((endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0) {
        found.in = endpoint.bEndpointAddress;
        found.in_packet = endpoint.wMaxPacketSize;
      } else {
        found.out = endpoint.bEndpointAddress;
      }
    }
    if (found.in != 0 && found.out != 0 && found.in_packet != 0) return found;
  }
  throw LinkError(
      LinkFault::not_a_board, board.info.device(),
      "has no vendor class interface with bulk endpoints in and out: is it a board, and is its gateware loaded?");
}

}  // namespace cbvh::host
