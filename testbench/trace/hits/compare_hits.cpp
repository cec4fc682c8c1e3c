// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/hits/compare_hits.h"

#include <fmt/format.h>

#include <functional>
#include <mutex>

#include "golden/threads/parallel_for.h"
#include "golden/trace/compressed_view.h"
#include "testbench/trace/hits/recorded_rays.h"

namespace cbvh::testbench {

namespace {

constexpr std::uint64_t kChunk = 4096;
constexpr std::size_t kMostMistakes = 10;

std::string in_words(const golden::Ray& ray) {
  return fmt::format("ray {},{},{},{},{},{},{},{}", ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                     ray.direction.y, ray.direction.z, ray.t_min, ray.t_max);
}

std::string in_words(std::uint32_t primitive, double t) {
  return primitive == golden::Hit::kNone ? "nothing" : fmt::format("triangle {} at {:.17g}", primitive, t);
}

/// Compares rays with Embree, one a thread.
class HitsComparison {
 public:
  HitsComparison(const golden::Mesh& mesh, const TreePair& trees, const EmbreeScene& embree)
      : mesh_(mesh),
        embree_(embree),
        floats_(golden::FloatTreeView(trees.floats), mesh),
        compressed_(golden::CompressedTreeView(trees.compressed), mesh) {}

  void compare(const golden::Ray& ray, HitsResult& result) {
    const golden::Hit ours = floats_.trace(ray, golden::Stop::closest);
    const golden::Hit other = compressed_.trace(ray, golden::Stop::closest);
    const EmbreeHit theirs = embree_.trace(ray);
    const HitRelation relation = compare_hit(mesh_, ray, ours, theirs);
    ++result.rays;
    ++result.relations[static_cast<std::size_t>(relation)];
    const bool same_trees = ours == other;
    result.tree_differences += same_trees ? 0 : 1;
    if ((same_trees && !is_mistake(relation)) || result.mistakes.size() >= kMostMistakes) return;
    result.mistakes.push_back(fmt::format("{}: {}: float tree {}, compressed tree {}, Embree {}", in_words(ray),
                                          kHitRelationNames[static_cast<std::size_t>(relation)],
                                          in_words(ours.primitive, ours.t), in_words(other.primitive, other.t),
                                          in_words(theirs.primitive, static_cast<double>(theirs.t))));
  }

 private:
  const golden::Mesh& mesh_;
  const EmbreeScene& embree_;
  golden::Tracer<golden::FloatTreeView> floats_;
  golden::Tracer<golden::CompressedTreeView> compressed_;
};

void add(HitsResult& sum, const HitsResult& part) {
  sum.rays += part.rays;
  for (std::size_t i = 0; i < kHitRelations; ++i) sum.relations[i] += part.relations[i];
  sum.tree_differences += part.tree_differences;
  for (const std::string& mistake : part.mistakes) {
    if (sum.mistakes.size() < kMostMistakes) sum.mistakes.push_back(mistake);
  }
}

}  // namespace

std::uint64_t HitsResult::wrong() const {
  std::uint64_t sum = tree_differences;
  for (std::size_t i = 0; i < kHitRelations; ++i) {
    if (is_mistake(static_cast<HitRelation>(i))) sum += relations[i];
  }
  return sum;
}

std::vector<HitsResult> compare_hits(const golden::Mesh& mesh, const TreePair& trees, const HitsJob& job) {
  const EmbreeScene embree(mesh, true);
  const golden::Box& box = trees.floats.scene;
  const golden::Camera camera = camera_of(job.picture, box);
  std::uint64_t total = job.picture.height;
  for (const std::uint64_t rays : job.rays) total += (rays + kChunk - 1) / kChunk;
  Progress progress("trace", total);
  std::vector<HitsResult> results;
  // Calls rays_of(i, compare) for each part of a set; it calls compare with each of the part's rays.
  const auto run = [&](const char* set, std::uint64_t parts, const auto& rays_of) {
    HitsResult sum;
    sum.set = set;
    std::mutex mutex;
    golden::parallel_for(parts, job.picture.threads, [&](std::size_t part) {
      HitsComparison comparison(mesh, trees, embree);
      HitsResult result;
      rays_of(part, [&](const golden::Ray& ray) { comparison.compare(ray, result); });
      progress.step();
      const std::lock_guard lock(mutex);
      add(sum, result);
    });
    results.push_back(std::move(sum));
  };
  run("picture", job.picture.height, [&](std::size_t row, const auto& compare) {
    std::vector<golden::Ray> rays;
    golden::PixelTracer tracer(RecordedRays(golden::FloatTreeView(trees.floats), mesh, rays), camera, job.picture.rays,
                               job.picture.samples);
    for (unsigned x = 0; x < job.picture.width; ++x)
      tracer.trace(x, static_cast<unsigned>(row), job.picture.width, job.picture.height);
    for (const golden::Ray& ray : rays) compare(ray);
  });
  for (std::size_t set = 0; set < job.rays.size(); ++set) {
    const std::uint64_t count = job.rays[set];
    run(kRaySetNames[set], (count + kChunk - 1) / kChunk, [&](std::size_t part, const auto& compare) {
      for (std::uint64_t i = part * kChunk; i < std::min(count, (part + 1) * kChunk); ++i)
        compare(made_ray(static_cast<RaySet>(set), mesh, box, job.seed, i));
    });
  }
  return results;
}

}  // namespace cbvh::testbench
