// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>

#include "golden/tree/node_pair_format.h"
#include "vectors/faces/pair.h"
#include "vectors/generate/node_writer_steps.h"
#include "vectors/unit.h"

namespace cbvh::vectors {

/// Combines writes of node pairs into lines, and answers reads of what it holds. An episode is one tree or two.
template <int N>
struct NodeWriter {
  using Stimulus = NodeWriterStep<N>;
  using Response = NodeWriterEvent<N>;
  using Kind = typename Response::Kind;
  static constexpr std::string_view kName = "node_writer";
  static constexpr std::string_view kSummary = "packs node pairs, combines their writes into lines (4 held)";
  static constexpr std::string_view kLatencyText = "one request a cycle";
  static constexpr bool kStateful = true;
  static constexpr bool kTreelet = false;
  static constexpr const auto& kClasses = kNodeWriterClasses;

  static std::vector<Stimulus> generate(std::size_t case_class, Random& random, const Parameters&) {
    std::vector<Stimulus> steps;
    for (const PlainWriterStep& plain : make_writer_steps(case_class, random)) {
      Stimulus step;
      if (plain.kind == PlainWriterStep::Kind::end || plain.kind == PlainWriterStep::Kind::refused_end) {
        step.ends = rtl::UInt<1>(1);
        step.report.last_index = rtl::Pointer::of_raw(random.next());
        step.report.repairs = rtl::UInt<32>(random.below(100));
        if (plain.kind == PlainWriterStep::Kind::refused_end) step.report.status = rtl::StatusBits(1 + random.below(7));
      } else {
        step.request.write = rtl::UInt<1>(plain.kind == PlainWriterStep::Kind::write);
        step.request.line = rtl::UInt<rtl::kLineBits>(plain.line);
        step.request.mask = rtl::UInt<rtl::kPairsPerLine>(plain.mask);
        for (std::size_t slot = 0; slot < 4; ++slot) {
          if (step.request.write && (plain.mask >> slot & 1U) != 0) step.request.pairs[slot] = random_pair(random);
        }
      }
      steps.push_back(step);
    }
    return steps;
  }

  static std::vector<Expected<Response>> respond(std::span<const Stimulus> steps, const Parameters&) {
    Face face;
    for (const Stimulus& step : steps) {
      if (step.ends) {
        face.end_tree(step.report);
      } else if (step.request.write) {
        face.write(step.request);
      } else {
        face.read(step.request);
      }
    }
    if (steps.empty() || !steps.back().ends) throw golden::InputError("ends", "the last tree has no report");
    return face.events();
  }

 private:
  static rtl::NodePair<N> random_pair(Random& random) {
    rtl::NodePair<N> pair;
    rtl::visit_leaves(pair, [&](auto& leaf) { leaf = std::remove_reference_t<decltype(leaf)>::of_raw(random.next()); });
    return pair;
  }

  using Pairs = std::map<std::size_t, rtl::NodePair<N>>;  ///< by slot

  class Face {
   public:
    void write(const rtl::MemoryRequest<N>& request) {
      Pairs pairs;
      for (std::size_t slot = 0; slot < 4; ++slot) {
        if ((request.mask.raw() >> slot & 1U) != 0)
          pairs[slot] = newest_[{request.line.raw(), slot}] = request.pairs[slot];
      }
      if (pairs.empty()) return;
      const std::uint64_t line = request.line.raw();
      auto& place = held_[line % kWriterLines];
      if (place && place->first != line) {
        if (pairs.size() == 4) return send(line, pairs);  // nothing to combine
        send(place->first, place->second);
        place.reset();
      }
      if (!place) place = {line, {}};
      for (const auto& [slot, pair] : pairs) place->second[slot] = pair;
      if (place->second.size() < 4) return;
      send(line, place->second);
      place.reset();
    }

    void read(const rtl::MemoryRequest<N>& request) {
      const std::uint64_t line = request.line.raw();
      const auto slot = static_cast<std::size_t>(std::countr_zero(request.mask.raw()));
      if (request.mask.raw() != 1ULL << slot) throw golden::InputError("mask", "a read wants one pair");
      const auto pair = newest_.find({line, slot});
      if (pair == newest_.end() && void_) throw golden::InputError("line", "what a refused tree left is void");
      answers_.push_back(event(Kind::answer));
      if (pair != newest_.end()) answers_.back().response.pair = pair->second;
      const auto& place = held_[line % kWriterLines];
      if (place && place->first == line && place->second.contains(slot)) return;
      accesses_.push_back(event(Kind::access));
      accesses_.back().response.access.line = rtl::LineAddress(kWriterFirstLine + line);
      last_write_.reset();  // out before the read, which is acknowledgement enough
    }

    void end_tree(const rtl::StreamReport& report) {
      const bool refused = report.status.raw() != 0;
      for (auto& [place, line] : held_) {  // in order of the places
        if (line && !refused) send(line->first, line->second);
        line.reset();
      }
      if (last_write_ && refused) accesses_.erase(accesses_.begin() + static_cast<std::ptrdiff_t>(*last_write_));
      if (last_write_ && !refused) accesses_[*last_write_].response.access.acknowledge = rtl::UInt<1>(1);
      last_write_.reset();
      if (refused) newest_.clear();
      void_ = void_ || refused;
      reports_.push_back(event(Kind::report));
      reports_.back().response.report = report;
    }

    std::vector<Expected<Response>> events() const {
      std::vector<Expected<Response>> all = answers_;
      all.insert(all.end(), accesses_.begin(), accesses_.end());
      all.insert(all.end(), reports_.begin(), reports_.end());
      return all;
    }

   private:
    static Expected<Response> event(Kind kind) {
      Response response;
      response.kind = rtl::UInt<2>(static_cast<std::uint64_t>(kind));
      return {response, kLatencyNotStated};
    }
    void send(std::uint64_t line, const Pairs& pairs) {
      accesses_.push_back(event(Kind::access));
      rtl::LineRequest& access = accesses_.back().response.access;
      access.write = rtl::UInt<1>(1);
      access.line = rtl::LineAddress(kWriterFirstLine + line);
      std::uint64_t mask = 0;
      for (const auto& [slot, pair] : pairs) {
        const golden::NodePairWords words = golden::pack_node_pair(from_wires(pair));
        for (std::size_t i = 0; i < 4; ++i) {
          access.words[slot * 4 + i] = rtl::UInt<32>::of_raw(words[i / 2] >> (i % 2 * 32));
          mask |= 1ULL << (slot * 4 + i);
        }
      }
      access.mask = rtl::UInt<16>(mask);
      last_write_ = accesses_.size() - 1;
    }

    std::map<std::pair<std::uint64_t, std::size_t>, rtl::NodePair<N>> newest_;  ///< by line and slot
    std::map<std::uint64_t, std::optional<std::pair<std::uint64_t, Pairs>>> held_;
    std::vector<Expected<Response>> answers_;
    std::vector<Expected<Response>> accesses_;
    std::vector<Expected<Response>> reports_;
    std::optional<std::size_t> last_write_;  ///< waits to go
    bool void_ = false;                      ///< memory holds what a refused tree left
  };
};

}  // namespace cbvh::vectors
