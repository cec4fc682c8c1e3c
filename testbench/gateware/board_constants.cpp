// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/gateware/board_constants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "fpga/host/frame.h"
#include "fpga/host/messages.h"
#include "testbench/gateware/simulator.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

namespace {

using host::ErrorReason;
using host::FrameType;

constexpr unsigned kFirmwareVersion = 1;

void define(std::string& text, const std::string& name, const std::string& value) {
  text += fmt::format("`define CBVH_{} {}\n", name, value);
}
void define(std::string& text, const std::string& name, FrameType type) {
  define(text, "FRAME_" + name, fmt::format("8'h{:02X}", static_cast<unsigned>(type)));
}
void define(std::string& text, const std::string& name, ErrorReason reason) {
  define(text, "ERROR_" + name, fmt::format("4'd{}", static_cast<unsigned>(reason)));
}

void define_link(std::string& text) {
  define(text, "FRAME_MAGIC", fmt::format("16'h{:02X}{:02X}", host::kMagic[1], host::kMagic[0]));
  define(text, "PROTOCOL_VERSION", fmt::format("{}", host::kProtocolVersion));
  define(text, "FIRMWARE_VERSION", fmt::format("{}", kFirmwareVersion));
  // What is left of any message that is followed by its own checksum.
  define(text, "CRC32C_RESIDUE", fmt::format("32'h{:08X}", ~host::crc32c(host::Bytes(4, 0))));
  define(text, "HELLO", FrameType::hello);
  define(text, "OPEN", FrameType::open);
  define(text, "VECTORS", FrameType::vectors);
  define(text, "STATUS", FrameType::status);
  define(text, "RESET", FrameType::reset);
  define(text, "BOARD_HELLO", FrameType::board_hello);
  define(text, "BOARD_OPEN", FrameType::board_open);
  define(text, "RESULTS", FrameType::results);
  define(text, "BOARD_STATUS", FrameType::board_status);
  define(text, "BOARD_RESET", FrameType::board_reset);
  define(text, "CREDIT", FrameType::credit);
  define(text, "ERROR", FrameType::error);
  define(text, "VERSION", ErrorReason::version);
  define(text, "TYPE", ErrorReason::type);
  define(text, "LENGTH", ErrorReason::length);
  define(text, "UNIT", ErrorReason::unit);
  define(text, "PARAMETERS", ErrorReason::parameters);
  define(text, "NOT_OPEN", ErrorReason::not_open);
  define(text, "CREDIT", ErrorReason::credit);
  define(text, "RESPONSES", ErrorReason::responses);
}

std::string upper_case(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// 32 bytes, the first letter lowest.
std::string name_digits(std::string_view name) {
  std::string text = fmt::format("{}'h", 8 * host::kNameBytes);
  for (std::size_t i = host::kNameBytes; i-- > 0;) text += fmt::format("{:02X}", i < name.size() ? name[i] : '\0');
  return text;
}

/// In terms of N where the unit has one. Widths are linear in it.
std::string width(const vectors::UnitDescription& unit, const vectors::PayloadCodec& (*codec)(int bits)) {
  const int low = unit.bits.front();
  const auto at_low = static_cast<int>(codec(low).width);
  if (unit.bits.size() == 1) return fmt::format("({})", at_low);
  const int slope = (static_cast<int>(codec(unit.bits.back()).width) - at_low) / (unit.bits.back() - low);
  const int constant = at_low - slope * low;
  for (const int n : unit.bits) {
    if (static_cast<int>(codec(n).width) != slope * n + constant) {
      throw std::logic_error(fmt::format("{}: a payload's width is not linear in N", unit.name));
    }
  }
  return slope == 0 ? fmt::format("({})", constant) : fmt::format("({}*N+{})", slope, constant);
}

void define_unit(std::string& text, const vectors::UnitDescription& unit) {
  const bool any_bits = unit.bits.size() > 1;
  const bool any_treelet = unit.treelets.size() > 1;
  text += fmt::format("\n`ifdef CBVH_UNIT_{}\n", upper_case(unit.name));
  std::vector<std::string> parameters;
  if (any_bits) parameters.emplace_back(".N(N)");
  if (any_treelet) parameters.emplace_back(".D(D)");
  if (has_harness(unit)) {
    define(text, "UNIT_MEMORY", "1");
    parameters.emplace_back(".LINES_LOG2(LINES_LOG2)");
  }
  define(text, "UNIT", has_harness(unit) ? harness_name(unit) : std::string(unit.name));
  define(text, "UNIT_PARAMETERS", parameters.empty() ? "" : fmt::format("#({})", fmt::join(parameters, ", ")));
  define(text, "UNIT_ID", fmt::format("32'h{:08X}", host::unit_id(unit.name)));
  define(text, "UNIT_NAME", name_digits(unit.name));
  define(text, "UNIT_STATE", unit.stateful ? "1" : "0");
  define(text, "UNIT_N_MASK", any_bits ? "(16'd1 << N)" : fmt::format("16'd{}", 1U << unit.bits.front()));
  define(text, "UNIT_D_MASK", any_treelet ? "(16'd1 << D)" : fmt::format("16'd{}", 1U << unit.treelets.front()));
  define(text, "STIMULUS_WIDTH", width(unit, unit.stimulus));
  define(text, "RESPONSE_WIDTH", width(unit, unit.response));
  text += "`endif\n";
}

}  // namespace

std::string board_constants() {
  std::string text =
      "// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0\n"
      "// Made by `cbvh gateware --board` from the C++ model: numbers of the board link, and the unit of this "
      "gateware. A\n"
      "// macro CBVH_UNIT_x chooses it; N is the parameter of the module that uses the widths. UNIT_MEMORY: it runs in "
      "a harness.\n"
      "`ifndef CBVH_BOARD\n"
      "`define CBVH_BOARD\n\n";
  define_link(text);
  for (const vectors::UnitDescription& unit : vectors::units()) define_unit(text, unit);
  return text + "\n`endif\n";
}

}  // namespace cbvh::testbench
