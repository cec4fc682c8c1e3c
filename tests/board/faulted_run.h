// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fpga/emulator/usb/board.h"

namespace cbvh::testing {

/// How a run may end. Anything but a complete and right run or an error that says what happened is a defect.
enum class Ending : std::uint8_t { completed, failed, wrong };

/// What a run is told to suffer.
struct Ordeal {
  std::vector<emulator::Fault> faults;
  bool wrong_answers = false;  ///< the board computes wrong; then `completed` means that this was noticed
  emulator::Transport transport = emulator::Transport::bulk;
  std::uint64_t seed = 0;
};

struct RunReport {
  Ending ending;
  std::string what;          ///< the error, or what is wrong
  std::uint64_t faults = 0;  ///< that happened
};

/// Runs a small vector set on an emulated board over libusb, and compares every response with the golden's.
RunReport run_ordeal(emulator::UsbSystem& system, const Ordeal& ordeal);

}  // namespace cbvh::testing
