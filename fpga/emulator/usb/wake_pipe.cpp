// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/usb/wake_pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace cbvh::emulator {

namespace {
constexpr int kPipeBytes = 4096;  ///< the least that the kernel gives
constexpr mode_t kEveryone = 0666;
}  // namespace

WakePipe::WakePipe(const std::string& path) : path_(path), file_(-1) {
  if (mkfifo(path.c_str(), kEveryone) == 0) file_ = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file_ < 0 || fcntl(file_, F_SETPIPE_SZ, kPipeBytes) < 0) {
    throw std::runtime_error(fmt::format("{}: cannot make the pipe: {}", path, std::strerror(errno)));
  }
  fill();
}

WakePipe::~WakePipe() {
  close(file_);
  unlink(path_.c_str());
}

void WakePipe::set_writable(bool writable) {
  if (writable == writable_) return;
  writable_ = writable;
  writable ? drain() : fill();
}

void WakePipe::fill() const {
  const std::array<char, kPipeBytes> bytes{};
  while (write(file_, bytes.data(), bytes.size()) > 0) {
  }
}

void WakePipe::drain() const {
  std::array<char, kPipeBytes> bytes;
  while (read(file_, bytes.data(), bytes.size()) > 0) {
  }
}

}  // namespace cbvh::emulator
