// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/usb/node.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>

namespace cbvh::emulator {

namespace {

constexpr unsigned kBus = 1;
constexpr std::size_t kSetupBytes = 8;
constexpr unsigned kVendorRequest = 0x40;
constexpr unsigned kIntoHost = 0x80;

std::string hex(const std::vector<std::uint8_t>& bytes) { return fmt::format("{:02X}", fmt::join(bytes, "")); }

/// The device in the words of umockdev.
std::string describe_device(const std::string& path, Transport transport, const UsbIdentity& identity,
                            unsigned number) {
  return fmt::format(
      "P: {9}\n"
      "E: DEVTYPE=usb_device\nE: DRIVER=usb\nE: SUBSYSTEM=usb\n"
      "E: DEVNAME=/dev/bus/usb/{0:03}/{1:03}\nE: BUSNUM={0:03}\nE: DEVNUM={1:03}\nE: MAJOR=189\nE: MINOR={2}\n"
      "E: PRODUCT={3:x}/{4:x}/100\n"
      "A: busnum={0}\\n\nA: devnum={1}\\n\nA: speed=480\\n\nA: bConfigurationValue=1\\n\n"
      "A: bNumConfigurations=1\\n\nA: idVendor={3:04x}\\n\nA: idProduct={4:04x}\\n\n"
      "A: manufacturer={5}\\n\nA: product={6}\\n\nA: serial={7}\\n\n"
      "H: descriptors={8}\n",
      kBus, number, number - 1, identity.vendor, identity.product, identity.manufacturer, identity.product_name,
      identity.serial, hex(descriptors(transport, identity)), path);
}

[[noreturn]] void refuse(const char* what, GError* error) {
  const std::string message = error != nullptr ? error->message : "unknown";
  g_clear_error(&error);
  throw std::runtime_error(fmt::format("umockdev: {}: {}", what, message));
}

}  // namespace

UsbNode::UsbNode(UMockdevTestbed& testbed, Transport transport, Function& function, unsigned port, unsigned number)
    : testbed_(testbed), transport_(transport), function_(function), identity_(identity_of(transport)) {
  const std::string path = fmt::format("/devices/pci0000:00/0000:00:14.0/usb{0}/{0}-{1}", kBus, port);
  device_path_ = "/sys" + path;
  node_path_ = fmt::format("/dev/bus/usb/{:03}/{:03}", kBus, number);
  const std::unique_ptr<gchar, decltype(&g_free)> root(umockdev_testbed_get_root_dir(&testbed), g_free);
  const std::filesystem::path node = root.get() + node_path_;
  std::filesystem::create_directories(node.parent_path());
  pipe_ = std::make_unique<WakePipe>(node);
  handler_.reset(umockdev_ioctl_base_new());
  g_signal_connect(handler_.get(), "handle-ioctl", G_CALLBACK(on_ioctl), this);
  g_signal_connect(handler_.get(), "client-vanished", G_CALLBACK(on_vanished), this);
  GError* error = nullptr;
  if (umockdev_testbed_attach_ioctl(&testbed, node_path_.c_str(), handler_.get(), &error) == 0) {
    refuse("cannot answer the device's ioctls", error);
  }
  if (transport != Transport::bulk) {  // a driver of the kernel's takes such chips, as serial ports
    for (unsigned interface = 0; interface < interface_count(transport); ++interface) drivers_.insert(interface);
  }
  // Last: from now on programs find it.
  if (umockdev_testbed_add_from_string(&testbed, describe_device(path, transport, identity_, number).c_str(), &error) ==
      0) {
    refuse("cannot add the device", error);
  }
  umockdev_testbed_uevent(&testbed, device_path_.c_str(), "add");
}

UsbNode::~UsbNode() {
  unplug();
  umockdev_testbed_detach_ioctl(&testbed_, node_path_.c_str(), nullptr);
  g_signal_handlers_disconnect_by_data(handler_.get(), this);
}

gboolean UsbNode::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node) {
  const Result result = static_cast<UsbNode*>(node)->ioctl(*client);
  umockdev_ioctl_client_complete(client, result.value, result.error);
  return 1;
}

void UsbNode::on_vanished(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer node) {
  static_cast<UsbNode*>(node)->forget(*client);
}

