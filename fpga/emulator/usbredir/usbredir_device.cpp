// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/usbredir/usbredir_device.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "fpga/emulator/link/descriptors.h"

namespace cbvh::emulator {

namespace {

constexpr std::uint8_t kDeviceToHost = 0x80;
constexpr std::uint8_t kEndpointRecipient = 0x02;
constexpr std::uint8_t kTypeMask = 0x60;  ///< of the request type: standard, class, vendor
constexpr std::uint8_t kClearFeature = 1;
constexpr int kEndpoints = 32;
constexpr std::uint16_t kPacketBytes = 512;
constexpr int kPollMilliseconds = 2;  ///< between two looks at what the board has to say

/// usbredir numbers endpoints 0..31: those out of the host by number, those into it 16 above.
std::uint8_t address_of(int slot) { return static_cast<std::uint8_t>(slot < 16 ? slot : kDeviceToHost | (slot - 16)); }

std::uint32_t length_of(const usb_redir_bulk_packet_header& header) {
  return header.length | (std::uint32_t{header.length_high} << 16U);
}

std::vector<std::uint8_t> take(usbredirparser* parser, std::uint8_t* data, int size) {
  std::vector<std::uint8_t> bytes(data, data + (data == nullptr ? 0 : size));
  usbredirparser_free_packet_data(parser, data);
  return bytes;
}

}  // namespace

UsbredirDevice::UsbredirDevice(Function& function, Transport transport, int socket, Unplugging unplugging)
    : function_(function),
      transport_(transport),
      socket_(socket),
      unplugging_(unplugging),
      parser_(make_parser(*this)) {}

std::unique_ptr<usbredirparser, UsbredirDevice::DestroyParser> UsbredirDevice::make_parser(UsbredirDevice& self) {
  using Self = UsbredirDevice;
  usbredirparser* parser = usbredirparser_create();
  if (parser == nullptr) throw std::bad_alloc();
  parser->priv = &self;
  parser->log_func = [](void* device, int level, const char* message) {
    if (level == usbredirparser_error) static_cast<Self*>(device)->error_ = message;
  };
  parser->read_func = [](void* device, std::uint8_t* data, int size) {
    return static_cast<Self*>(device)->read_socket(data, size);
  };
  parser->write_func = [](void* device, std::uint8_t* data, int size) {
    return static_cast<Self*>(device)->write_socket(data, size);
  };
  parser->hello_func = [](void* device, usb_redir_hello_header*) { static_cast<Self*>(device)->connect(); };
  parser->reset_func = [](void*) {};
  parser->set_configuration_func = [](void* device, std::uint64_t id, usb_redir_set_configuration_header* wanted) {
    usb_redir_configuration_status_header status{usb_redir_success, wanted->configuration};
    usbredirparser_send_configuration_status(static_cast<Self*>(device)->parser_.get(), id, &status);
  };
  parser->get_configuration_func = [](void* device, std::uint64_t id) {
    usb_redir_configuration_status_header status{usb_redir_success, 1};
    usbredirparser_send_configuration_status(static_cast<Self*>(device)->parser_.get(), id, &status);
  };
  parser->set_alt_setting_func = [](void* device, std::uint64_t id, usb_redir_set_alt_setting_header* wanted) {
    usb_redir_alt_setting_status_header status{usb_redir_success, wanted->interface, wanted->alt};
    usbredirparser_send_alt_setting_status(static_cast<Self*>(device)->parser_.get(), id, &status);
  };
  parser->cancel_data_packet_func = [](void* device, std::uint64_t id) { static_cast<Self*>(device)->cancel(id); };
  parser->device_disconnect_ack_func = [](void*) {};
  parser->control_packet_func = [](void* device, std::uint64_t id, usb_redir_control_packet_header* header,
                                   std::uint8_t* data, int size) {
    take(static_cast<Self*>(device)->parser_.get(), data, size);
    static_cast<Self*>(device)->control(id, *header);
  };
  parser->bulk_packet_func = [](void* device, std::uint64_t id, usb_redir_bulk_packet_header* header,
                                std::uint8_t* data, int size) {
    static_cast<Self*>(device)->bulk(id, *header, take(static_cast<Self*>(device)->parser_.get(), data, size));
  };
  std::uint32_t capabilities[USB_REDIR_CAPS_SIZE] = {};
  for (const int capability :
       {usb_redir_cap_connect_device_version, usb_redir_cap_device_disconnect_ack,
        usb_redir_cap_ep_info_max_packet_size, usb_redir_cap_64bits_ids, usb_redir_cap_32bits_bulk_length}) {
    usbredirparser_caps_set_cap(capabilities, capability);
  }
  usbredirparser_init(parser, "cbvh", capabilities, USB_REDIR_CAPS_SIZE, usbredirparser_fl_usb_host);
  return std::unique_ptr<usbredirparser, DestroyParser>(parser);
}

void UsbredirDevice::connect() {
  usb_redir_ep_info_header endpoints{};
  for (int slot = 0; slot < kEndpoints; ++slot) {
    const bool control = slot % 16 == 0;
    const bool bulk = has_endpoint(transport_, address_of(slot));
    endpoints.type[slot] = control ? usb_redir_type_control : bulk ? usb_redir_type_bulk : usb_redir_type_invalid;
    endpoints.interface[slot] = bulk ? static_cast<std::uint8_t>((slot % 16 - 1) / 2) : std::uint8_t{0};
    endpoints.max_packet_size[slot] = control ? 64 : bulk ? kPacketBytes : std::uint16_t{0};
  }
  usb_redir_interface_info_header interfaces{};
  interfaces.interface_count = interface_count(transport_);
  for (unsigned i = 0; i < interfaces.interface_count; ++i) {
    interfaces.interface[i] = static_cast<std::uint8_t>(i);
    interfaces.interface_class[i] = 0xFF;
  }
  const UsbIdentity identity = identity_of(transport_);
  usb_redir_device_connect_header device{};
  device.speed = usb_redir_speed_high;
  device.vendor_id = identity.vendor;
  device.product_id = identity.product;
  usbredirparser_send_ep_info(parser_.get(), &endpoints);
  usbredirparser_send_interface_info(parser_.get(), &interfaces);
  usbredirparser_send_device_connect(parser_.get(), &device);
  connected_ = true;
}

void UsbredirDevice::unplug() {
  connected_ = false;
  waiting_.clear();
  usbredirparser_send_device_disconnect(parser_.get());
}

void UsbredirDevice::control(std::uint64_t id, usb_redir_control_packet_header header) {
  const Setup setup{header.requesttype, header.request, header.value, header.index, header.length};
  const bool standard = (setup.request_type & kTypeMask) == 0;
  if (standard && setup.request == kClearFeature && (setup.request_type & 0x1FU) == kEndpointRecipient) {
    function_.clear_halt(static_cast<std::uint8_t>(setup.index));
  }
  auto bytes = standard ? standard_request(setup, transport_, identity_of(transport_)) : function_.control(setup);
  header.status = bytes ? usb_redir_success : usb_redir_stall;
  if (!bytes) bytes.emplace();
  if ((setup.request_type & kDeviceToHost) == 0) {
    bytes->clear();
  } else {
    bytes->resize(std::min<std::size_t>(bytes->size(), setup.length));
    header.length = static_cast<std::uint16_t>(bytes->size());
  }
  usbredirparser_send_control_packet(parser_.get(), id, &header, bytes->data(), static_cast<int>(bytes->size()));
}

void UsbredirDevice::bulk(std::uint64_t id, const usb_redir_bulk_packet_header& header,
                          std::vector<std::uint8_t> bytes) {
  Waiting transfer{id, header, std::move(bytes)};
  if (!connected_ || !has_endpoint(transport_, header.endpoint)) return answer(transfer, usb_redir_ioerror, {});
  waiting_[header.endpoint].push_back(std::move(transfer));
}

void UsbredirDevice::cancel(std::uint64_t id) {
  for (auto& [endpoint, transfers] : waiting_) {
    const auto found =
        std::find_if(transfers.begin(), transfers.end(), [&](const Waiting& transfer) { return transfer.id == id; });
    if (found == transfers.end()) continue;
    answer(*found, usb_redir_cancelled, {});
    transfers.erase(found);
    return;
  }
}

void UsbredirDevice::answer(const Waiting& transfer, std::uint8_t status, std::vector<std::uint8_t> bytes) {
  usb_redir_bulk_packet_header header = transfer.header;
  const bool into_host = (header.endpoint & kDeviceToHost) != 0;
  const std::size_t length = into_host ? bytes.size() : status == usb_redir_success ? transfer.bytes.size() : 0;
  header.status = status;
  header.length = static_cast<std::uint16_t>(length);
  header.length_high = static_cast<std::uint16_t>(length >> 16U);
  usbredirparser_send_bulk_packet(parser_.get(), transfer.id, &header, bytes.data(), static_cast<int>(bytes.size()));
}

bool UsbredirDevice::move(Waiting& transfer) {
  const bool into_host = (transfer.header.endpoint & kDeviceToHost) != 0;
  Transfer done = into_host ? function_.in(transfer.header.endpoint, length_of(transfer.header), Clock::now())
                            : function_.out(transfer.header.endpoint, transfer.bytes, Clock::now());
  switch (done.status) {
    case Transfer::Status::pending:
      return false;
    case Transfer::Status::stalled:
      answer(transfer, usb_redir_stall, {});
      return true;
    case Transfer::Status::babbled:
      answer(transfer, usb_redir_babble, {});
      return true;
    case Transfer::Status::done:
      break;
  }
  (into_host ? to_host_ : from_host_) += into_host ? done.bytes.size() : transfer.bytes.size();
  answer(transfer, usb_redir_success, std::move(done.bytes));
  return true;
}

void UsbredirDevice::move_transfers() {
  const auto plugged = [&] { return unplugging_.after_bytes == 0 || to_host_ < unplugging_.after_bytes; };
  for (auto& [endpoint, transfers] : waiting_) {
    while (plugged() && !transfers.empty() && move(transfers.front())) transfers.pop_front();
  }
  if (connected_ && !plugged()) unplug();
}

int UsbredirDevice::read_socket(std::uint8_t* data, int size) {
  const ssize_t got = ::read(socket_, data, static_cast<std::size_t>(size));
  if (got > 0) return static_cast<int>(got);
  if (got < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  closed_ = true;
  return -1;
}

int UsbredirDevice::write_socket(const std::uint8_t* data, int size) {
  const ssize_t put = ::write(socket_, data, static_cast<std::size_t>(size));
  if (put >= 0) return static_cast<int>(put);
  if (errno == EAGAIN || errno == EINTR) return 0;
  closed_ = true;
  return -1;
}

void UsbredirDevice::serve() {
  while (!closed_) {
    const bool writes = usbredirparser_has_data_to_write(parser_.get()) > 0;
    pollfd ready{socket_, static_cast<short>(writes ? POLLIN | POLLOUT : POLLIN), 0};
    if (::poll(&ready, 1, kPollMilliseconds) < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "poll");
    if ((ready.revents & (POLLIN | POLLHUP | POLLERR)) != 0 &&
        usbredirparser_do_read(parser_.get()) == usbredirparser_read_parse_error) {
      throw std::runtime_error(fmt::format("usbredir: {}", error_));
    }
    move_transfers();
    if (!closed_ && usbredirparser_has_data_to_write(parser_.get()) > 0) usbredirparser_do_write(parser_.get());
  }
}

}  // namespace cbvh::emulator
