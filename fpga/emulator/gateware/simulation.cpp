// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "fpga/emulator/gateware/simulation.h"

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "golden/input_error.h"
#include "testbench/gateware/simulator.h"
#include "testbench/gateware/sources.h"
#include "testbench/output.h"
#include "testbench/unavailable.h"
#include "vectors/registry.h"

namespace cbvh::emulator {

namespace {

constexpr int kAnswerMilliseconds = 60'000;

void write_file(const std::string& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw golden::InputError(path, "cannot be written");
}

std::string unit_macro(const std::string& unit) {
  std::string name = "CBVH_UNIT_" + unit;
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

/// Compiles the engine with its unit. The path of the model.
std::string compile(const SimulationOptions& options, const std::string& folder) {
  const std::string why = testbench::why_no_simulator();
  if (!why.empty()) throw testbench::Unavailable(fmt::format("gateware core: {}", why));
  if (!testbench::has_twin(vectors::find_unit(options.unit))) {
    throw testbench::Unavailable(fmt::format("gateware core: has no unit '{}'", options.unit));
  }
  std::vector<std::string> command = {"iverilog",
                                      "-g2005",
                                      "-s",
                                      "engine_bench",
                                      "-D" + unit_macro(options.unit),
                                      fmt::format("-DCBVH_ENGINE={}", options.pins ? "uart_pins" : "frame_engine")};
  for (const auto& [name, value] :
       {std::pair("N", options.bits), std::pair("D", options.treelet), std::pair("BUFFERS", options.buffers),
        std::pair("BUFFER_BITS", options.buffer_bits), std::pair("RESULT_BITS", options.result_bits)}) {
    command.push_back(fmt::format("-Pengine_bench.{}={}", name, value));
  }
  if (const char* given = std::getenv("CBVH_GATEWARE")) command.insert(command.end(), {"-y", given, "-I", given});
  for (const auto& sources :
       {testbench::gateware_sources(), testbench::gateware_benches(), testbench::gateware_engine()}) {
    for (const auto& source : sources) write_file(fmt::format("{}/{}", folder, source.name), source.bytes);
  }
  std::string model = folder + "/engine.vvp";
  const std::string log = folder + "/compile.log";
  command.insert(command.end(), {"-y", folder, "-I", folder, "-o", model, folder + "/engine_bench.v"});
  if (testbench::run_program(command, log) != 0) throw golden::InputError("iverilog", testbench::read_text_file(log));
  return model;
}

}  // namespace

Simulation::Simulation(const SimulationOptions& options) {
  std::vector<std::string> command = {"vvp", "-n", compile(options, folder_.path())};
  if (options.stalls) command.push_back(fmt::format("+stalls={}", *options.stalls));
  start(command);
}

Simulation::~Simulation() { stop(); }

void Simulation::start(const std::vector<std::string>& command) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::system_error(errno, std::generic_category(), "socketpair");
  }
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error = posix_spawnp(&child_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  socket_ = ends[0];
  if (error != 0) {
    child_ = -1;
    stop();
    throw std::runtime_error(fmt::format("{}: {}", command[0], std::strerror(error)));
  }
}

void Simulation::stop() {
  if (socket_ >= 0) close(socket_);
  socket_ = -1;
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
}

bool Simulation::write_all(const std::string& text) {
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    sent += static_cast<std::size_t>(count);
  }
  return true;
}

/// All up to and with the line that ends it.
std::optional<std::string> Simulation::read_answer() {
  for (;;) {
    const std::size_t dot = read_.find('.');
    const std::size_t end = dot == std::string::npos ? dot : read_.find('\n', dot);
    if (end != std::string::npos) {
      std::string answer = read_.substr(0, end);
      read_.erase(0, end + 1);
      return answer;
    }
    pollfd readable = {socket_, POLLIN, 0};
    const int ready = poll(&readable, 1, kAnswerMilliseconds);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return std::nullopt;
    char buffer[65536];
    const ssize_t count = ::read(socket_, buffer, sizeof(buffer));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    read_.append(buffer, static_cast<std::size_t>(count));
  }
}

std::optional<Simulation::Answer> Simulation::request(const std::string& text) {
  std::optional<std::string> lines;
  if (socket_ >= 0 && write_all(text)) lines = read_answer();
  if (!lines) {
    stop();
    return std::nullopt;
  }
  Answer answer;
  const char* at = lines->data();
  const char* const end = at + lines->size();
  while (at != end && *at != '.') {
    std::uint8_t byte = 0;
    const auto [next, error] = std::from_chars(at, end, byte, 16);
    if (error != std::errc() || next == end) {  // a byte without a value: broken gateware; the host's checksums tell
      while (at != end && *at != '\n') ++at;
    } else {
      at = next;
    }
    answer.bytes.push_back(byte);
    if (at != end) ++at;
  }
  int busy = 1;
  if (end - at > 2) {
    const auto [next, error] = std::from_chars(at + 2, end, answer.left);
    if (error == std::errc() && next != end) std::from_chars(next + 1, end, busy);
  }
  answer.busy = busy != 0;
  return answer;
}

std::optional<Simulation::Answer> Simulation::run(std::span<const std::uint8_t> bytes, unsigned clocks) {
  std::string text = fmt::format("{} {}\n", bytes.size(), clocks);
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}\n", byte);
  return request(text);
}

bool Simulation::restart() { return request("-1 0\n").has_value(); }

}  // namespace cbvh::emulator
