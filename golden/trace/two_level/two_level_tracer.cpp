// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/trace/two_level/two_level_tracer.h"

namespace cbvh::golden {

TwoLevelTracer::TwoLevelTracer(const TopLevel& top, const InstancedTrees& trees, const InstanceRays& rays)
    : top_(top), trees_(trees), rays_(rays) {
  objects_.reserve(trees.trees.size());
  for (std::size_t i = 0; i < trees.trees.size(); ++i)
    objects_.emplace_back(ObjectTreeView(*trees.trees[i]), trees.scene->objects[i]);
}

InstanceHit TwoLevelTracer::trace(const Ray& ray, Stop stop) {
  const PreparedRay prepared(ray);
  const double slack = rays_.slack(ray);
  InstanceHit nearest;
  ++counts_.box_tests;
  if (prepared.inside(top_.tree.scene, slack).empty()) return nearest;
  if (top_.tree.pairs.empty()) {
    enter(0, ray, stop, nearest);
    return nearest;
  }
  const auto left_out = [&](double entry) { return stop != Stop::never && entry > nearest.t; };
  waiting_.assign(1,
                  {static_cast<std::uint32_t>(top_.tree.pairs.size() - 1), -std::numeric_limits<double>::infinity()});
  while (!waiting_.empty()) {
    const Waiting next = waiting_.back();
    waiting_.pop_back();
    if (left_out(next.entry)) continue;
    const FloatPair& pair = top_.tree.pairs[next.pair];
    ++counts_.pairs;
    counts_.box_tests += 2;
    const std::array<Interval, 2> inside{prepared.inside(pair.child[0], slack), prepared.inside(pair.child[1], slack)};
    const int nearer = inside[1].entry < inside[0].entry ? 1 : 0;
    for (const int c : {nearer, 1 - nearer}) {
      const Interval& where = inside[static_cast<std::size_t>(c)];
      if (!pair.leaf[c] || where.empty() || left_out(where.entry)) continue;
      if (enter(pair.pointer[c], ray, stop, nearest)) return nearest;
    }
    for (const int c : {1 - nearer, nearer}) {
      const Interval& where = inside[static_cast<std::size_t>(c)];
      if (!pair.leaf[c] && !where.empty()) waiting_.push_back({pair.pointer[c], where.entry});
    }
  }
  return nearest;
}

bool TwoLevelTracer::enter(std::uint32_t entry, const Ray& ray, Stop stop, InstanceHit& nearest) {
  const SubtreeReference& to = top_.references[top_.tree.primitive_ids[entry] & ~kLastOfLeaf];
  const WideRay image = rays_.image(ray, to.instance);
  const PreparedRay prepared(image);
  const TriangleTest triangle(image);
  Tracer<ObjectTreeView>& object = objects_[trees_.scene->instances[to.instance].object];
  ++transforms_;
  Hit hit;
  hit.t = nearest.t;
  switch (to.node.kind) {
    case ObjectNode::Kind::pair:
      object.trace_below(to.node, prepared, triangle, stop, hit);
      break;
    case ObjectNode::Kind::leaf:
      object.test_leaf(to.node.index, prepared, triangle, stop, hit);
      break;
    case ObjectNode::Kind::primitive:
      object.test_triangle(to.node.index, prepared, triangle, hit);
      break;
  }
  if (hit.primitive == Hit::kNone) return false;
  const InstanceHit found{to.instance, hit.primitive, hit.t};
  if (found.before(nearest)) nearest = found;
  return stop == Stop::any;
}

TwoLevelCounts TwoLevelTracer::counts() const {
  TwoLevelCounts counts{counts_, {}, transforms_};
  for (const Tracer<ObjectTreeView>& object : objects_) counts.objects.add(object.counts());
  return counts;
}

}  // namespace cbvh::golden
