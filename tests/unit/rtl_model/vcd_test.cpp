// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "rtl_model/kernel/vcd.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "rtl_model/compress/serial_node_pair_compressor.h"
#include "rtl_model/kernel/clock.h"

namespace cbvh::rtl {
namespace {

/// A reader of our own of the few VCD words we write: the values of every signal at every time.
struct Waveform {
  std::map<std::string, std::string> identifier_of;                     ///< by path
  std::map<std::string, int> width_of;                                  ///< by identifier
  std::map<std::string, std::map<std::uint64_t, std::string>> changes;  ///< by identifier, then time
  std::uint64_t first_time = ~std::uint64_t{0};
  std::uint64_t last_time = 0;

  std::string value(const std::string& path, std::uint64_t time) const {
    const auto& history = changes.at(identifier_of.at(path));
    const auto after = history.upper_bound(time);
    return after == history.begin() ? "?" : std::prev(after)->second;
  }
};

Waveform read(const std::string& text) {
  Waveform wave;
  std::istringstream in(text);
  std::vector<std::string> scopes;
  std::string word;
  std::uint64_t time = 0;
  while (in >> word) {
    if (word == "$scope") {
      std::string kind, name;
      in >> kind >> name >> word;
      scopes.push_back(name);
    } else if (word == "$upscope") {
      in >> word;
      scopes.pop_back();
    } else if (word == "$var") {
      std::string kind, width, identifier, name, path;
      in >> kind >> width >> identifier >> name;
      while (in >> word && word != "$end") {
      }
      for (const auto& scope : scopes) path += scope + ".";
      EXPECT_TRUE(wave.identifier_of.emplace(path + name, identifier).second) << path + name << " twice";
      EXPECT_TRUE(wave.width_of.emplace(identifier, std::stoi(width)).second) << identifier << " twice";
    } else if (word[0] == '#') {
      time = std::stoull(word.substr(1));
      wave.first_time = std::min(wave.first_time, time);
      wave.last_time = std::max(wave.last_time, time);
    } else if (word[0] == 'b') {
      std::string identifier;
      in >> identifier;
      if (word != "bx") {
        EXPECT_EQ(static_cast<int>(word.size()) - 1, wave.width_of.at(identifier));
      }
      wave.changes[identifier][time] = word.substr(1);
    } else if (word[0] == '0' || word[0] == '1' || word[0] == 'x') {
      wave.changes[word.substr(1)][time] = word.substr(0, 1);
    } else {
      while (word != "$end" && in >> word) {
      }
    }
  }
  EXPECT_TRUE(scopes.empty());
  return wave;
}

PairJob some_job() {
  PairJob job;
  job.registers.min_scale = Scale(-17);
  for (std::size_t child = 0; child < 2; ++child) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      job.pair.box[child].upper[axis] = Float32::of(static_cast<float>(3 + axis + child));
  }
  return job;
}

/// The serial compressor at work on one pair.
std::string dump_of(const std::string& scope, std::uint64_t first, std::uint64_t last) {
  Channel<PairJob> jobs;
  Channel<PairResult<6>> results;
  SerialNodePairCompressor<MachineBits, 6> unit(jobs, results);
  Clock clock(unit, jobs, results);
  std::ostringstream out;
  ValueChangeDump dump(out, scope, first, last);
  dump.add("bench.jobs", jobs);
  dump.add("bench.results", results);
  dump.add("bench.unit", unit);
  jobs.push(some_job());
  for (int i = 0; i < 40; ++i) {
    clock.step();
    dump.sample(clock.cycle());
  }
  return out.str();
}

TEST(ValueChangeDump, shows_every_channel_with_its_handshake_and_its_fields_in_the_right_cycle) {
  const auto wave = read(dump_of("", 0, 1000));
  EXPECT_EQ(wave.value("bench.jobs.valid", 1), "1");
  EXPECT_EQ(wave.value("bench.jobs.valid", 2), "0");
  EXPECT_EQ(wave.value("bench.unit.estimates.valid", 4), "0");
  EXPECT_EQ(wave.value("bench.unit.estimates.valid", 5), "1");
  EXPECT_EQ(wave.value("bench.results.valid", 14), "0");
  EXPECT_EQ(wave.value("bench.results.valid", 15), "1") << "latency 14 after the job was taken in cycle 1";
  EXPECT_EQ(wave.value("bench.results.pair_child_0_hi_x", 15), "011001") << "3 on a grid of 1/8, exclusive";
  EXPECT_EQ(wave.value("bench.jobs.registers_min_scale", 1), "111101111");
}

TEST(ValueChangeDump, holds_only_the_scope_and_the_cycles_asked_for) {
  const auto wave = read(dump_of("bench.unit", 5, 9));
  EXPECT_EQ(wave.identifier_of.count("bench.jobs.valid"), 0u);
  EXPECT_EQ(wave.identifier_of.count("bench.unit.axis_jobs.valid"), 1u);
  EXPECT_EQ(wave.first_time, 5u);
  EXPECT_LE(wave.last_time, 9u);
  EXPECT_EQ(read(dump_of("bench.uni", 0, 9)).identifier_of.size(), 0u) << "a scope is a whole name";
}

}  // namespace
}  // namespace cbvh::rtl
