// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/gltf_file.h"

#include <tiny_gltf.h>

#include <cstring>
#include <filesystem>

#include "golden/scene/gltf_accessor.h"
#include "golden/scene/gltf_json.h"
#include "golden/scene/gltf_nodes.h"
#include "golden/scene/mesh_check.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

constexpr std::size_t kGlbHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

// ---- files
// ---------------------------------------------------------------------------------------------------------------------------

/// Files are read by our own code: only regular ones, only beside the scene, no shell expansion of their names.
tinygltf::TinyGLTF make_loader() {
  tinygltf::FsCallbacks files{};
  files.FileExists = [](const std::string&, void*) {
    return true;
  };  // so that the first candidate, beside the scene, is taken
  files.ExpandFilePath = [](const std::string& path, void*) { return path; };
  files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& path, void*) {
    const std::string bytes = read_file(path);
    out->assign(bytes.begin(), bytes.end());
    return true;
  };
  files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(files);
  return loader;
}

std::string folder_of(const std::string& path) { return std::filesystem::path(path).parent_path().string(); }

std::uint32_t word_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

std::string word_bytes(std::size_t word) {
  const auto narrow = static_cast<std::uint32_t>(word);
  return std::string(reinterpret_cast<const char*>(&narrow), sizeof(narrow));
}

/// Length of the chunk at `offset`, whose header and data must lie in the file.
std::size_t chunk_bytes(const std::string& bytes, std::size_t offset, std::uint32_t type, const char* name,
                        const std::string& path) {
  const std::string place = fmt::format("{}:offset {}", path, offset);
  const std::size_t rest = bytes.size() - offset;
  if (rest < kChunkHeaderBytes)
    throw InputError(place, fmt::format("{} chunk: truncated header, {} bytes of 8", name, rest));
  const std::size_t length = word_at(bytes, offset);
  if (length > rest - kChunkHeaderBytes) {
    throw InputError(place,
                     fmt::format("{} chunk: length {}, but {} bytes follow", name, length, rest - kChunkHeaderBytes));
  }
  if (length % 4 != 0)
    throw InputError(place, fmt::format("{} chunk: length {}, wanted a multiple of 4", name, length));
  if (const std::uint32_t found = word_at(bytes, offset + 4); found != type) {
    throw InputError(place, fmt::format("{} chunk: type {:#010x}, wanted {:#010x}", name, found, type));
  }
  return length;
}

/// Checks the container and replaces its JSON by what geometry_json leaves of it.
void reduce_glb(std::string& bytes, const std::string& path) {
  if (bytes.size() < kGlbHeaderBytes)
    throw InputError(path, fmt::format("GLB header: found {} bytes, wanted 12", bytes.size()));
  if (!bytes.starts_with("glTF"))
    throw InputError(path + ":offset 0", fmt::format("magic: found {}, wanted 'glTF'", in_quotes(bytes.substr(0, 4))));
  if (const auto version = word_at(bytes, 4); version != 2) {
    throw InputError(path + ":offset 4", fmt::format("version: found {}, wanted 2", version));
  }
  if (const auto length = word_at(bytes, 8); length != bytes.size()) {
    throw InputError(path + ":offset 8",
                     fmt::format("length: found {}, wanted the file's {} bytes", length, bytes.size()));
  }
  const std::size_t json_bytes = chunk_bytes(bytes, kGlbHeaderBytes, kJsonChunk, "JSON", path);
  const std::size_t json_end = kGlbHeaderBytes + kChunkHeaderBytes + json_bytes;
  if (json_end != bytes.size()) {
    const std::size_t bin_bytes = chunk_bytes(bytes, json_end, kBinChunk, "BIN", path);
    bytes.resize(json_end + kChunkHeaderBytes + bin_bytes);  // chunks after the BIN chunk are to be ignored
    if (bin_bytes == 0) bytes.resize(json_end);
  }
  std::string json =
      geometry_json(std::string_view(bytes).substr(kGlbHeaderBytes + kChunkHeaderBytes, json_bytes), path, true);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t total = bytes.size() - json_bytes + json.size();
  const std::string chunk_length = word_bytes(json.size());
  bytes.replace(kGlbHeaderBytes + kChunkHeaderBytes, json_bytes, json);
  bytes.replace(8, 4, word_bytes(total));
  bytes.replace(kGlbHeaderBytes, 4, chunk_length);
}

// ---- geometry
// ------------------------------------------------------------------------------------------------------------------------

bool makes_triangles(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
         primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

struct Size {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
};

Size checked_size(const GltfSource& source, const tinygltf::Primitive& primitive, const std::string& at) {
  if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    throw InputError(source.file, fmt::format("{}.mode: found {}, wanted 0 to 6", at, primitive.mode));
  }
  if (!makes_triangles(primitive)) return {};
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) throw InputError(source.file, at + ".attributes: POSITION is missing");
  const std::uint64_t vertices = count_positions(source, position->second, at + ".attributes.POSITION");
  const std::uint64_t corners =
      primitive.indices < 0 ? vertices : count_indices(source, primitive.indices, at + ".indices");
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
    if (corners % 3 != 0)
      throw InputError(source.file, fmt::format("{}: {} corners, wanted a multiple of 3", at, corners));
    return {corners / 3, vertices};
  }
  if (corners < 3) throw InputError(source.file, fmt::format("{}: {} corners, wanted 3 or more", at, corners));
  return {corners - 2, vertices};
}

