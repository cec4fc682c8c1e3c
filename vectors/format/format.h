// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "vectors/vector_set.h"

/// Sets as files: text, $readmemh hex and binary, which say the same (docs/formats.md). Everything that is wrong with a
/// file is a golden::InputError with its line and column, or its offset.
namespace cbvh::vectors {

enum class Format { text, hex, binary };

/// By extension: .vec, .hex, .bin.
Format format_of_path(const std::string& path);

/// The bytes of a file. The set has at least one check.
std::string serialize(const VectorSet& set, Format format);

/// Writes the format of the path's extension. The file appears complete or not at all.
void write_set(const VectorSet& set, const std::string& path);

/// The set in these bytes, of any format; `name` is for messages.
std::unique_ptr<VectorSet> parse_set(std::string_view bytes, const std::string& name);

/// The set in a file, of any format whatever its name.
std::unique_ptr<VectorSet> read_set(const std::string& path);

/// Reads a set in batches, so that it need not fit in memory.
class SetReader {
 public:
  virtual ~SetReader() = default;
  SetReader(const SetReader&) = delete;
  SetReader& operator=(const SetReader&) = delete;

  /// A set of the file's unit, parameters and seed, without cases: the batch to pass to next().
  std::unique_ptr<VectorSet> empty_set() const;
  /// Replaces the cases of `batch` by the next ones, at most `max_cases`. False when there were none left; only then is
  /// the file known to be complete and its CRC right.
  virtual bool next(VectorSet& batch, std::size_t max_cases) = 0;

 protected:
  SetReader() = default;
  const UnitDescription* unit_ = nullptr;
  Parameters parameters_;
  std::uint64_t seed_ = 0;
};

/// `bytes` must outlive the reader.
std::unique_ptr<SetReader> open_bytes(std::string_view bytes, const std::string& name);
std::unique_ptr<SetReader> open_set(const std::string& path);

}  // namespace cbvh::vectors
