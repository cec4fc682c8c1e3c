// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/binary.h"

#include <cstring>

#include "vectors/format/printable.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

constexpr std::uint32_t kVersion = 1;
enum Tag : std::uint8_t { kCase = 'C', kEnd = 'E' };

std::string class_names(const UnitDescription& unit) {
  std::string names;
  for (const std::string_view name : unit.classes) names += (names.empty() ? "" : ":") + std::string(name);
  return names;
}

class BinaryReader final : public SetReader {
 public:
  BinaryReader(std::string_view bytes, std::string name) : name_(std::move(name)), bytes_(bytes) {
    at_ = kBinaryMagic.size();  // whoever chose this reader saw it
    const auto version = number<std::uint32_t>("version");
    if (version != kVersion) fail(fmt::format("version: found {}, want {}", version, kVersion));
    parameters_.bits = number<std::uint16_t>("bits");
    parameters_.treelet = number<std::uint16_t>("treelet");
    seed_ = number<std::uint64_t>("seed");
    const std::string unit = printable_short(text("unit"));
    try {
      unit_ = &find_unit(unit);
      make_set(*unit_, parameters_, 0);
    } catch (const golden::InputError& error) {
      fail(error.what());
    }
    const auto expect_names = [this](const char* what, const std::string& want) {
      const std::string_view found = text(what);
      if (found != want) fail(fmt::format("the {} of {} are {}, found {}", what, unit_->name, want, printable(found)));
    };
    expect_names("fields", unit_->field_names(parameters_.bits));
    expect_names("classes", class_names(*unit_));
    stimulus_ = &unit_->stimulus(parameters_.bits);
    response_ = &unit_->response(parameters_.bits);
  }

  bool next(VectorSet& batch, std::size_t max_cases) override {
    batch.clear();
    if (finished_) return false;
    while (!finished_ && batch.size() < max_cases) {
      const auto tag = number<std::uint8_t>("tag");
      if (tag == kEnd) {
        finished_ = true;
      } else if (tag == kCase) {
        read_case(batch);
      } else {
        fail(fmt::format("tag {:02X}, want 'C' or 'E'", tag));
      }
    }
    checks_ += batch.response_count() * response_->leaves.size();
    if (finished_) read_end();
    return !batch.empty();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw golden::InputError(fmt::format("{}:offset {}", name_, field_at_), what);
  }

  std::string_view take(std::size_t size, const char* what) {
    field_at_ = at_;
    if (bytes_.size() - at_ < size) fail(fmt::format("the file ends in '{}'", what));
    at_ += size;
    return bytes_.substr(field_at_, size);
  }

  template <class T>
  T number(const char* what) {
    T value{};
    std::memcpy(&value, take(sizeof value, what).data(), sizeof value);
    return value;
  }

  std::string_view text(const char* what) {
    const auto size = number<std::uint32_t>(what);
    return take(size, what);
  }

  void read_case(VectorSet& batch) {
    const auto id = number<std::uint64_t>("id");
    if (cases_ > 0 && id == last_id_) fail(fmt::format("duplicate id {}", id));
    if (cases_ > 0 && id < last_id_) fail(fmt::format("id {} comes after {}: ids must rise", id, last_id_));
    const auto case_class = number<std::uint16_t>("class");
    if (case_class >= unit_->classes.size()) fail(fmt::format("unknown class {} of {}", case_class, unit_->name));
    const std::size_t stimuli = number<std::uint32_t>("stimuli");
    if (stimuli == 0 || (!unit_->stateful && stimuli != 1)) fail(fmt::format("{} stimuli in a case", stimuli));
    const std::size_t responses = number<std::uint32_t>("responses");
    if (!unit_->stateful && responses != 1) fail(fmt::format("{} responses in a case, want 1", responses));
    batch.begin_case(id, case_class);
    last_id_ = id;
    ++cases_;
    for (std::size_t i = 0; i < stimuli; ++i) read_payload(*stimulus_, batch.add_stimulus(), "stimulus");
    for (std::size_t i = 0; i < responses; ++i) {
      const auto slot = batch.add_response();
      *slot.latency = number<std::uint32_t>("latency");
      read_payload(*response_, slot.response, "response");
    }
  }

  void read_payload(const PayloadCodec& codec, void* payload, const char* what) {
    const std::string_view packed = take(codec.packed_bytes(), what);
    if (!codec.unpack(reinterpret_cast<const std::uint8_t*>(packed.data()), payload)) fail("a padding bit is set");
  }

  void read_end() {
    const auto expect_count = [this](const char* name, std::uint64_t counted) {
      const auto said = number<std::uint64_t>(name);
      if (said != counted) fail(fmt::format("the trailer says {} {}, the file has {}", said, name, counted));
      if (said == 0) fail(fmt::format("no {}", name));
    };
    expect_count("cases", cases_);
    expect_count("checks", checks_);
    Crc32c crc;
    crc.update(bytes_.substr(0, at_));
    const auto said = number<std::uint32_t>("crc32c");
    if (said != crc.value()) fail(fmt::format("crc32c: found {:08X}, want {:08X}", said, crc.value()));
    field_at_ = at_;
    if (at_ != bytes_.size()) fail("bytes after the trailer");
  }

  const std::string name_;
  const std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t field_at_ = 0;
  const PayloadCodec* stimulus_ = nullptr;
  const PayloadCodec* response_ = nullptr;
  std::uint64_t cases_ = 0;
  std::uint64_t checks_ = 0;
  std::uint64_t last_id_ = 0;
  bool finished_ = false;
};

class Writer {
 public:
  explicit Writer(Output& output) : output_(output) {}

  template <class T>
  void number(T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    output_.append({bytes, sizeof value});
  }
  void text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    output_.append(text);
  }
  void payload(const PayloadCodec& codec, const void* payload) {
    const std::size_t start = output_.buffer().size();
    output_.buffer().resize(start + codec.packed_bytes());
    codec.pack(payload, reinterpret_cast<std::uint8_t*>(output_.buffer().data() + start));
  }

 private:
  Output& output_;
};

}  // namespace

void write_binary(const VectorSet& set, Output& output) {
  Writer write(output);
  output.append(kBinaryMagic);
  write.number(kVersion);
  write.number(static_cast<std::uint16_t>(set.parameters().bits));
  write.number(static_cast<std::uint16_t>(set.parameters().treelet));
  write.number(set.seed());
  write.text(set.unit().name);
  write.text(set.unit().field_names(set.parameters().bits));
  write.text(class_names(set.unit()));
  const PayloadCodec& stimulus = set.stimulus_codec();
  const PayloadCodec& response = set.response_codec();
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto stimuli = set.stimulus_range(i);
    const auto responses = set.response_range(i);
    write.number(kCase);
    write.number(set.head(i).id);
    write.number(set.head(i).case_class);
    write.number(static_cast<std::uint32_t>(stimuli.size));
    write.number(static_cast<std::uint32_t>(responses.size));
    for (std::size_t s = 0; s < stimuli.size; ++s) write.payload(stimulus, set.stimulus_at(stimuli.begin + s));
    for (std::size_t r = 0; r < responses.size; ++r) {
      write.number(set.latency_at(responses.begin + r));
      write.payload(response, set.response_at(responses.begin + r));
    }
    output.flush_when_large();
  }
  const Counts counts = set.counts();
  write.number(kEnd);
  write.number(counts.cases);
  write.number(counts.checks);
  write.number(output.crc());
}

std::unique_ptr<SetReader> read_binary(std::string_view bytes, const std::string& name) {
  return std::make_unique<BinaryReader>(bytes, name);
}

}  // namespace cbvh::vectors
