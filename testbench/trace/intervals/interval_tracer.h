// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <vector>

#include "golden/trace/compressed_view.h"
#include "golden/trace/plane_distance.h"
#include "golden/trace/traced_mesh.h"
#include "rtl_model/datapath/intersect_pair.h"
#include "rtl_model/datapath/ray_setup.h"
#include "vectors/convert.h"

namespace cbvh::testbench {

/// An interval of the unit that does not enclose the exact one, or a hit it lost: ray, node and both.
class IntervalViolation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A box as the multiples of cells that its edges are.
struct ExactBox {
  std::array<double, 3> lower;
  std::array<double, 3> upper;
};

/// Whose box a test is of.
struct TestedNode {
  std::uint32_t pair;  ///< kNoPair: the root
  std::size_t child;
  static constexpr std::uint32_t kNoPair = ~0U;
};

/// Throws IntervalViolation unless on every axis the unit's distances enclose those of the box's planes.
void check_planes(const golden::Ray& ray, const ExactBox& box, const std::array<rtl::PlaneDistances, 3>& planes,
                  const TestedNode& node);

/// "root", or "child C of pair P".
std::string node_text(const TestedNode& node);

/// "ray OX,OY,...", as --ray takes it.
std::string ray_text(const golden::Ray& ray);

/// A mesh behind its compressed tree, as the traversal unit's datapaths see it; N: the tree's bits. Every box test is
/// checked, and every ray's hit is that of the golden.
template <int N>
class IntervalTracer {
 public:
  using Hit = golden::Hit;

  IntervalTracer(const golden::CompressedTree& tree, const golden::Mesh& mesh)
      : tree_(&tree),
        view_(tree),
        golden_(view_, mesh),
        leaves_(view_, mesh),
        registers_(vectors::scene_registers(tree.rules, tree.code)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<int>(axis);
      const int scale = tree.root[axis].scale;
      const auto cells = golden::encode<std::int64_t>(tree.scene.lower[a], tree.scene.upper[a], scale);
      root_box_.lower[axis] = edge(cells.lower, scale);
      root_box_.upper[axis] = edge(cells.upper, scale);
      root_.grid[axis] = {rtl::Scale(scale), rtl::UInt<N>(static_cast<std::uint64_t>(golden::modulo(cells.lower, N))),
                          rtl::UInt<N + 1>(static_cast<std::uint64_t>(cells.upper - cells.lower))};
    }
  }

  const golden::Box& box() const { return tree_->scene; }
  std::optional<golden::Surface> surface(const golden::Ray& ray, const Hit& hit) const {
    return golden_.surface(ray, hit);
  }
  /// The unit's.
  const golden::TraceCounts& counts() const { return counts_; }
  /// The golden's, of the same rays.
  const golden::TraceCounts& golden_counts() const { return golden_.counts(); }

  Hit trace(const golden::Ray& ray, golden::Stop stop) {
    const Hit found = trace_by_unit(ray, stop);
    const Hit wanted = golden_.trace(ray, stop);
    const bool same = stop == golden::Stop::any ? (found == Hit()) == (wanted == Hit()) : found == wanted;
    if (!same) {
      throw IntervalViolation(
          fmt::format("{}: through the unit's boxes triangle {} at {}, want {} at {}", ray_text(ray),
                      static_cast<std::int64_t>(static_cast<std::int32_t>(found.primitive)), found.t,
                      static_cast<std::int64_t>(static_cast<std::int32_t>(wanted.primitive)), wanted.t));
    }
    return wanted;
  }

 private:
  struct Waiting {
    golden::CompressedTreeView::Node node;
    rtl::ReachedNode<N> reached;
    float entry;
  };

  static double edge(std::int64_t index, int scale) { return static_cast<double>(index) * golden::power_of_two(scale); }

