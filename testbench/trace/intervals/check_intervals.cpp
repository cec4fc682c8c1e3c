// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/trace/intervals/check_intervals.h"

#include <mutex>

#include "golden/threads/parallel_for.h"
#include "testbench/trace/intervals/interval_tracer.h"
#include "vectors/unit.h"

namespace cbvh::testbench {

namespace {

/// A tracer that others share: a pixel tracer keeps its own copy of what it is given.
template <class Traced>
class Shared {
 public:
  using Hit = golden::Hit;
  explicit Shared(Traced& traced) : traced_(&traced) {}
  const golden::Box& box() const { return traced_->box(); }
  Hit trace(const golden::Ray& ray, golden::Stop stop) { return traced_->trace(ray, stop); }
  const golden::TraceCounts& counts() const { return traced_->counts(); }
  auto surface(const golden::Ray& ray, const Hit& hit) const { return traced_->surface(ray, hit); }

 private:
  Traced* traced_;
};

template <int N>
void check(const golden::Mesh& mesh, const golden::CompressedTree& tree, const PictureJob& job,
           IntervalsResult& result) {
  const golden::Camera camera = camera_of(job, tree.scene);
  Progress progress("trace", job.height);
  std::mutex mutex;  // of the result
  golden::parallel_for(job.height, job.threads, [&](std::size_t row) {
    IntervalTracer<N> tracer(tree, mesh);
    golden::PixelTracer pixels{Shared{tracer}, camera, job.rays, job.samples};
    std::uint64_t rays = 0;
    for (unsigned x = 0; x < job.width; ++x) {
      const auto pixel = pixels.trace(x, static_cast<unsigned>(row), job.width, job.height);
      rays += pixel.primary.rays + pixel.secondary.rays;
    }
    progress.step();
    const std::lock_guard lock(mutex);
    result.rays += rays;
    result.box_tests += tracer.counts().box_tests;
    result.golden_box_tests += tracer.golden_counts().box_tests;
  });
}

}  // namespace

std::string ray_text(const golden::Ray& ray) {
  return fmt::format("ray {},{},{},{},{},{},{},{}", ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                     ray.direction.y, ray.direction.z, ray.t_min, ray.t_max);
}

std::string node_text(const TestedNode& node) {
  return node.pair == TestedNode::kNoPair ? "root" : fmt::format("child {} of pair {}", node.child, node.pair);
}

void check_planes(const golden::Ray& ray, const ExactBox& box, const std::array<rtl::PlaneDistances, 3>& planes,
                  const TestedNode& node) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float origin = ray.origin[static_cast<int>(axis)];
    const float direction = ray.direction[static_cast<int>(axis)];
    const float near = planes[axis].near.value();
    const float far = planes[axis].far.value();
    const double lower = box.lower[axis];
    const double upper = box.upper[axis];
    const auto wide_origin = static_cast<double>(origin);
    const bool encloses =
        direction == 0
            ? golden::at_or_before(near, lower, wide_origin, 1) && golden::at_or_before(-far, -upper, -wide_origin, 1)
            : golden::not_after_plane(near, direction < 0 ? upper : lower, origin, direction) &&
                  golden::not_before_plane(far, direction < 0 ? lower : upper, origin, direction);
    if (encloses) continue;
    throw IntervalViolation(
        fmt::format("{}, {}, {}: the unit's {} .. {} does not enclose the exact distances of the planes {} and {}",
                    ray_text(ray), node_text(node), "xyz"[axis], near, far, lower, upper));
  }
}

IntervalsResult check_intervals(const golden::Mesh& mesh, const golden::CompressedTree& tree, const PictureJob& job) {
  IntervalsResult result{mesh.name, tree.rules.bits, 0, 0, 0, {}};
  try {
    vectors::with_bits(tree.rules.bits, [&](auto n) { check<decltype(n)::value>(mesh, tree, job, result); });
  } catch (const IntervalViolation& violation) {
    result.failures.emplace_back(violation.what());
  }
  return result;
}

Table intervals_table(const IntervalsResult& result) {
  const double ratio = result.golden_box_tests == 0
                           ? 0
                           : static_cast<double>(result.box_tests) / static_cast<double>(result.golden_box_tests);
  return {"box_intervals",
          "The traversal unit's box tests",
          {{"scene", "scene"},
           {"bits", "N"},
           {"rays", "rays"},
           {"box_tests", "box tests, checked"},
           {"exact_ratio", "of exact ones", 4},
           {"violations", "violations"}},
          2,
          {{result.scene, result.bits, result.rays, result.box_tests, ratio, result.failures.size()}},
          {"checked: the unit's distances to all six planes enclose the exact ones, and the ray's hit is the golden's",
           "of exact ones: box tests over those of a traversal whose intervals are exact but for 2^-50"},
          true};
}

}  // namespace cbvh::testbench
