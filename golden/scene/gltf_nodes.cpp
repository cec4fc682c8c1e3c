// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/gltf_nodes.h"

#include <tiny_gltf.h>

#include <cmath>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

/// Translation * rotation * scale, columns first, in binary64.
glm::dmat4 from_parts(const tinygltf::Node& node) {
  const auto part = [](const std::vector<double>& values, std::size_t i, double missing) {
    return values.empty() ? missing : values[i];
  };
  const double x = part(node.rotation, 0, 0.0);
  const double y = part(node.rotation, 1, 0.0);
  const double z = part(node.rotation, 2, 0.0);
  const double w = part(node.rotation, 3, 1.0);
  const glm::dvec3 columns[3] = {{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)},
                                 {2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)},
                                 {2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)}};
  glm::dmat4 matrix(1.0);
  for (int c = 0; c < 3; ++c) {
    const double scale = part(node.scale, static_cast<std::size_t>(c), 1.0);
    for (int r = 0; r < 3; ++r) matrix[c][r] = columns[c][r] * scale;
    matrix[3][c] = part(node.translation, static_cast<std::size_t>(c), 0.0);
  }
  return matrix;
}

/// a * b, summed left to right. Not glm's product, whose order of summation depends on the instruction set.
glm::dmat4 product(const glm::dmat4& a, const glm::dmat4& b) {
  glm::dmat4 result(0.0);
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r)
      result[c][r] = a[0][r] * b[c][0] + a[1][r] * b[c][1] + a[2][r] * b[c][2] + a[3][r] * b[c][3];
  }
  return result;
}

class Walk {
 public:
  explicit Walk(const GltfSource& from) : source(from), model(from.model), reached(model.nodes.size(), false) {}

  /// Without recursion: a file may nest its nodes as deep as it likes.
  void visit(int root, const std::string& user) {
    std::vector<Visit> open;
    push(open, root, glm::dmat4(1.0), user);
    while (!open.empty()) {
      const Visit now = open.back();
      open.pop_back();
      const tinygltf::Node& node = model.nodes[now.node];
      const glm::dmat4 to_world = product(now.parent, own_matrix(node, now.node));
      if (node.mesh >= 0) instances.push_back({checked_mesh(node.mesh, now.node), to_world});
      const std::string children = fmt::format("nodes[{}].children", now.node);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        push(open, *child, to_world, children);
    }
  }

  std::vector<MeshInstance> instances;

 private:
  struct Visit {
    std::size_t node;
    glm::dmat4 parent;
  };

  void push(std::vector<Visit>& open, int node, const glm::dmat4& parent, const std::string& user) {
    if (node < 0 || static_cast<std::size_t>(node) >= model.nodes.size()) {
      throw InputError(source.file, fmt::format("{}: node {}, wanted less than {}", user, node, model.nodes.size()));
    }
    const auto index = static_cast<std::size_t>(node);
    if (reached[index])
      throw InputError(source.file, fmt::format("{}: node {} is reached twice, wanted a tree", user, node));
    reached[index] = true;
    open.push_back({index, parent});
  }

  glm::dmat4 own_matrix(const tinygltf::Node& node, std::size_t index) const {
    if (node.matrix.empty()) return from_parts(node);
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    const bool is_affine = matrix[0][3] == 0.0 && matrix[1][3] == 0.0 && matrix[2][3] == 0.0 && matrix[3][3] == 1.0;
    if (!is_affine) throw InputError(source.file, fmt::format("nodes[{}].matrix: wanted a last row of 0 0 0 1", index));
    return matrix;
  }

  std::size_t checked_mesh(int mesh, std::size_t node) const {
    if (static_cast<std::size_t>(mesh) < model.meshes.size()) return static_cast<std::size_t>(mesh);
    throw InputError(source.file,
                     fmt::format("nodes[{}].mesh: found {}, wanted less than {}", node, mesh, model.meshes.size()));
  }

  const GltfSource& source;
  const tinygltf::Model& model;
  std::vector<bool> reached;
};

std::vector<MeshInstance> place_without_scene(const GltfSource& source) {
  const tinygltf::Model& model = source.model;
  std::vector<bool> is_child(model.nodes.size(), false);
  std::vector<bool> is_placed(model.meshes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) {
      if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
        is_child[static_cast<std::size_t>(child)] = true;
    }
    if (node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < is_placed.size())
      is_placed[static_cast<std::size_t>(node.mesh)] = true;
  }
  Walk walk(source);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    if (!is_child[i]) walk.visit(static_cast<int>(i), "nodes");
  }
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    if (!is_placed[i]) walk.instances.push_back({i, glm::dmat4(1.0)});
  }
  return std::move(walk.instances);
}

}  // namespace

std::vector<MeshInstance> place_meshes(const GltfSource& source) {
  const tinygltf::Model& model = source.model;
  if (model.scenes.empty() && model.defaultScene < 0) return place_without_scene(source);
  const auto scene = static_cast<std::size_t>(model.defaultScene < 0 ? 0 : model.defaultScene);
  if (scene >= model.scenes.size()) {
    throw InputError(source.file, fmt::format("scene: found {}, wanted less than {}", scene, model.scenes.size()));
  }
  Walk walk(source);
  for (const int root : model.scenes[scene].nodes) walk.visit(root, fmt::format("scenes[{}].nodes", scene));
  return std::move(walk.instances);
}

}  // namespace cbvh::golden
