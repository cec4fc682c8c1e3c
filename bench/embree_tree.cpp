// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "bench/embree_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <new>
#include <stdexcept>

#include "golden/build/float_tree.h"

namespace cbvh::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct Node {
  Node* child[2];     ///< null in a leaf
  golden::Box box;    ///< of a leaf
  std::size_t count;  ///< of a leaf
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
  return new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node{};
}

void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<Node*>(node)->child[i] = static_cast<Node*>(children[i]);
}

void set_bounds(void*, const RTCBounds**, unsigned, void*) {}

void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
  Node* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(Node), alignof(Node))) Node{};
  leaf->count = count;
  for (std::size_t i = 0; i < count; ++i) {
    const RTCBuildPrimitive& p = primitives[i];
    const golden::Box box{{p.lower_x, p.lower_y, p.lower_z}, {p.upper_x, p.upper_y, p.upper_z}};
    leaf->box = i == 0 ? box : golden::unite(leaf->box, box);
  }
  return leaf;
}

/// Splits the box alone.
void split_primitive(const RTCBuildPrimitive* p, unsigned axis, float position, RTCBounds* left, RTCBounds* right,
                     void*) {
  left->lower_x = right->lower_x = p->lower_x;
  left->lower_y = right->lower_y = p->lower_y;
  left->lower_z = right->lower_z = p->lower_z;
  left->upper_x = right->upper_x = p->upper_x;
  left->upper_y = right->upper_y = p->upper_y;
  left->upper_z = right->upper_z = p->upper_z;
  (&left->upper_x)[axis] = position;
  (&right->lower_x)[axis] = position;
}

/// Sums cost times half area below a node; returns its box.
golden::Box add_costs(const Node& node, const golden::SahCosts& costs, double& sum, std::size_t& references) {
  if (node.child[0] == nullptr) {
    sum += costs.intersection * static_cast<double>(node.count) * golden::half_area(node.box);
    references += node.count;
    return node.box;
  }
  const golden::Box left = add_costs(*node.child[0], costs, sum, references);
  const golden::Box own = golden::unite(left, add_costs(*node.child[1], costs, sum, references));
  sum += costs.traversal * golden::half_area(own);
  return own;
}

std::vector<RTCBuildPrimitive> boxes_of(const golden::Mesh& mesh, bool room_for_splits) {
  std::vector<RTCBuildPrimitive> boxes;
  boxes.reserve(mesh.triangles.size() * (room_for_splits ? 2 : 1));
  for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id) {
    const glm::vec3& a = mesh.positions[mesh.triangles[id].x];
    const glm::vec3& b = mesh.positions[mesh.triangles[id].y];
    const glm::vec3& c = mesh.positions[mesh.triangles[id].z];
    boxes.push_back({std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z}), 0,
                     std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z}), id});
  }
  return boxes;
}

}  // namespace

Embree::Embree(int threads) : device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
  if (device_ == nullptr) throw std::runtime_error("no Embree device");
}

Embree::~Embree() { rtcReleaseDevice(device_); }

Embree::Tree Embree::build(const golden::Mesh& mesh, RTCBuildQuality quality, unsigned leaf,
                           const golden::SahCosts& costs) const {
  const RTCBVH bvh = rtcNewBVH(device_);
  const auto start = Clock::now();
  std::vector<RTCBuildPrimitive> boxes = boxes_of(mesh, quality == RTC_BUILD_QUALITY_HIGH);
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = quality;
  arguments.maxBranchingFactor = 2;
  arguments.maxDepth = 1024;
  arguments.maxLeafSize = leaf;
  arguments.traversalCost = static_cast<float>(costs.traversal);
  arguments.intersectionCost = static_cast<float>(costs.intersection);
  arguments.bvh = bvh;
  arguments.primitives = boxes.data();
  arguments.primitiveCount = boxes.size();
  arguments.primitiveArrayCapacity = boxes.capacity();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_bounds;
  arguments.createLeaf = create_leaf;
  arguments.splitPrimitive = split_primitive;
  const auto* root = static_cast<const Node*>(rtcBuildBVH(&arguments));
  Tree tree{seconds_since(start), 0, 0};
  if (root == nullptr)
    throw std::runtime_error(fmt::format("Embree: error {}", static_cast<int>(rtcGetDeviceError(device_))));
  double sum = 0;
  const golden::Box scene = add_costs(*root, costs, sum, tree.references);
  tree.sah = sum / golden::half_area(scene);
  rtcReleaseBVH(bvh);
  return tree;
}

double Embree::commit(const golden::Mesh& mesh, RTCBuildQuality quality) const {
  const RTCScene scene = rtcNewScene(device_);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSceneBuildQuality(scene, quality);
  rtcSetGeometryBuildQuality(geometry, quality);
  const auto fill = [&](RTCBufferType type, RTCFormat format, const auto& values) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(values[0]), values.size());
    std::memcpy(buffer, values.data(), values.size() * sizeof(values[0]));
  };
  fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.positions);
  fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  const auto start = Clock::now();
  rtcCommitScene(scene);
  const double seconds = seconds_since(start);
  rtcReleaseGeometry(geometry);
  rtcReleaseScene(scene);
  return seconds;
}

}  // namespace cbvh::bench
