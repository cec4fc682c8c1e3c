// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/build/subtree_arrays.h"

#include <algorithm>

#include "golden/build/object_median.h"
#include "golden/build/triangle_box.h"
#include "golden/threads/parallel_for.h"

namespace cbvh::golden {

void SubtreeArrays::Free::operator()(Reference* array) const { Unwritten<Reference>().deallocate(array, count); }

std::unique_ptr<Reference[], SubtreeArrays::Free> SubtreeArrays::unwritten(std::size_t count) {
  return {Unwritten<Reference>().allocate(count), Free{count}};
}

SubtreeArrays::SubtreeArrays(std::uint32_t count) : count_(count), buffers_{unwritten(count), unwritten(count)} {
  tree_.nodes.resize(2 * std::size_t{count} - 1);
  tree_.references.resize(count);
}

WideBox SubtreeArrays::centroids(const Subtree& node) {
  WideBox box;
  for (const Reference& reference : references(node)) box.enclose(reference.box().centroid());
  return box;
}

std::array<Subtree, 2> SubtreeArrays::divide_at_median(const Subtree& node) {
  const int axis = longest_axis(centroids(node));
  const auto key = [axis](const Reference& reference) { return static_cast<float>(reference.box().centroid()[axis]); };
  const std::span<const Reference> all = references(node);
  const Rank median = object_median(node.count, [&](std::uint32_t i) { return key(all[i]); });
  return divide(node, node.count / 2, [&](std::uint32_t i, const Reference& reference) {
    return Rank{key(reference), i} < median;
  });
}

void SubtreeArrays::make_leaf(const Subtree& node) {
  tree_.nodes[node.node] = {narrowed(node.box), node.first, node.count};
  std::uint32_t* to = tree_.references.data() + node.first;
  for (const Reference& reference : references(node)) *to++ = reference.id();
}

std::array<WideBox, 2> write_references(const Mesh& mesh, const TeamMember& member, SubtreeArrays& arrays) {
  const TeamMember::Share share = member.share(arrays.count());
  Reference* const to = arrays.buffer(false);
  std::array<WideBox, 2> boxes;
  for (std::uint32_t id = share.first; id < share.last; ++id) {
    const glm::uvec3& triangle = mesh.triangles[id];
    to[id] =
        Reference(triangle_box(mesh.positions[triangle.x], mesh.positions[triangle.y], mesh.positions[triangle.z]), id);
    boxes[0].enclose(to[id].box());
    boxes[1].enclose(to[id].box().centroid());
  }
  return boxes;
}

void build_subtrees(std::vector<Subtree> subtrees, int threads, const std::function<void(const Subtree&)>& build) {
  std::stable_sort(subtrees.begin(), subtrees.end(),
                   [](const Subtree& a, const Subtree& b) { return a.count > b.count; });
  parallel_for(subtrees.size(), static_cast<unsigned>(threads), [&](std::size_t i) { build(subtrees[i]); });
}

}  // namespace cbvh::golden
