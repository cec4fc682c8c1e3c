// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include "fpga/emulator/link/link.h"
#include "fpga/emulator/model/model_core.h"
#include "fpga/emulator/usbredir/usbredir_device.h"
#include "golden/input_error.h"

namespace {

using namespace cbvh;

/// A file descriptor, closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int descriptor, const char* what) : descriptor_(descriptor) {
    if (descriptor < 0) throw std::system_error(errno, std::generic_category(), what);
  }
  ~Descriptor() { ::close(descriptor_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

/// The first connection to a Unix socket that is made at `path`.
int accept_one(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof(address.sun_path)) {
    throw golden::InputError(
        "--socket", fmt::format("found {} characters, want less than {}", path.size(), sizeof(address.sun_path)));
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const Descriptor listener(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0), "socket");
  if (::bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw golden::InputError(path, std::strerror(errno));
  }
  if (::listen(listener.get(), 1) != 0) throw std::system_error(errno, std::generic_category(), "listen");
  const int connection = ::accept4(listener.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  ::unlink(path.c_str());
  return connection;
}

int run(int argc, char** argv) {
  std::string socket;
  std::string transport = "bulk";
  emulator::Unplugging unplugging;
  CLI::App app{
      "Offers the emulated board, with the C++ modules inside, to one USB host controller over usbredir:\n"
      "cbvh_usbredir --socket S, then qemu ... -device qemu-xhci,id=x -chardev socket,id=b,path=S\n"
      "  -device usb-redir,chardev=b,bus=x.0\n"
      "Ends with the connection. Exit code 2: bad usage, or the socket cannot be made."};
  app.add_option("--socket", socket, "Unix socket to listen on; must not exist")->required();
  app.add_option("--transport", transport, "bulk, ftdi-uart or ftdi-fifo")->capture_default_str();
  app.add_option("--unplug-after", unplugging.after_bytes, "pull the board out when the host has got so many bytes");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const emulator::Transport kind = emulator::parse_transport(transport);
  std::signal(SIGPIPE, SIG_IGN);
  emulator::ModelCore core;
  emulator::Link link(core, {}, 0);
  const auto function = emulator::make_function(kind, link);
  const Descriptor connection(accept_one(socket), "accept");
  emulator::UsbredirDevice device(*function, kind, connection.get(), unplugging);
  device.serve();
  fmt::print("{} bytes from the host, {} to it\n", device.bytes_from_host(), device.bytes_to_host());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "cbvh_usbredir: {}\n", error.what());
    return 2;
  }
}
