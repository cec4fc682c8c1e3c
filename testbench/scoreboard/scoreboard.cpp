// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/scoreboard/scoreboard.h"

#include <cassert>
#include <cstring>

namespace cbvh::testbench {

namespace {

using vectors::VectorSet;

std::string text_of(const vectors::PayloadCodec& codec, const void* payload) {
  std::string text(codec.text_length, ' ');
  codec.print_text(payload, text.data());
  return text;
}

/// Compares the cases of one set.
class Comparison {
 public:
  Comparison(const VectorSet& wanted, const Responses& found, const CompareOptions& options, SetReport& report)
      : wanted_(wanted), found_(found), options_(options), report_(report), codec_(wanted.response_codec()) {}

  void compare_case(std::size_t index) {
    index_ = index;
    const VectorSet::Range wanted = wanted_.response_range(index);
    const Responses::Case found = found_.at_case(index);
    for (std::size_t i = 0; i < wanted.size; ++i) {
      const std::uint32_t latency = wanted_.latency_at(wanted.begin + i);
      const bool stated = latency != vectors::kLatencyNotStated;
      report_.checks += codec_.leaves.size() + (stated ? 1 : 0);
      if (i >= found.size) {
        report_.failures += codec_.leaves.size() + (stated ? 1 : 0);
        note(i, found.hung ? "hang" : "missing response", "nothing",
             text_of(codec_, wanted_.response_at(wanted.begin + i)));
        continue;
      }
      compare_fields(i, found_.response(found.begin + i), wanted_.response_at(wanted.begin + i));
      if (stated && !in_time(found_.latency(found.begin + i), latency)) {
        fail(i, "latency", std::to_string(found_.latency(found.begin + i)),
             (options_.stalled ? "at least " : "") + std::to_string(latency));
      }
    }
    for (std::size_t i = wanted.size; i < found.size; ++i) {
      ++report_.checks;
      fail(i, "surplus response", text_of(codec_, found_.response(found.begin + i)), "nothing");
    }
    if (found.hung && found.size >= wanted.size) {  // all responses came, but it never took all stimuli
      ++report_.checks;
      fail(wanted.size, "hang", "stimuli that were never taken", "all taken");
    }
  }

 private:
  bool in_time(std::uint32_t found, std::uint32_t stated) const {
    return options_.stalled ? found >= stated : found == stated;
  }

  void compare_fields(std::size_t response, const void* found, const void* wanted) {
    if (std::memcmp(found, wanted, codec_.object_size) == 0) return;
    const std::string found_text = text_of(codec_, found);
    const std::string wanted_text = text_of(codec_, wanted);
    std::size_t begin = 0;
    for (const auto& leaf : codec_.leaves) {  // padding may differ: the leaves decide
      const auto digits = static_cast<std::size_t>(vectors::hex_digits(leaf.width));
      const std::string found_leaf = found_text.substr(begin, digits);
      const std::string wanted_leaf = wanted_text.substr(begin, digits);
      if (found_leaf != wanted_leaf) fail(response, leaf.name, found_leaf, wanted_leaf);
      begin += digits + 1;
    }
  }

  void fail(std::size_t response, const std::string& field, const std::string& found, const std::string& wanted) {
    ++report_.failures;
    note(response, field, found, wanted);
  }

  void note(std::size_t response, const std::string& field, const std::string& found, const std::string& wanted) {
    if (report_.mismatches.size() >= kMismatchesKept) return;
    const std::uint64_t id = wanted_.head(index_).id;
    report_.mismatches.push_back({report_.unit, report_.set, id, std::string(wanted_.class_name(index_)), response,
                                  field, found, wanted, options_.rerun(id), ""});
  }

  const VectorSet& wanted_;
  const Responses& found_;
  const CompareOptions& options_;
  SetReport& report_;
  const vectors::PayloadCodec& codec_;
  std::size_t index_ = 0;
};

}  // namespace

void compare(const VectorSet& wanted, const Responses& found, const CompareOptions& options, SetReport& report) {
  assert(found.cases() == wanted.size());
  Comparison comparison(wanted, found, options, report);
  for (std::size_t index = 0; index < wanted.size(); ++index) {
    comparison.compare_case(index);
    ++report.classes[std::string(wanted.class_name(index))];
  }
  report.cases += wanted.size();
  report.cycles += found.cycles;
}

}  // namespace cbvh::testbench
