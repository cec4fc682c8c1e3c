// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/generate/node_writer_steps.h"

namespace cbvh::vectors {
namespace {

enum Class : std::size_t {
  kSingle,
  kWhole,
  kPairByPair,
  kBackwards,
  kEviction,
  kReadHeld,
  kReadMemory,
  kReadBeside,
  kWalk,
  kNothing,
  kRefused
};

class Writer {
 public:
  void write(std::uint64_t line, std::uint64_t mask) { add(PlainWriterStep::Kind::write, line, mask); }
  void write_pair(std::uint64_t index) { write(index / 4, 1ULL << index % 4); }
  void read_pair(std::uint64_t index) { add(PlainWriterStep::Kind::read, index / 4, 1ULL << index % 4); }
  void repair(std::uint64_t index) {
    read_pair(index);
    write_pair(index);
  }
  void end(bool refused = false) {
    add(refused ? PlainWriterStep::Kind::refused_end : PlainWriterStep::Kind::end, 0, 0);
  }

  std::vector<PlainWriterStep> steps;

 private:
  void add(PlainWriterStep::Kind kind, std::uint64_t line, std::uint64_t mask) {
    steps.push_back({kind, static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(mask)});
  }
};

/// Mostly onwards, with repairs of what was written.
void walk(Writer& writer, int count, Random& random) {
  std::vector<std::uint64_t> written;
  for (int i = 0; i < count; ++i) {
    if (!written.empty() && random.one_in(3)) {
      writer.repair(written[random.below(written.size())]);
    } else {
      const std::uint64_t line = static_cast<std::uint64_t>(i) / 4 + random.below(kWriterLines + 2);
      const std::uint64_t mask = random.one_in(4) ? random.below(16) : 1ULL << random.below(4);
      for (std::uint64_t slot = 0; slot < 4; ++slot) {
        if ((mask >> slot & 1U) != 0) written.push_back(line * 4 + slot);
      }
      writer.write(line, mask);
    }
  }
}

}  // namespace

std::vector<PlainWriterStep> make_writer_steps(std::size_t case_class, Random& random) {
  Writer writer;
  const std::uint64_t first = random.below(50) * 4;
  const auto count = static_cast<std::uint64_t>(random.between(2, 9));
  switch (case_class) {
    case kSingle:
      writer.write_pair(random.below(8));
      break;
    case kWhole:
      for (std::uint64_t i = 0; i < count / 2; ++i) writer.write(first + i, 15);
      break;
    case kPairByPair:
      for (std::uint64_t i = 0; i < count; ++i) writer.write_pair(i);
      break;
    case kBackwards:
      for (std::uint64_t i = count; i-- > 0;) writer.write_pair(first + i);
      break;
    case kEviction:  // the same place for all
      for (std::uint64_t i = 0; i < count; ++i) {
        const auto mask = 1 + random.below(14);
        writer.write(first + random.below(3) * kWriterLines, mask);
      }
      break;
    case kReadHeld:
      for (std::uint64_t i = 0; i < 4; ++i) {
        writer.write_pair(first + i);
        if (i < 3) writer.repair(first + random.below(i + 1));
      }
      break;
    case kReadMemory:  // complete, gone, and wanted again
      writer.write(first, 15);
      for (std::uint64_t i = 0; i < count / 2; ++i) writer.repair(first * 4 + random.below(4));
      break;
    case kReadBeside:  // a repaired pair is held, another of its line is not
      writer.write(first, 15);
      writer.repair(first * 4 + 1);
      writer.repair(first * 4 + 2 + random.below(2));
      writer.write(first + kWriterLines, 1);
      writer.repair(first * 4);
      break;
    case kWalk:
      walk(writer, random.between(8, 24), random);
      break;
    case kNothing:
      if (random.flip()) writer.write(first, 0);
      break;
    default:  // kRefused, then a tree
      walk(writer, random.between(1, 6), random);
      writer.end(true);
      writer.write_pair(random.below(8));
  }
  writer.end();
  return writer.steps;
}

}  // namespace cbvh::vectors
