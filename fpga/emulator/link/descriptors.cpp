// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/link/descriptors.h"

#include "fpga/emulator/link/bulk_function.h"

namespace cbvh::emulator {

namespace {

constexpr std::uint8_t kDevice = 1;
constexpr std::uint8_t kConfiguration = 2;
constexpr std::uint8_t kString = 3;
constexpr std::uint8_t kInterface = 4;
constexpr std::uint8_t kEndpoint = 5;
constexpr std::uint8_t kDeviceBytes = 18;
constexpr std::uint8_t kVendorClass = 0xFF;
constexpr std::uint8_t kBulk = 2;
constexpr std::uint16_t kLanguages = 0x0409;

constexpr std::uint8_t low(std::uint16_t value) { return static_cast<std::uint8_t>(value & 0xFFU); }
constexpr std::uint8_t high(std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8U); }

/// The endpoints of each interface: into the host, out of it.
std::vector<std::vector<std::uint8_t>> endpoints(Transport transport) {
  switch (transport) {
    case Transport::bulk:
      return {{BulkFunction::kIn, BulkFunction::kOut}};
    case Transport::ftdi_uart:
      return {{0x81, 0x02}, {0x83, 0x04}};
    case Transport::ftdi_fifo:
      return {{0x81, 0x02}};
  }
  return {};
}

std::uint16_t release(Transport transport) {
  switch (transport) {
    case Transport::ftdi_uart:
      return 0x0700;  // FT2232H
    case Transport::ftdi_fifo:
      return 0x0900;  // FT232H
    default:
      return 0x0100;
  }
}

std::vector<std::uint8_t> string_descriptor(std::uint8_t index, const UsbIdentity& identity) {
  if (index == 0) return {4, kString, low(kLanguages), high(kLanguages)};
  const std::string& text = index == 1 ? identity.manufacturer : index == 2 ? identity.product_name : identity.serial;
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(2 + 2 * text.size()), kString};
  for (const char character : text) {
    bytes.push_back(static_cast<std::uint8_t>(character));
    bytes.push_back(0);
  }
  return bytes;
}

}  // namespace

UsbIdentity identity_of(Transport transport) {
  switch (transport) {
    case Transport::ftdi_uart:
      return {0x0403, 0x6010, "cbvh", "cbvh emulated board", "EMULATED"};
    case Transport::ftdi_fifo:
      return {0x0403, 0x6014, "cbvh", "cbvh emulated board", "EMULATED"};
    default:
      return {0x1209, 0xB5C0, "cbvh", "cbvh emulated board", "EMULATED"};
  }
}

std::vector<std::uint8_t> descriptors(Transport transport, const UsbIdentity& identity) {
  const std::uint16_t version = release(transport);
  std::vector<std::uint8_t> bytes = {kDeviceBytes,
                                     kDevice,
                                     0x00,
                                     0x02,
                                     transport == Transport::bulk ? kVendorClass : std::uint8_t{0},
                                     0,
                                     0,
                                     64,
                                     low(identity.vendor),
                                     high(identity.vendor),
                                     low(identity.product),
                                     high(identity.product),
                                     low(version),
                                     high(version),
                                     1,
                                     2,
                                     3,
                                     1};
  const auto interfaces = endpoints(transport);
  std::vector<std::uint8_t> rest;
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    rest.insert(rest.end(), {9, kInterface, static_cast<std::uint8_t>(i), 0,
                             static_cast<std::uint8_t>(interfaces[i].size()), kVendorClass, 0xFF, 0xFF, 2});
    for (const std::uint8_t address : interfaces[i])
      rest.insert(rest.end(), {7, kEndpoint, address, kBulk, 0x00, 0x02, 0});
  }
  const auto total = static_cast<std::uint16_t>(9 + rest.size());
  bytes.insert(bytes.end(), {9, kConfiguration, low(total), high(total), static_cast<std::uint8_t>(interfaces.size()),
                             1, 0, 0x80, 50});
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

std::optional<std::vector<std::uint8_t>> standard_request(const Setup& setup, Transport transport,
                                                          const UsbIdentity& identity) {
  enum : std::uint8_t { get_status = 0, get_descriptor = 6, get_configuration = 8, get_interface = 10 };
  if ((setup.request_type & 0x80U) == 0) return std::vector<std::uint8_t>();
  switch (setup.request) {
    case get_status:
      return std::vector<std::uint8_t>{0, 0};
    case get_configuration:
      return std::vector<std::uint8_t>{1};
    case get_interface:
      return std::vector<std::uint8_t>{0};
    case get_descriptor: {
      const std::uint8_t kind = high(setup.value);
      const std::uint8_t number = low(setup.value);
      const std::vector<std::uint8_t> all = descriptors(transport, identity);
      if (kind == kDevice) return std::vector(all.begin(), all.begin() + kDeviceBytes);
      if (kind == kConfiguration) return std::vector(all.begin() + kDeviceBytes, all.end());
      if (kind == kString && number <= 3) return string_descriptor(number, identity);
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

unsigned interface_count(Transport transport) { return static_cast<unsigned>(endpoints(transport).size()); }

bool has_endpoint(Transport transport, std::uint8_t endpoint) {
  for (const auto& interface : endpoints(transport)) {
    for (const std::uint8_t address : interface) {
      if (address == endpoint) return true;
    }
  }
  return false;
}

}  // namespace cbvh::emulator