  static rtl::RaySetupJob setup_job(const golden::Ray& ray, const ExactBox& box) {
    rtl::RaySetupJob job;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<int>(axis);
      job.origin[axis] = rtl::Float32::of(ray.origin[a]);
      job.direction[axis] = rtl::Float32::of(ray.direction[a]);
      job.root.lower[axis] = rtl::Float32::of(static_cast<float>(box.lower[axis]));
      job.root.upper[axis] = rtl::Float32::of(static_cast<float>(box.upper[axis]));
    }
    return job;
  }

  Hit trace_by_unit(const golden::Ray& ray, golden::Stop stop) {
    const golden::PreparedRay prepared(ray);
    const golden::TriangleTest triangle(ray);
    Hit hit;
    if (view_.is_leaf()) {
      leaves_.test_leaf(0, prepared, triangle, stop, hit);
      return hit;
    }
    const rtl::RaySetupResult ready = rtl::ray_setup<rtl::MachineBits>(setup_job(ray, root_box_));
    expect_status(ray, {TestedNode::kNoPair, 0}, ready.status);
    check_planes(ray, root_box_, ready.planes, {TestedNode::kNoPair, 0});
    ++counts_.box_tests;
    root_.planes = ready.planes;
    waiting_.assign(1, {view_.root(), root_, -std::numeric_limits<float>::infinity()});
    while (!waiting_.empty()) {
      const Waiting next = waiting_.back();
      waiting_.pop_back();
      if (static_cast<double>(next.entry) > hit.t) continue;
      if (visit(next, ray, ready, prepared, triangle, stop, hit)) return hit;
    }
    return hit;
  }

  bool visit(const Waiting& at, const golden::Ray& ray, const rtl::RaySetupResult& ready,
             const golden::PreparedRay& prepared, const golden::TriangleTest& triangle, golden::Stop stop, Hit& hit) {
    ++counts_.pairs;
    counts_.box_tests += 2;
    const golden::CompressedTreeView::Opened opened = view_.open(at.node);
    const rtl::PairTestJob<N> job{vectors::node_pair<N>(tree_->pairs[at.node.pair]),
                                  at.reached,
                                  ready.ray,
                                  rtl::Float32::of(ray.t_min),
                                  rtl::Float32::of(ray.t_max),
                                  registers_};
    const rtl::PairTestResult<N> tested = rtl::intersect_pair<rtl::MachineBits, N>(job);
    expect_status(ray, {at.node.pair, 0}, tested.status);
    for (std::size_t c = 0; c < 2; ++c)
      check_planes(ray, exact_box(opened.cells[c], at.node.context), tested.child[c].node.planes, {at.node.pair, c});
    const std::size_t nearer = tested.second_first.value() != 0 ? 1 : 0;
    const auto entered = [&](std::size_t c) {
      return tested.child[c].hit.value() != 0 && static_cast<double>(tested.child[c].entry.value()) <= hit.t;
    };
    for (const std::size_t c : {nearer, 1 - nearer}) {
      if (!opened.leaf[c] || !entered(c)) continue;
      if (leaves_.test_leaf(opened.pointer[c], prepared, triangle, stop, hit)) return true;
    }
    for (const std::size_t c : {1 - nearer, nearer}) {
      if (opened.leaf[c] || !entered(c)) continue;
      waiting_.push_back({view_.child(at.node, opened, c), tested.child[c].node, tested.child[c].entry.value()});
    }
    return false;
  }

  static ExactBox exact_box(const golden::CellBox<std::int64_t>& cells, const golden::Context<std::int64_t>& parent) {
    ExactBox box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lower[axis] = edge(cells[axis].lower, parent[axis].scale);
      box.upper[axis] = edge(cells[axis].upper, parent[axis].scale);
    }
    return box;
  }

  static void expect_status(const golden::Ray& ray, const TestedNode& node, rtl::StatusBits status) {
    if (status.value() != 0)
      throw IntervalViolation(
          fmt::format("{}, {}: the unit refuses with status {}", ray_text(ray), node_text(node), status.value()));
  }

  const golden::CompressedTree* tree_;
  golden::CompressedTreeView view_;
  golden::TracedMesh<golden::CompressedTreeView> golden_;
  golden::Tracer<golden::CompressedTreeView> leaves_;
  rtl::SceneRegisters registers_;
  ExactBox root_box_{};
  rtl::ReachedNode<N> root_;
  std::vector<Waiting> waiting_;
  golden::TraceCounts counts_;
};

}  // namespace cbvh::testbench
