// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/format/format.h"

#include <limits>

#include "vectors/format/binary.h"
#include "vectors/format/hex.h"
#include "vectors/format/input_file.h"
#include "vectors/format/output.h"
#include "vectors/format/text.h"
#include "vectors/registry.h"

namespace cbvh::vectors {
namespace {

void write(const VectorSet& set, Format format, Output& output, const std::string& name) {
  if (set.response_count() == 0) throw golden::InputError(name, "a set without checks is not written");
  switch (format) {
    case Format::text:
      write_text(set, output);
      break;
    case Format::hex:
      write_hex(set, output);
      break;
    case Format::binary:
      write_binary(set, output);
      break;
  }
  output.commit();
}

/// Reads from a file that it keeps open.
class FileReader final : public SetReader {
 public:
  explicit FileReader(const std::string& path) : file_(path), reader_(open_bytes(file_.bytes(), path)) {
    const auto set = reader_->empty_set();
    unit_ = &set->unit();
    parameters_ = set->parameters();
    seed_ = set->seed();
  }
  bool next(VectorSet& batch, std::size_t max_cases) override { return reader_->next(batch, max_cases); }

 private:
  InputFile file_;
  std::unique_ptr<SetReader> reader_;
};

std::unique_ptr<VectorSet> read_all(SetReader& reader) {
  auto set = reader.empty_set();
  reader.next(*set, std::numeric_limits<std::size_t>::max());
  return set;
}

}  // namespace

Format format_of_path(const std::string& path) {
  if (path.ends_with(".vec")) return Format::text;
  if (path.ends_with(".hex")) return Format::hex;
  if (path.ends_with(".bin")) return Format::binary;
  throw golden::InputError(path, "unknown extension, want .vec (text), .hex or .bin");
}

std::string serialize(const VectorSet& set, Format format) {
  std::string text;
  Output output(text);
  write(set, format, output, std::string(set.unit().name));
  return text;
}

void write_set(const VectorSet& set, const std::string& path) {
  const Format format = format_of_path(path);
  Output output = Output::to_file(path);
  write(set, format, output, path);
}

std::unique_ptr<VectorSet> SetReader::empty_set() const { return make_set(*unit_, parameters_, seed_); }

std::unique_ptr<SetReader> open_bytes(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with(kBinaryMagic)) return read_binary(bytes, name);
  if (bytes.starts_with("//")) return read_hex(bytes, name);
  if (bytes.starts_with("#")) return read_text(bytes, name);
  if (bytes.empty()) throw golden::InputError(name, "the file is empty");
  throw golden::InputError(
      name, "not a vector file: it starts with neither '# cbvh-vectors', '// cbvh-vectors' nor 'cbvh-vec'");
}

std::unique_ptr<SetReader> open_set(const std::string& path) { return std::make_unique<FileReader>(path); }

std::unique_ptr<VectorSet> parse_set(std::string_view bytes, const std::string& name) {
  return read_all(*open_bytes(bytes, name));
}

std::unique_ptr<VectorSet> read_set(const std::string& path) {
  const InputFile file(path);
  return read_all(*open_bytes(file.bytes(), path));
}

}  // namespace cbvh::vectors