/// Positions `first` and on, to the world. In binary64, rounded once to binary32; the identity changes no bit.
void transform(std::vector<glm::vec3>& positions, std::size_t first, const glm::dmat4& m) {
  if (m == glm::dmat4(1.0)) return;
  for (std::size_t i = first; i < positions.size(); ++i) {
    const glm::dvec3 p(positions[i]);
    for (int r = 0; r < 3; ++r)
      positions[i][r] = static_cast<float>(m[0][r] * p.x + m[1][r] * p.y + m[2][r] * p.z + m[3][r]);
  }
}

/// Appends triangles in the order of the glTF specification, section 3.7.2.1.
class TriangleBuilder {
 public:
  TriangleBuilder(const GltfSource& from, Mesh& into) : source(from), mesh(into) {}

  void append(const tinygltf::Primitive& primitive, const MeshInstance& instance, const std::string& at) {
    const std::size_t base = mesh.positions.size();
    append_positions(source, primitive.attributes.at("POSITION"), mesh.positions);
    check_positions(base, at, "");
    transform(mesh.positions, base, instance.to_world);
    check_positions(base, at, " after its node's transform");

    const std::uint64_t vertices = mesh.positions.size() - base;
    if (primitive.indices < 0) {
      append_corners(primitive.mode, vertices, base, [](std::uint64_t i) { return i; });
      return;
    }
    const std::vector<std::uint32_t> indices = read_indices(source, primitive.indices);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] >= vertices) {
        throw InputError(source.file, fmt::format("{}: accessors[{}]: element {} is vertex {}, wanted less than {}", at,
                                                  primitive.indices, i, indices[i], vertices));
      }
    }
    append_corners(primitive.mode, indices.size(), base, [&](std::uint64_t i) { return indices[i]; });
  }

 private:
  void check_positions(std::size_t base, const std::string& at, const char* when) const {
    for (std::size_t i = base; i < mesh.positions.size(); ++i) {
      const std::string fault = non_finite(mesh.positions[i], i - base);
      if (!fault.empty()) throw InputError(source.file, fmt::format("{}.attributes.POSITION: {}{}", at, fault, when));
    }
  }

  template <class Corner>
  void append_corners(int mode, std::uint64_t count, std::size_t base, const Corner& corner) {
    const auto add = [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
      mesh.triangles.emplace_back(base + corner(a), base + corner(b), base + corner(c));
    };
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      for (std::uint64_t i = 0; i + 2 < count; i += 3) add(i, i + 1, i + 2);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      for (std::uint64_t i = 0; i + 2 < count; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
    } else {
      for (std::uint64_t i = 0; i + 2 < count; ++i) add(i + 1, i + 2, 0);
    }
  }

  const GltfSource& source;
  Mesh& mesh;
};

Mesh assemble(const tinygltf::Model& model, const std::string& path) {
  const GltfSource source{model, path};
  const std::vector<MeshInstance> instances = place_meshes(source);
  const auto for_each_primitive = [&](const auto& act) {
    for (const MeshInstance& instance : instances) {
      const auto& primitives = model.meshes[instance.mesh].primitives;
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        act(primitives[i], instance, fmt::format("meshes[{}].primitives[{}]", instance.mesh, i));
      }
    }
  };
  Size total;
  for_each_primitive([&](const tinygltf::Primitive& primitive, const MeshInstance&, const std::string& at) {
    const Size size = checked_size(source, primitive, at);
    total.triangles += size.triangles;
    total.vertices += size.vertices;
    check_size(total.triangles, total.vertices, path);
  });

  Mesh mesh;
  mesh.positions.reserve(total.vertices);
  mesh.triangles.reserve(total.triangles);
  TriangleBuilder builder(source, mesh);
  for_each_primitive([&](const tinygltf::Primitive& primitive, const MeshInstance& instance, const std::string& at) {
    if (makes_triangles(primitive)) builder.append(primitive, instance, at);
  });
  return mesh;
}

}  // namespace

Mesh read_glb(const std::string& path) {
  tinygltf::Model model;
  {
    std::string bytes = read_file(path);
    if (bytes.size() > 0xffffffffu)
      throw InputError(path, fmt::format("{} bytes, wanted less than 4 GiB", bytes.size()));
    reduce_glb(bytes, path);
    std::string error;
    std::string warning;
    if (!make_loader().LoadBinaryFromMemory(&model, &error, &warning,
                                            reinterpret_cast<const unsigned char*>(bytes.data()),
                                            static_cast<unsigned>(bytes.size()), folder_of(path))) {
      throw InputError(path, one_line(error));
    }
  }
  return assemble(model, path);
}

Mesh read_gltf(const std::string& path) {
  tinygltf::Model model;
  {
    const std::string json = geometry_json(read_file(path), path, false);
    if (json.size() > 0xffffffffu)
      throw InputError(path, fmt::format("{} bytes of JSON, wanted less than 4 GiB", json.size()));
    std::string error;
    std::string warning;
    if (!make_loader().LoadASCIIFromString(&model, &error, &warning, json.data(), static_cast<unsigned>(json.size()),
                                           folder_of(path))) {
      throw InputError(path, one_line(error));
    }
  }
  return assemble(model, path);
}

}  // namespace cbvh::golden
