// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/gateware/simulator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
#include "testbench/rtl/memory_port.h"
#include "testbench/rtl/ports.h"

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

bool holds(const std::vector<GatewareSource>& sources, const std::string& file) {
  return std::any_of(sources.begin(), sources.end(), [&](const auto& source) { return source.name == file; });
}

/// The lines of memory that an episode can fill, as a power of two: no index is beyond the number of its stimuli.
int lines_log2(const vectors::VectorSet& set) {
  constexpr std::size_t kFewestLines = 256;
  std::size_t most = 0;
  for (std::size_t i = 0; i < set.size(); ++i) most = std::max(most, set.stimulus_range(i).size);
  return static_cast<int>(std::bit_width(std::max(kFewestLines, most / rtl::kPairsPerLine + 1) - 1));
}

/// The parameter list of the module.
std::string parameters_of(const vectors::VectorSet& set) {
  const vectors::UnitDescription& unit = set.unit();
  std::vector<std::string> parameters;
  if (unit.bits.size() > 1) parameters.push_back(fmt::format(".N({})", set.parameters().bits));
  if (unit.treelets.size() > 1) parameters.push_back(fmt::format(".D({})", set.parameters().treelet));
  if (has_harness(unit)) parameters.push_back(fmt::format(".LINES_LOG2({})", lines_log2(set)));
  return parameters.empty() ? "" : fmt::format("#({})", fmt::join(parameters, ", "));
}

/// Compiled models: one a unit, its parameters and size of memory.
class Models {
 public:
  std::string sources() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return source_folder();
  }
  /// The path of the compiled model.
  std::string get(const vectors::VectorSet& set, std::size_t stimuli, std::size_t cases) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const vectors::UnitDescription& unit = set.unit();
    const std::string parameters = parameters_of(set);
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
    const bool harness = has_harness(set.unit());
    const int code =
        run_program({"iverilog",
                     "-g2005",
                     "-o",
                     model,
                     "-s",
                     "unit_bench",
                     "-y",
                     sources,
                     "-y",
                     bench_folder(),
                     "-I",
                     sources,
                     fmt::format("-DUNIT={}", harness ? harness_name(set.unit()) : std::string(set.unit().name)),
                     fmt::format("-DPARAMETERS={}", parameters),
                     harness ? "-DHARNESS" : "-DSIMPLE",
                     fmt::format("-Punit_bench.STIMULUS_WIDTH={}", set.stimulus_codec().width),
                     fmt::format("-Punit_bench.RESPONSE_WIDTH={}", set.response_codec().width),
                     fmt::format("-Punit_bench.STIMULI={}", stimuli),
                     fmt::format("-Punit_bench.CASES={}", cases),
                     bench_folder() + "/" + kBench},
                    log);
    if (code != 0) throw golden::InputError("iverilog", read_text_file(log));
  }

  std::string source_folder() {
    if (given_folder() != nullptr) return given_folder();
    return unpacked("twins", gateware_sources());
  }
  std::string bench_folder() { return unpacked("benches", gateware_benches()); }

  std::string unpacked(const std::string& name, const std::vector<GatewareSource>& sources) {
    std::string path = fmt::format("{}/{}", folder_.path(), name);
    if (!fs::create_directory(path)) return path;
    for (const GatewareSource& source : sources) write_file(fmt::format("{}/{}", path, source.name), source.bytes);
    return path;
  }

  std::mutex mutex_;
  TemporaryFolder folder_;
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

/// Seeds of source, sink and memory, stimuli, responses.
std::string case_line(const RunOptions& options, std::uint64_t number, std::size_t stimuli, std::size_t responses) {
  return fmt::format("{:016x}{:016x}{:016x}{:08x}{:08x}\n", source_seed(options, number), sink_seed(options, number),
                     memory_seed(options, number), stimuli, responses);
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

std::string twin_folder() { return models().sources(); }

std::string harness_name(const vectors::UnitDescription& unit) { return fmt::format("{}_harness", unit.name); }

bool has_harness(const vectors::UnitDescription& unit) { return holds(gateware_benches(), harness_name(unit) + ".v"); }

bool has_twin(const vectors::UnitDescription& unit) {
  const std::string file = fmt::format("{}.v", unit.name);
  if (given_folder() != nullptr) return fs::exists(fs::path(given_folder()) / file);
  return holds(gateware_sources(), file);
}

std::string simulate_twin(const vectors::VectorSet& set, const RunOptions& options) {
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
                                      fmt::format("+drain={}", options.drain_cycles)};
  if (options.stalls == Stalls::source || options.stalls == Stalls::both) command.emplace_back("+source_stalls");
  if (options.stalls == Stalls::sink || options.stalls == Stalls::both) command.emplace_back("+sink_stalls");
  const std::string log = folder.path() + "/run.log";
  const int code = run_program(command, log);
  if (code != 0) throw std::runtime_error(fmt::format("vvp: exit code {}: {}", code, read_text_file(log)));
  std::string trace = read_text_file(folder.path() + "/trace.txt");
  if (!trace.ends_with("end\n")) throw std::runtime_error("vvp: the trace has no end: " + read_text_file(log));
  return trace;
}

}  // namespace cbvh::testbench
