// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/usb/board.h"

namespace cbvh::emulator {

namespace {
constexpr unsigned kNumbersPerPort = 31;          ///< of the bus's 127; the bus itself is 1
constexpr std::chrono::milliseconds kPolling{2};  ///< of a core, while the host waits for it
constexpr std::chrono::milliseconds kIdle{1000};
constexpr std::chrono::milliseconds kUnplugged{50};  ///< before a board that returns does
constexpr std::chrono::milliseconds kUnpluggedStep{5};

/// A device has another number each time it is plugged in.
unsigned number_of(unsigned port, std::size_t plugged) {
  return 2 + (port - 1) * kNumbersPerPort + static_cast<unsigned>(plugged % kNumbersPerPort);
}
}  // namespace

UsbSystem::UsbSystem() : testbed_(umockdev_testbed_new()) {}

std::string UsbSystem::root() const {
  const std::unique_ptr<gchar, decltype(&g_free)> root(umockdev_testbed_get_root_dir(testbed_.get()), g_free);
  return root.get();
}

UsbBoard::UsbBoard(UsbSystem& system, Transport transport, Link& link, unsigned port)
    : system_(system), transport_(transport), link_(link), port_(port), function_(make_function(transport, link)) {
  nodes_.push_back(std::make_unique<UsbNode>(system_.testbed(), transport_, *function_, port_, number_of(port_, 0)));
  plugged_ = 1;
  thread_ = std::thread([this] { run(); });
}

UsbBoard::~UsbBoard() {
  ends_ = true;
  {
    const std::lock_guard lock(mutex_);
    nodes_.back()->interrupt();
  }
  thread_.join();
}

void UsbBoard::run() {
  for (;;) {
    const Plug plug = serve(*nodes_.back());
    if (ends_) return;
    nodes_.back()->unplug();
    if (plug == Plug::leaves) return;
    const Time returns = Clock::now() + kUnplugged;
    while (Clock::now() < returns && !ends_) std::this_thread::sleep_for(kUnpluggedStep);
    link_.power_on();
    function_->power_on();
    ++plugged_;
    if (nodes_.size() >= kNumbersPerPort) nodes_[nodes_.size() - kNumbersPerPort].reset();  // its number comes again
    auto node =
        std::make_unique<UsbNode>(system_.testbed(), transport_, *function_, port_, number_of(port_, nodes_.size()));
    const std::lock_guard lock(mutex_);
    nodes_.push_back(std::move(node));
  }
}

Plug UsbBoard::serve(UsbNode& node) {
  while (!ends_) {
    const bool progress = node.serve();
    if (const Plug plug = link_.plug(); plug != Plug::stays) return plug;
    if (progress) continue;
    Time until = Clock::now() + (node.has_pending() ? kPolling : kIdle);
    if (const auto wake = function_->wake(); wake && *wake > Clock::now()) until = std::min(until, *wake);
    node.wait(until);
  }
  return Plug::stays;
}

}  // namespace cbvh::emulator
