// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/host/boards.h"

#include <fmt/format.h>

#include <charconv>

#include "golden/input_error.h"

namespace cbvh::host {

namespace {

template <class T>
bool read_number(std::string_view text, int base, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return error == std::errc() && end == text.data() + text.size();
}

template <class T>
bool read_pair(std::string_view text, int base, T& first, T& second) {
  const std::size_t colon = text.find(':');
  return colon != std::string_view::npos && read_number(text.substr(0, colon), base, first) &&
         read_number(text.substr(colon + 1), base, second);
}

}  // namespace

BoardChoice BoardChoice::parse(const std::string& option, const std::string& text) {
  BoardChoice choice;
  choice.text = text;
  if (text.empty()) return choice;
  bool good = false;
  if (text.starts_with("serial=")) {
    choice.by = By::serial;
    choice.serial = text.substr(std::string_view("serial=").size());
    good = !choice.serial.empty();
  } else if (text.starts_with("usb:")) {
    choice.by = By::product_id;
    good = read_pair(std::string_view(text).substr(4), 16, choice.vendor, choice.product);
  } else {
    choice.by = By::address;
    good = read_pair(text, 10, choice.bus, choice.address);
  }
  if (!good) {
    throw golden::InputError(option, fmt::format("found '{}', want usb:VVVV:PPPP, serial=TEXT or BUS:ADDRESS", text));
  }
  return choice;
}

std::string to_string(BoardKind kind) {
  switch (kind) {
    case BoardKind::bulk:
      return "bulk";
    case BoardKind::ftdi_uart:
      return "ftdi uart";
    case BoardKind::ftdi_fifo:
      return "ftdi fifo";
  }
  return {};
}

std::string BoardInfo::device() const {
  std::string text = fmt::format("usb {}:{} {:04x}:{:04x}", bus, address, vendor, product);
  if (!product_name.empty()) text += fmt::format(" '{}'", product_name);
  if (!serial.empty()) text += " serial " + serial;
  return text;
}

}  // namespace cbvh::host
