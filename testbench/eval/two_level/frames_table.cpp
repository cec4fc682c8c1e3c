// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "testbench/eval/two_level/table.h"

namespace cbvh::testbench {

namespace {

constexpr std::array<const char*, 5> kNotes{
    "trees: float ones, or compressed ones on both levels",
    "of the first: the median of each frame's ratio to the first top level of the same scene and kind of trees; "
    "longest and largest: of all frames",
    "paper: Bikker, part 6, 256 instances of the armadillo: half a millisecond to update the top level",
    "a ray: a primary ray, on both levels, medians of the frames' means; transforms: into the space of an instance, "
    "once "
    "for each reference reached",
    "pictures: each pixel's nearest instance, triangle and distance are those of the first top level over float trees, "
    "in every frame"};

/// What `value` is of each frame, in ascending order.
template <class Value>
std::vector<double> sorted(const FramesMeasure& measure, Value value) {
  std::vector<double> values;
  for (const FrameMeasure& frame : measure.frames) values.push_back(value(frame));
  std::sort(values.begin(), values.end());
  return values;
}

double median(const std::vector<double>& ascending) {
  const std::size_t middle = ascending.size() / 2;
  return ascending.size() % 2 == 1 ? ascending[middle] : (ascending[middle - 1] + ascending[middle]) / 2;
}

double build_ms(const FrameMeasure& frame) { return frame.build_seconds * 1000; }

double per_ray(std::uint64_t count, const FrameMeasure& frame) {
  return static_cast<double>(count) / static_cast<double>(frame.rays);
}

}  // namespace

Table frames_table(const std::vector<FramesMeasure>& measures) {
  Table table{"two_level_frames",
              "Top levels built anew every frame",
              {{"scene", "scene"},
               {"top", "top level"},
               {"trees", "trees"},
               {"frames", "frames"},
               {"references", "references, median"},
               {"build_ms", "build ms, median", 3},
               {"build_ms_max", "longest", 3},
               {"build_ratio", "of the first", 2},
               {"paper_build_ms", "paper", 1},
               {"sah", "SAH, median", 2},
               {"sah_max", "largest", 2},
               {"sah_ratio", "of the first", 3},
               {"box_tests", "box tests a ray", 1},
               {"triangle_tests", "triangle tests", 2},
               {"transforms", "transforms", 2},
               {"pictures", "pictures"}},
              3,
              {},
              {kNotes.begin(), kNotes.end()},
              true};
  for (const FramesMeasure& m : measures) {
    const FramesMeasure& first = *std::find_if(measures.begin(), measures.end(), [&](const FramesMeasure& other) {
      return other.scene == m.scene && other.trees == m.trees;
    });
    const std::vector<double> build = sorted(m, build_ms);
    const std::vector<double> sah = sorted(m, [](const FrameMeasure& f) { return f.sah; });
    const bool same =
        std::all_of(m.frames.begin(), m.frames.end(), [](const FrameMeasure& f) { return f.same_picture; });
    const bool paper = m.top.starts_with("agglomerative") && m.frames.front().references == 256;
    table.rows.push_back(
        {m.scene, m.top, m.trees, m.frames.size(),
         static_cast<std::uint64_t>(
             median(sorted(m, [](const FrameMeasure& f) { return static_cast<double>(f.references); }))),
         median(build), build.back(),
         median(
             sorted(m, [&](const FrameMeasure& f) { return f.build_seconds / first.frames[f.frame].build_seconds; })),
         paper ? Json(0.5) : Json(), median(sah), sah.back(),
         median(sorted(m, [&](const FrameMeasure& f) { return f.sah / first.frames[f.frame].sah; })),
         median(sorted(m, [](const FrameMeasure& f) { return per_ray(f.box_tests, f); })),
         median(sorted(m, [](const FrameMeasure& f) { return per_ray(f.triangle_tests, f); })),
         median(sorted(m, [](const FrameMeasure& f) { return per_ray(f.transforms, f); })),
         same ? "all the same" : "NOT ALL"});
  }
  return table;
}

Table every_frame_table(const std::vector<FramesMeasure>& measures) {
  Table table{"two_level_every_frame",
              "Every frame",
              {{"scene", "scene"},
               {"top", "top level"},
               {"trees", "trees"},
               {"frame", "frame"},
               {"references", "references"},
               {"build_ms", "build ms", 3},
               {"sah", "SAH", 2},
               {"rays", "rays"},
               {"hits", "hits"},
               {"box_tests", "box tests"},
               {"triangle_tests", "triangle tests"},
               {"transforms", "transforms"},
               {"picture", "picture"}},
              4,
              {},
              {},
              false};
  for (const FramesMeasure& m : measures) {
    for (const FrameMeasure& f : m.frames) {
      table.rows.push_back({m.scene, m.top, m.trees, f.frame, f.references, build_ms(f), f.sah, f.rays, f.hits,
                            f.box_tests, f.triangle_tests, f.transforms, fmt::format("{:016x}", f.picture)});
    }
  }
  return table;
}

}  // namespace cbvh::testbench