void UsbNode::unplug() {
  {
    const std::lock_guard lock(mutex_);
    if (gone_) return;
    gone_ = true;
    while (!pending_.empty()) {
      UrbPointer urb = std::move(pending_.front());
      pending_.pop_front();
      finish(std::move(urb), -ESHUTDOWN);
    }
  }
  umockdev_testbed_uevent(&testbed_, device_path_.c_str(), "remove");
  umockdev_testbed_remove_device(&testbed_, device_path_.c_str());
}

void UsbNode::finish(UrbPointer urb, int status) {
  urb->head().status = status;
  done_[urb->client].push_back(std::move(urb));
  show_reapable();
}

void UsbNode::show_reapable() {
  const bool reapable =
      std::any_of(done_.begin(), done_.end(), [](const auto& entry) { return !entry.second.empty(); });
  pipe_->set_writable(reapable);
}

bool UsbNode::has_pending() {
  const std::lock_guard lock(mutex_);
  return !pending_.empty();
}

void UsbNode::interrupt() {
  const std::lock_guard lock(mutex_);
  interrupted_ = true;
  changed_.notify_all();
}

void UsbNode::wait(Time until) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, until, [this] { return interrupted_; });
  interrupted_ = false;
}

bool UsbNode::serve() {
  bool progress = false;
  std::set<unsigned> waiting;  // endpoints whose first transfer is pending
  std::unique_lock lock(mutex_);
  for (std::size_t i = 0; i < pending_.size() && !gone_;) {
    const bool control = pending_[i]->head().type == USBDEVFS_URB_TYPE_CONTROL;
    const unsigned endpoint = control ? 0U : pending_[i]->endpoint();
    if (waiting.count(endpoint) != 0) {
      ++i;
      continue;
    }
    UrbPointer urb = std::move(pending_[i]);
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
    carried_out_ = urb.get();
    lock.unlock();
    bool ended = false;
    {
      const std::lock_guard function_lock(function_mutex_);
      ended = control ? carry_out_control(*urb) : carry_out(*urb);
    }
    lock.lock();
    carried_out_ = nullptr;
    progress = progress || ended;
    if (urb->client == nullptr) continue;
    if (ended) {
      const int status = urb->head().status;
      finish(std::move(urb), status);
    } else if (gone_ || urb->discarded) {
      finish(std::move(urb), gone_ ? -ESHUTDOWN : -ENOENT);
    } else {
      pending_.push_front(std::move(urb));  // it is its endpoint's first
      waiting.insert(endpoint);
      i = 0;
    }
  }
  return progress;
}

bool UsbNode::carry_out(Urb& urb) {
  usbdevfs_urb& head = urb.head();
  const bool into_host = (head.endpoint & kIntoHost) != 0;
  const Time now = Clock::now();
  const Transfer transfer = into_host ? function_.in(head.endpoint, urb.buffer().size(), now)
                                      : function_.out(head.endpoint, urb.buffer(), now);
  head.actual_length = 0;
  switch (transfer.status) {
    case Transfer::Status::pending:
      return false;
    case Transfer::Status::stalled:
      head.status = -EPIPE;
      return true;
    case Transfer::Status::babbled:
      head.status = -EOVERFLOW;
      return true;
    case Transfer::Status::done:
      break;
  }
  head.status = 0;
  head.actual_length = into_host ? static_cast<int>(transfer.bytes.size()) : head.buffer_length;
  std::copy(transfer.bytes.begin(), transfer.bytes.end(), urb.buffer().begin());
  return true;
}

bool UsbNode::carry_out_control(Urb& urb) {
  usbdevfs_urb& head = urb.head();
  const std::span<std::uint8_t> bytes = urb.buffer();
  const auto word = [&](std::size_t at) { return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8U)); };
  const Setup setup{bytes[0], bytes[1], word(2), word(4), word(6)};
  const auto answer = (setup.request_type & kVendorRequest) != 0 ? function_.control(setup)
                                                                 : standard_request(setup, transport_, identity_);
  head.actual_length = 0;
  head.status = answer ? 0 : -EPIPE;
  if (!answer) return true;
  if ((setup.request_type & kIntoHost) == 0) {
    head.actual_length = setup.length;
    return true;
  }
  const std::size_t length = std::min({answer->size(), std::size_t{setup.length}, bytes.size() - kSetupBytes});
  std::copy_n(answer->begin(), length, bytes.begin() + kSetupBytes);
  head.actual_length = static_cast<int>(length);
  return true;
}

}  // namespace cbvh::emulator
