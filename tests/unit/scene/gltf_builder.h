// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include "scene_files.h"

namespace cbvh::golden {

inline std::string joined(const std::vector<std::string>& parts) {
  std::string list;
  for (const std::string& part : parts) list += (list.empty() ? "" : ",") + part;
  return list;
}

inline std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? kDigits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

/// A glTF made of text, so that tests can put anything anywhere.
struct GltfBuilder {
  std::string buffer;
  std::vector<std::string> views, accessors, meshes, nodes;
  std::string scenes = R"("scenes":[{"nodes":[0]}],"scene":0)";
  std::string more;  ///< members of the root, each with a comma after it

  int view(const std::string& bytes, const std::string& members = "") {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    views.push_back(
        fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", buffer.size(), bytes.size(), members));
    buffer += bytes;
    return static_cast<int>(views.size()) - 1;
  }

  int accessor(int view_index, int component_type, std::size_t count, const std::string& type,
               const std::string& members = "") {
    const std::string from = view_index < 0 ? "" : fmt::format(R"("bufferView":{},)", view_index);
    accessors.push_back(fmt::format(R"({{{}"componentType":{},"count":{},"type":"{}"{}}})", from, component_type, count,
                                    type, members));
    return static_cast<int>(accessors.size()) - 1;
  }

  int positions(const std::vector<glm::vec3>& values) {
    return accessor(view(bytes_of(values)), 5126, values.size(), "VEC3");
  }

  template <class T>
  int indices(const std::vector<T>& values) {
    return accessor(view(bytes_of(values)),
                    sizeof(T) == 1   ? 5121
                    : sizeof(T) == 2 ? 5123
                                     : 5125,
                    values.size(), "SCALAR");
  }

  static std::string primitive(int position, int index = -1, int mode = 4) {
    const std::string from = index < 0 ? "" : fmt::format(R"(,"indices":{})", index);
    return fmt::format(R"({{"attributes":{{"POSITION":{}}},"mode":{}{}}})", position, mode, from);
  }

  void mesh(const std::vector<std::string>& primitives) {
    meshes.push_back(fmt::format(R"({{"primitives":[{}]}})", joined(primitives)));
  }

  std::string json(const std::string& buffer_members) const {
    std::string text = R"({"asset":{"version":"2.0"},)" + more;
    for (const auto& [name, parts] :
         {std::pair{"bufferViews", &views}, {"accessors", &accessors}, {"meshes", &meshes}, {"nodes", &nodes}}) {
      if (!parts->empty()) text += fmt::format("\"{}\":[{}],", name, joined(*parts));
    }
    if (!scenes.empty()) text += scenes + ",";
    return text + fmt::format(R"("buffers":[{{"byteLength":{}{}}}]}})", buffer.size(), buffer_members);
  }

  std::string gltf() const { return json(",\"uri\":\"data:application/octet-stream;base64," + base64(buffer) + "\""); }

  std::string glb() const { return glb_of(json(""), buffer); }

  static std::string glb_of(std::string text, std::string bin) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    bin.resize((bin.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) {
      return bytes_of(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
    };
    const std::string chunks = word(text.size()) + "JSON" + text + word(bin.size()) + std::string("BIN\0", 4) + bin;
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
  }
};

/// One mesh of two triangles with 16-bit indices under one node.
inline GltfBuilder two_triangles() {
  GltfBuilder b;
  const int p = b.positions({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}});
  b.mesh({GltfBuilder::primitive(p, b.indices<std::uint16_t>({0, 1, 2, 0, 2, 3}))});
  b.nodes = {R"({"mesh":0})"};
  return b;
}

}  // namespace cbvh::golden
