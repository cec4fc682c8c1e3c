// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

#include "golden/input_error.h"
#include "rtl_model/kernel/vcd.h"
#include "vectors/format/output.h"

namespace cbvh::testbench {

/// Which waveforms to write, and where.
struct WaveformRequest {
  std::string path;
  std::string module;  ///< only the channels of this module; empty: all
  std::uint64_t first_cycle = 0;
  std::uint64_t last_cycle = ~std::uint64_t{0};
};

/// "a:b", cycles a to b; either may be left out. Throws InputError.
void parse_cycles(const std::string& text, WaveformRequest& request);

/// A stream into a file that takes its name only when it is complete.
class AtomicStream {
 public:
  explicit AtomicStream(const std::string& path) : buffer_(path), stream_(&buffer_) {}

  std::ostream& stream() { return stream_; }
  void commit() { buffer_.output.commit(); }

 private:
  struct Buffer : std::streambuf {
    explicit Buffer(const std::string& path) : output(vectors::Output::to_file(path)) {}
    int_type overflow(int_type character) override {
      const char byte = traits_type::to_char_type(character);
      output.append({&byte, 1});
      return character;
    }
    std::streamsize xsputn(const char* bytes, std::streamsize count) override {
      output.append({bytes, static_cast<std::size_t>(count)});
      output.flush_when_large();
      return count;
    }
    vectors::Output output;
  };

  Buffer buffer_;
  std::ostream stream_;
};

/// The channels of a design as a VCD file, each below the module that fills it.
class Waveform {
 public:
  template <class Design>
  Waveform(const WaveformRequest& request, const Design& design)
      : file_(request.path), dump_(file_.stream(), "", request.first_cycle, request.last_cycle) {
    std::vector<std::string> known;
    design.channels(
        [&](const std::string& name, const std::string& producer, const std::string& consumer, const auto& channel) {
          known.insert(known.end(), {producer, consumer});
          if (!request.module.empty() && request.module != producer && request.module != consumer) return;
          dump_.add(producer + "." + consumer + "_" + name, channel);
        });
    if (dump_.signals() > 0) return;
    std::sort(known.begin(), known.end());
    known.erase(std::unique(known.begin(), known.end()), known.end());
    throw golden::InputError("--scope",
                             fmt::format("no module '{}', there are {}", request.module, fmt::join(known, ", ")));
  }

  void sample(std::uint64_t cycle) { dump_.sample(cycle); }
  void commit() { file_.commit(); }

 private:
  AtomicStream file_;
  rtl::ValueChangeDump dump_;
};

}  // namespace cbvh::testbench
