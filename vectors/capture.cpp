// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "vectors/capture.h"

#include <algorithm>

#include "golden/build/lbvh.h"
#include "golden/quantize/quantize.h"
#include "golden/scene/load.h"
#include "vectors/convert.h"
#include "vectors/faces/collector.h"
#include "vectors/generate/backtrack_steps.h"
#include "vectors/generate/decode_jobs.h"
#include "vectors/generate/float_trees.h"
#include "vectors/generate/pair_tests.h"
#include "vectors/ray_convert.h"
#include "vectors/registry.h"
#include "vectors/units/backtrack_unit.h"

namespace cbvh::vectors {
namespace {

/// Stimuli on their way into a set. A first pass counts them; the second keeps some, evenly.
class Collection {
 public:
  Collection(VectorSet& set, std::uint64_t most) : set_(set), most_(most) {}

  template <class Capture>
  void run(Capture&& capture) {
    capture(*this);
    total_ = seen_;
    seen_ = 0;
    most_ = std::min(most_, total_);
    keeping_ = true;
    capture(*this);
  }

  /// Whether the next case is to be given to add(); called once a case.
  bool wants_next() {
    const std::uint64_t index = seen_++;
    return keeping_ && share(index + 1) > share(index);
  }
  template <class Stimulus>
  void add(std::span<const Stimulus> stimuli) {
    set_.begin_case(set_.size(), static_cast<std::uint16_t>(set_.unit().generated_classes()));
    for (const Stimulus& stimulus : stimuli) *static_cast<Stimulus*>(set_.add_stimulus()) = stimulus;
    set_.add_golden_responses();
  }
  template <class Stimulus>
  bool takes() const {
    return &set_.stimulus_codec() == &payload_codec<Stimulus>();
  }
  template <class Stimulus>
  void offer(const Stimulus& stimulus) {
    if (wants_next()) add(std::span<const Stimulus>(&stimulus, 1));
  }

 private:
  std::uint64_t share(std::uint64_t index) const {
    return static_cast<std::uint64_t>(static_cast<double>(index) * static_cast<double>(most_) /
                                      static_cast<double>(total_));
  }

  VectorSet& set_;
  std::uint64_t most_;
  std::uint64_t total_ = 0;
  std::uint64_t seen_ = 0;
  bool keeping_ = false;
};

using Stream = std::vector<rtl::StreamJob>;

/// The number of pairs of each subtree.
std::vector<std::uint32_t> subtree_sizes(const golden::FloatTree& tree) {
  std::vector<std::uint32_t> sizes;
  for (const golden::FloatPair& pair : tree.pairs) {
    std::uint32_t size = 1;
    for (std::size_t c = 0; c < 2; ++c) size += pair.leaf[c] ? 0 : sizes[pair.pointer[c]];
    sizes.push_back(size);
  }
  return sizes;
}

/// Gives each largest subtree of at most `most` pairs as a stream of its own. Subtrees are contiguous in emission
/// order.
template <class Take>
void for_each_subtree(const golden::FloatTree& tree, const Stream& stream, std::uint32_t most, Take&& take) {
  const std::vector<std::uint32_t> sizes = subtree_sizes(tree);
  std::vector<std::uint32_t> pending = {static_cast<std::uint32_t>(stream.size() - 1)};
  while (!pending.empty()) {
    const std::uint32_t root = pending.back();
    pending.pop_back();
    if (sizes[root] > most) {
      for (const std::size_t c : {std::size_t{1}, std::size_t{0}}) {
        if (!tree.pairs[root].leaf[c]) pending.push_back(tree.pairs[root].pointer[c]);
      }
      continue;
    }
    const std::uint32_t begin = root + 1 - sizes[root];
    take([&] {
      Stream part;
      for (std::uint32_t i = begin; i <= root; ++i) {
        rtl::StreamJob& job = part.emplace_back(stream[i]);
        job.root = rtl::UInt<1>(i == root);
        for (std::size_t c = 0; c < 2; ++c) {
          if (!job.pair.leaf[c]) job.pair.pointer[c] = rtl::Pointer(job.pair.pointer[c].raw() - begin);
        }
      }
      return part;
    });
  }
}

void offer_axes(const rtl::PairJob& job, const PairAnswer& answer, Collection& collection) {
  for (const rtl::FloatBox& box : job.pair.box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      collection.offer(
          rtl::AxisJob{box.lower[axis], box.upper[axis], rtl::Scale(answer.context[axis].scale), job.registers});
    }
  }
}

void offer_estimates(const rtl::PairJob& job, Collection& collection) {
  if (job.given_context) return;
  const golden::Box box = union_box(job.pair);
  for (int axis = 0; axis < 3; ++axis) {
    collection.offer(
        rtl::EstimateJob{rtl::Float32::of(box.lower[axis]), rtl::Float32::of(box.upper[axis]), job.registers});
  }
}

void offer_children(const rtl::PairJob& job, const PairAnswer& answer, int bits, Collection& collection) {
  const golden::CompressedPair pair = stored_pair(job.pair, answer, job.registers, bits);
  for (const golden::CompressedChild& child : pair.child) {
    with_bits(bits, [&](auto n) {
      collection.offer(to_wires<decltype(n)::value>({child, answer.context, job.registers}));
    });
  }
}

/// Case `number` decides the ray.
void offer_ray(const rtl::PairJob& job, const PairAnswer& answer, std::uint64_t number, int bits,
               Collection& collection) {
  Random random(mix(0, number));
  const golden::CompressedPair pair = stored_pair(job.pair, answer, job.registers, bits);
  const PlainPairTest test = pair_test_at(pair, answer.context, union_box(job.pair), job.registers, random, bits);
  with_bits(bits, [&](auto n) { collection.offer(to_wires<decltype(n)::value>(test)); });
}

/// What the stream compressor does to the stack of contexts.
std::vector<rtl::StackOperation> stack_operations_of(const Stream& stream, int bits) {
  std::vector<rtl::StackOperation> operations;
  for (const rtl::StreamJob& job : stream) {
    const std::uint64_t inner = std::uint64_t{!job.pair.leaf[0]} + std::uint64_t{!job.pair.leaf[1]};
    const PairAnswer answer = compress_pair(job.pair, std::nullopt, job.registers, bits);
    operations.push_back({rtl::UInt<2>(inner), rtl::UInt<1>(1), to_wires(answer.context)});
  }
  return operations;
}

void capture_backtracking(const golden::FloatTree& tree, const Stream& stream, const CaptureOptions& options, int bits,
                          Collection& collection) {
  for_each_subtree(tree, stream, options.episode_pairs, [&](auto&& part) {
    const auto steps = backtrack_steps_of(part(), options.treelet, bits);
    const bool repairs = std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.repair; });
    if (!repairs || !collection.wants_next()) return;
    with_bits(bits, [&](auto n) {
      std::vector<BacktrackStep<decltype(n)::value>> wires;
      wires.reserve(steps.size());
      for (const PlainBacktrackStep& step : steps) wires.push_back(to_wires<decltype(n)::value>(step));
      collection.add(std::span<const BacktrackStep<decltype(n)::value>>(wires));
    });
  });
}

