// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/gateware/simulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <stdexcept>

#include "golden/input_error.h"
#include "testbench/gateware/process.h"
#include "testbench/gateware/sources.h"
#include "testbench/output.h"
#include "testbench/rtl/ports.h"
#include "testbench/rtl/run.h"

namespace cbvh::testbench {

namespace {

namespace fs = std::filesystem;

constexpr const char* kBench = "unit_bench.v";
constexpr std::size_t kSmallestMemory = 1024;  ///< words of the bench's memories

/// A folder of Verilog given by the user, or nothing.
const char* given_folder() { return std::getenv("CBVH_GATEWARE"); }

void write_file(const std::string& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw golden::InputError(path, "cannot be written");
}

/// Compiled models: one a unit, N and size of memory.
class Models {
 public:
  /// The path of the compiled model.
  std::string get(const vectors::VectorSet& set, std::size_t stimuli, std::size_t cases) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const vectors::UnitDescription& unit = set.unit();
    const std::string parameters = unit.bits.size() > 1 ? fmt::format("#(.N({}))", set.parameters().bits) : "";
    const std::string key = fmt::format("{} {} {} {}", unit.name, parameters, stimuli, cases);
    const auto found = models_.find(key);
    if (found != models_.end()) return found->second;
    const std::string model = fmt::format("{}/{}.vvp", folder_.path(), models_.size());
    compile(set, parameters, stimuli, cases, model);
    return models_[key] = model;
  }

 private:
  void compile(const vectors::VectorSet& set, const std::string& parameters, std::size_t stimuli, std::size_t cases,
               const std::string& model) {
    const std::string sources = source_folder();
    const std::string log = folder_.path() + "/compile.log";
    const int code = run_program(
        {"iverilog", "-g2005", "-o", model, "-s", "unit_bench", "-y", sources, "-I", sources,
         fmt::format("-DUNIT={}", set.unit().name), fmt::format("-DPARAMETERS={}", parameters),
         fmt::format("-Punit_bench.STIMULUS_WIDTH={}", set.stimulus_codec().width),
         fmt::format("-Punit_bench.RESPONSE_WIDTH={}", set.response_codec().width),
         fmt::format("-Punit_bench.STIMULI={}", stimuli), fmt::format("-Punit_bench.CASES={}", cases), bench()},
        log);
    if (code != 0) throw golden::InputError("iverilog", read_text_file(log));
  }

  std::string source_folder() {
    if (given_folder() != nullptr) return given_folder();
    unpack();
    return folder_.path();
  }
  std::string bench() {
    unpack();
    return folder_.path() + "/" + kBench;
  }
  void unpack() {
    if (unpacked_) return;
    for (const GatewareSource& source : gateware_sources()) {
      write_file(fmt::format("{}/{}", folder_.path(), source.name), source.bytes);
    }
    unpacked_ = true;
  }

  std::mutex mutex_;
  TemporaryFolder folder_;
  bool unpacked_ = false;
  std::map<std::string, std::string> models_;
};

Models& models() {
  static Models all;
  return all;
}

/// Most significant digit first.
void append_hex(std::string& text, const vectors::PayloadCodec& codec, const void* payload,
                std::vector<std::uint8_t>& packed) {
  packed.assign(codec.packed_bytes(), 0);
  codec.pack(payload, packed.data());
  const std::string_view digits = "0123456789abcdef";
  for (auto i = static_cast<std::size_t>(vectors::hex_digits(static_cast<int>(codec.width))); i-- > 0;) {
    text.push_back(digits[(packed[i / 2] >> (4 * (i % 2))) & 0xFU]);
  }
  text.push_back('\n');
}

std::string stimuli_text(const vectors::VectorSet& set) {
  std::string text;
  std::vector<std::uint8_t> packed;
  for (std::size_t i = 0; i < set.stimulus_count(); ++i)
    append_hex(text, set.stimulus_codec(), set.stimulus_at(i), packed);
  return text;
}

/// Seeds of source and sink, stimuli, responses.
std::string case_line(const RunOptions& options, std::uint64_t number, std::size_t stimuli, std::size_t responses) {
  return fmt::format("{:016x}{:016x}{:08x}{:08x}\n", source_seed(options, number), sink_seed(options, number), stimuli,
                     responses);
}

std::string cases_text(const vectors::VectorSet& set, const RunOptions& options) {
  if (!set.unit().stateful) return case_line(options, set.head(0).id, set.stimulus_count(), set.stimulus_count());
  std::string text;
  for (std::size_t i = 0; i < set.size(); ++i) {
    text += case_line(options, set.head(i).id, set.stimulus_range(i).size, set.response_range(i).size);
  }
  return text;
}

std::size_t memory_words(std::size_t used) { return std::bit_ceil(std::max(used, kSmallestMemory)); }

}  // namespace

std::string why_no_simulator() {
  for (const char* program : {"iverilog", "vvp"}) {
    if (!program_exists(program)) return fmt::format("no program '{}' (Debian package iverilog)", program);
  }
  return {};
}

bool has_twin(const vectors::UnitDescription& unit) {
  const std::string file = fmt::format("{}.v", unit.name);
  if (given_folder() != nullptr) return fs::exists(fs::path(given_folder()) / file);
  const auto sources = gateware_sources();
  return std::any_of(sources.begin(), sources.end(), [&](const auto& source) { return source.name == file; });
}

std::string simulate_twin(const vectors::VectorSet& set, const RunOptions& options, TraceKind kind) {
  const std::size_t cases = set.unit().stateful ? set.size() : 1;
  const std::string model = models().get(set, memory_words(set.stimulus_count()), memory_words(cases));
  const TemporaryFolder folder;
  write_file(folder.path() + "/stimuli.hex", stimuli_text(set));
  write_file(folder.path() + "/cases.hex", cases_text(set, options));
  std::vector<std::string> command = {"vvp",
                                      "-n",
                                      model,
                                      "+folder=" + folder.path(),
                                      fmt::format("+stimuli={}", set.stimulus_count()),
                                      fmt::format("+cases={}", cases),
                                      fmt::format("+hang={}", options.hang_cycles),
                                      fmt::format("+drain={}", kDrainCycles)};
  if (options.stalls == Stalls::source || options.stalls == Stalls::both) command.emplace_back("+source_stalls");
  if (options.stalls == Stalls::sink || options.stalls == Stalls::both) command.emplace_back("+sink_stalls");
  if (kind == TraceKind::ports) command.emplace_back("+lockstep");
  const std::string log = folder.path() + "/run.log";
  const int code = run_program(command, log);
  if (code != 0) throw std::runtime_error(fmt::format("vvp: exit code {}: {}", code, read_text_file(log)));
  std::string trace = read_text_file(folder.path() + "/trace.txt");
  if (!trace.ends_with("end\n")) throw std::runtime_error("vvp: the trace has no end: " + read_text_file(log));
  return trace;
}

}  // namespace cbvh::testbench
