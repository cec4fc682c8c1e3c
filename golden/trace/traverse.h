// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/build/triangle_box.h"
#include "golden/scene/mesh.h"
#include "golden/trace/ray.h"
#include "golden/trace/triangle.h"

namespace cbvh::golden {

/// When a ray stops.
enum class Stop : std::uint8_t {
  closest,  ///< at the nearest hit: what lies behind the nearest one so far is left out
  any,      ///< at the first hit found
  never,    ///< not at all: every box and triangle on its way is tested (the surface area heuristic's ray)
};

/// The nearest hit. Of triangles hit at the same t the one with the least index, so that it does not depend on the
/// tree.
struct Hit {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t primitive = kNone;
  double t = std::numeric_limits<double>::infinity();
  bool operator==(const Hit&) const = default;
};

/// What rays cost.
struct TraceCounts {
  std::uint64_t pairs = 0;  ///< node pairs visited, the traversal steps
  std::uint64_t box_tests = 0;
  std::uint64_t triangle_tests = 0;
  void add(const TraceCounts& other) {
    pairs += other.pairs;
    box_tests += other.box_tests;
    triangle_tests += other.triangle_tests;
  }
  bool operator==(const TraceCounts&) const = default;
};

/// A float tree as the traversal sees it.
class FloatTreeView {
 public:
  explicit FloatTreeView(const FloatTree& tree) : tree_(&tree) {}

  using Node = std::uint32_t;  ///< of an inner node: its pair
  struct Opened {
    std::array<Box, 2> box;
    std::array<bool, 2> leaf;
    std::array<std::uint32_t, 2> pointer;
  };

  const Box& root_box() const { return tree_->scene; }
  bool is_leaf() const { return tree_->pairs.empty(); }
  Node root() const { return static_cast<Node>(tree_->pairs.size() - 1); }
  const std::vector<std::uint32_t>& primitive_ids() const { return tree_->primitive_ids; }

  Opened open(Node node) const {
    const FloatPair& pair = tree_->pairs[node];
    return {{pair.child[0], pair.child[1]}, {pair.leaf[0], pair.leaf[1]}, {pair.pointer[0], pair.pointer[1]}};
  }
  static Node child(Node, const Opened& opened, std::size_t c) { return opened.pointer[c]; }
  /// What a ray needs first of a child.
  const void* first_of(const Opened& opened, std::size_t c) const {
    const std::uint32_t pointer = opened.pointer[c];
    return opened.leaf[c] ? static_cast<const void*>(&tree_->primitive_ids[pointer]) : &tree_->pairs[pointer];
  }
  static constexpr std::size_t kPairBytes = sizeof(FloatPair);

 private:
  const FloatTree* tree_;
};

/// Traces rays through one tree. Keeps its stack between rays; one a thread.
template <class View>
class Tracer {
 public:
  Tracer(const View& view, const Mesh& mesh) : view_(view), mesh_(mesh) {}

  /// The nearest hit in [t_min, t_max], the first found with Stop::any. The ray must pass check_ray.
  Hit trace(const Ray& ray, Stop stop) {
    const PreparedRay prepared(ray);
    const TriangleTest triangle(ray);
    Hit hit;
    ++counts_.box_tests;
    if (prepared.inside(view_.root_box()).empty()) return hit;
    if (view_.is_leaf()) {
      test_leaf(0, prepared, triangle, stop, hit);
    } else {
      trace_below(view_.root(), prepared, triangle, stop, hit);
    }
    return hit;
  }

  /// The same for what lies below an inner node, whatever its own box: a hit that comes before `hit` replaces it.
  void trace_below(const typename View::Node& node, const PreparedRay& ray, const TriangleTest& triangle, Stop stop,
                   Hit& hit) {
    waiting_.assign(1, {node, -std::numeric_limits<double>::infinity()});
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (stop != Stop::never && next.entry > hit.t) continue;
      if (visit(next.node, ray, triangle, stop, hit)) return;
    }
  }

  /// The same for the leaf whose entries start at `first`; true if it ends a ray that stops at any hit.
  bool test_leaf(std::size_t first, const PreparedRay& ray, const TriangleTest& triangle, Stop stop, Hit& hit) {
    const std::vector<std::uint32_t>& ids = view_.primitive_ids();
    for (std::size_t entry = first;; ++entry) {
      const std::uint32_t id = ids[entry] & ~kLastOfLeaf;
      if (test_triangle(id, ray, triangle, hit) && stop == Stop::any) return true;
      if ((ids[entry] & kLastOfLeaf) != 0) return false;
    }
  }

  /// The same for a triangle; true if it is the hit now. The hit's t is clamped to where the ray's line is inside the
  /// triangle's box: then no box around the triangle is left out for a nearer hit (ray.h).
  bool test_triangle(std::uint32_t id, const PreparedRay& ray, const TriangleTest& triangle, Hit& hit) {
    ++counts_.triangle_tests;
    const glm::uvec3& corners = mesh_.triangles[id];
    const glm::vec3& a = mesh_.positions[corners.x];
    const glm::vec3& b = mesh_.positions[corners.y];
    const glm::vec3& c = mesh_.positions[corners.z];
    const std::optional<double> found = triangle(a, b, c);
    if (!found) return false;
    const Interval line = ray.line_inside(triangle_box(a, b, c));
    if (line.empty()) return false;
    const double t = std::min(std::max(*found, line.entry), line.exit);
    if (!ray.reaches(t)) return false;
    if (t > hit.t || (t == hit.t && id > hit.primitive)) return false;
    hit = {id, t};
    return true;
  }

  const TraceCounts& counts() const { return counts_; }

 private:
  struct Waiting {
    typename View::Node node;
    double entry;
  };

  /// Tests both children, leaves at once, the nearer one first; true if the ray is done.
  bool visit(const typename View::Node& node, const PreparedRay& ray, const TriangleTest& triangle, Stop stop,
             Hit& hit) {
    ++counts_.pairs;
    counts_.box_tests += 2;
    const auto opened = view_.open(node);
    for (std::size_t c = 0; c < 2; ++c) {  // while the boxes are tested, memory can bring what comes next
      const void* const first = view_.first_of(opened, c);
      __builtin_prefetch(first);
      __builtin_prefetch(static_cast<const char*>(first) + View::kPairBytes - 1);
    }
    const std::array<Interval, 2> inside{ray.inside(opened.box[0]), ray.inside(opened.box[1])};
    const std::size_t nearer = inside[1].entry < inside[0].entry ? 1 : 0;
    for (const std::size_t c : {nearer, 1 - nearer}) {
      if (!opened.leaf[c] || inside[c].empty() || (stop != Stop::never && inside[c].entry > hit.t)) continue;
      if (test_leaf(opened.pointer[c], ray, triangle, stop, hit)) return true;
    }
    for (const std::size_t c : {1 - nearer, nearer}) {
      if (!opened.leaf[c] && !inside[c].empty()) waiting_.push_back({view_.child(node, opened, c), inside[c].entry});
    }
    return false;
  }

  View view_;
  const Mesh& mesh_;
  std::vector<Waiting> waiting_;
  TraceCounts counts_;
};

}  // namespace cbvh::golden