void capture(std::string_view unit, const golden::FloatTree& tree, const Stream& stream, const CaptureOptions& options,
             int bits, Collection& collection) {
  const auto watch = [&](const CompressionObserver& observer) { collect(stream, options.treelet, bits, observer); };
  if (unit == "axis_compressor") {
    watch([&](const rtl::PairJob& job, const PairAnswer& answer) { offer_axes(job, answer, collection); });
  } else if (unit == "scale_estimator") {
    watch([&](const rtl::PairJob& job, const PairAnswer&) { offer_estimates(job, collection); });
  } else if (unit.starts_with("node_pair_compressor")) {
    watch([&](const rtl::PairJob& job, const PairAnswer&) { collection.offer(job); });
  } else if (unit == "box_decoder") {
    watch([&](const rtl::PairJob& job, const PairAnswer& answer) { offer_children(job, answer, bits, collection); });
  } else if (unit == "pair_intersector") {
    std::uint64_t number = 0;
    watch(
        [&](const rtl::PairJob& job, const PairAnswer& answer) { offer_ray(job, answer, number++, bits, collection); });
  } else if (unit == "backtrack_unit") {
    capture_backtracking(tree, stream, options, bits, collection);
  } else if (unit == "context_stack" || collection.takes<rtl::StreamJob>()) {
    for_each_subtree(tree, stream, options.episode_pairs, [&](auto&& part) {
      if (!collection.wants_next()) return;
      const Stream jobs = part();
      if (unit == "context_stack") {
        collection.add(std::span<const rtl::StackOperation>(stack_operations_of(jobs, bits)));
      } else {
        collection.add(std::span<const rtl::StreamJob>(jobs));
      }
    });
  }
}

}  // namespace

std::unique_ptr<VectorSet> capture_set(std::string_view unit, const Parameters& parameters,
                                       const golden::FloatTree& tree, const CaptureOptions& options) {
  auto set = make_set(find_unit(unit), parameters, 0);
  const int limit = golden::exactness_limit(tree.largest_magnitude);
  const rtl::SceneRegisters registers =
      scene_registers({parameters.bits, options.min_scale.value_or(limit), options.scale_rule}, options.code);
  if (registers.min_scale.value() < limit) {
    throw golden::InputError("min-scale", fmt::format("found {}, want at least {} (the scene's exactness limit)",
                                                      registers.min_scale.value(), limit));
  }
  const Stream stream = stream_of(tree, registers);
  Collection collection(*set, options.cases);
  if (!stream.empty()) {
    collection.run([&](Collection& into) { capture(unit, tree, stream, options, parameters.bits, into); });
  }
  if (set->empty()) throw golden::InputError("unit", fmt::format("{} meets nothing in this scene", unit));
  return set;
}

std::unique_ptr<VectorSet> capture_set(std::string_view unit, const Parameters& parameters, const std::string& scene,
                                       const CaptureOptions& options) {
  return capture_set(unit, parameters, golden::build_lbvh(golden::load_scene(scene)), options);
}

}  // namespace cbvh::vectors
