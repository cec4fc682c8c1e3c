// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report/merge.h"

#include <unordered_map>

#include "golden/input_error.h"

namespace cbvh::testbench {

namespace {

using golden::InputError;

template <class T>
void want_same(const std::string& place, const std::string& field, const T& found, const T& wanted) {
  if (found == wanted) return;
  throw InputError(place, fmt::format("{}: found '{}', want '{}' as in the first report", field, found, wanted));
}

std::string name_of(const SetReport& set) {
  return fmt::format("unit {}, set {}, backend {}, mode {}", set.unit, set.set, set.backend, set.mode);
}

/// A set while its shards are put together.
struct Union {
  SetReport set;
  std::vector<std::string> shard_places;  ///< of each shard seen; empty: not seen
};

class Merger {
 public:
  void add(const NamedReport& part) {
    const Shard& shard = part.report.shard;
    for (const SetReport& set : part.report.sets) {
      const auto [found, fresh] = index_.emplace(set.key(), unions_.size());
      if (fresh) unions_.push_back({set, std::vector<std::string>(shard.count)});
      Union& all = unions_[found->second];
      want_same(part.place, name_of(set) + ": shard count", shard.count,
                static_cast<std::uint64_t>(all.shard_places.size()));
      want_same(part.place, name_of(set) + ": total_cases", set.total_cases, all.set.total_cases);
      std::string& place = all.shard_places[shard.index];
      if (!place.empty()) {
        throw InputError(part.place,
                         fmt::format("{}: shard {} is already in {}", name_of(set), to_string(shard), place));
      }
      place = part.place;
      if (!fresh) accumulate(all.set, set);
    }
  }

  std::vector<SetReport> sets() const {
    std::vector<SetReport> result;
    for (const auto& [set, places] : unions_) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].empty())
          throw InputError("merge", fmt::format("{}: shard {}/{} is missing", name_of(set), i, places.size()));
      }
      if (set.cases != set.total_cases) {
        throw InputError(
            "merge", fmt::format("{}: the shards have {} cases, want {}", name_of(set), set.cases, set.total_cases));
      }
      result.push_back(set);
    }
    return result;
  }

 private:
  std::vector<Union> unions_;  ///< in the order of the first report
  std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace

Report merge(const std::vector<NamedReport>& parts) {
  if (parts.empty()) throw InputError("merge", "no reports");
  const Report& first = parts[0].report;
  Report whole{first.command, first.suite, first.seed, {}, first.bins_must_be_hit, {}, {}};
  Merger merger;
  for (const auto& [place, report] : parts) {
    want_same(place, "command", report.command, first.command);
    want_same(place, "suite", report.suite, first.suite);
    want_same(place, "seed", report.seed, first.seed);
    whole.bins_must_be_hit = whole.bins_must_be_hit && report.bins_must_be_hit;
    merger.add({place, report});
    for (const auto& [corner, hits] : report.corners) whole.corners[corner] += hits;
  }
  whole.sets = merger.sets();
  return whole;
}

}  // namespace cbvh::testbench
