// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/obj_file.h"

#include <tiny_obj_loader.h>

#include <istream>
#include <streambuf>

#include "golden/input_error.h"
#include "golden/scene/obj_check.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

/// Reads a string without copying it.
class StringSource : public std::streambuf {
 public:
  explicit StringSource(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

void add_vertex(void* user, float x, float y, float z, float) {
  static_cast<Mesh*>(user)->positions.emplace_back(x, y, z);
}

/// check_obj has seen that every index is in range: positive from 1, negative from the last vertex so far.
void add_face(void* user, tinyobj::index_t* corners, int count) {
  Mesh& mesh = *static_cast<Mesh*>(user);
  const auto vertex = [&](int i) {
    const std::int64_t index = corners[i].vertex_index;
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : static_cast<std::int64_t>(mesh.positions.size()) + index);
  };
  for (int i = 2; i < count; ++i) mesh.triangles.emplace_back(vertex(0), vertex(i - 1), vertex(i));
}

}  // namespace

Mesh read_obj(const std::string& path) {
  std::string text = read_file(path);
  const ObjCounts counts = check_obj(text, path);
  Mesh mesh;
  mesh.positions.reserve(counts.vertices);
  mesh.triangles.reserve(counts.triangles);

  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = add_vertex;
  callbacks.index_cb = add_face;
  StringSource source(text);
  std::istream stream(&source);
  std::string warning;
  std::string error;
  const bool loaded = tinyobj::LoadObjWithCallback(stream, callbacks, &mesh, nullptr, &warning, &error);
  if (!loaded) throw InputError(path, one_line(error));
  if (mesh.positions.size() != counts.vertices || mesh.triangles.size() != counts.triangles) {
    throw InputError(
        path, fmt::format("tinyobjloader found {} vertices and {} triangles, wanted {} and {}", mesh.positions.size(),
                          mesh.triangles.size(), counts.vertices, counts.triangles));
  }
  return mesh;
}

}  // namespace cbvh::golden
