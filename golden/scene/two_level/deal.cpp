// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "golden/scene/two_level/two_level_scenes.h"

namespace cbvh::golden {
namespace {

/// Moves triangles of `mesh` into objects of their own, with the vertices they use.
class Object {
 public:
  Object(const Mesh& mesh, std::vector<std::uint32_t>& place_of_vertex) : from(mesh), places(place_of_vertex) {}

  void take(const glm::uvec3& triangle) {
    glm::uvec3 own;
    for (glm::length_t corner = 0; corner < 3; ++corner) own[corner] = place(triangle[corner]);
    result.triangles.push_back(own);
  }

  Mesh result;

 private:
  /// places[v] is right if result has that very vertex there; what other objects left in it is harmless.
  std::uint32_t place(std::uint32_t vertex) {
    std::uint32_t& at = places[vertex];
    if (at >= vertices.size() || vertices[at] != vertex) {
      at = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(vertex);
      result.positions.push_back(from.positions[vertex]);
    }
    return at;
  }

  const Mesh& from;
  std::vector<std::uint32_t>& places;
  std::vector<std::uint32_t> vertices;
};

TwoLevelScene make(Mesh mesh, const OptionValues& options) {
  const std::size_t objects = options.integer("objects");
  const std::size_t chunk = options.integer("chunk");
  std::vector<std::uint32_t> place_of_vertex(mesh.positions.size());
  TwoLevelScene scene;
  for (std::size_t i = 0; i < objects && i * chunk < mesh.triangles.size(); ++i) {
    Object object(mesh, place_of_vertex);
    for (std::size_t first = i * chunk; first < mesh.triangles.size(); first += objects * chunk) {
      const std::size_t last = std::min(first + chunk, mesh.triangles.size());
      for (std::size_t triangle = first; triangle < last; ++triangle) object.take(mesh.triangles[triangle]);
    }
    object.result.name = fmt::format("{} object {}", mesh.name, i);
    scene.instances.push_back({static_cast<std::uint32_t>(scene.objects.size())});
    scene.objects.push_back(std::move(object.result));
  }
  return scene;
}

}  // namespace

TwoLevelKind deal_kind() {
  return {
      "deal",
      "a mesh dealt out to objects, `chunk` triangles at a time in their order: objects that overlap, in world space",
      {{"objects", "how many, at most", 16, 1, 65536}, {"chunk", "triangles dealt at a time", 1, 1, 134217728}},
      make};
}

}  // namespace cbvh::golden
