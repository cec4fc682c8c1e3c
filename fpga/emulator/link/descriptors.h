// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fpga/emulator/link/function.h"

/// What a device tells about itself.
namespace cbvh::emulator {

struct UsbIdentity {
  std::uint16_t vendor;
  std::uint16_t product;
  std::string manufacturer;
  std::string product_name;
  std::string serial;
};

/// What boards of this transport have.
UsbIdentity identity_of(Transport transport);

/// Device descriptor, then the configuration with its interfaces and endpoints, as sysfs has them.
std::vector<std::uint8_t> descriptors(Transport transport, const UsbIdentity& identity);

/// The answer to a standard request of the device; nothing: stalled.
std::optional<std::vector<std::uint8_t>> standard_request(const Setup& setup, Transport transport,
                                                          const UsbIdentity& identity);

/// How many interfaces the device has.
unsigned interface_count(Transport transport);
/// Whether an interface number or an endpoint address is the device's.
bool has_endpoint(Transport transport, std::uint8_t endpoint);

}  // namespace cbvh::emulator
