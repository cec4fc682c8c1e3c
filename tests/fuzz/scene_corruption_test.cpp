// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include "golden/scene/mesh_check.h"
#include "tests/unit/scene/gltf_builder.h"

namespace cbvh::golden {
namespace {

struct Outcomes {
  std::uint64_t loaded = 0;
  std::uint64_t refused = 0;
};

/// Loads the bytes: a mesh must keep its promises, an error must be one line that begins with the file's name (or that
/// of a file beside it).
void try_scene(const TemporaryFolder& folder, const std::string& name, const std::string& bytes, Outcomes& outcomes) {
  const std::string path = folder.write(name, bytes);
  const auto start = std::chrono::steady_clock::now();
  try {
    const Mesh mesh = load_scene(path);
    check_mesh(mesh, path);
    ASSERT_LE(mesh.triangles.size(), bytes.size());
    ++outcomes.loaded;
  } catch (const InputError& error) {
    const std::string text = error.what();
    ASSERT_TRUE(text.starts_with(folder.path(""))) << text;
    ASSERT_EQ(text.find('\n'), text.npos) << text;
    ++outcomes.refused;
  }  // anything else fails the test
  ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

/// Every byte becomes each of several others, and the file ends at every length. Prints how to repeat a failure.
void corrupt(const std::string& name, const std::string& good) {
  const TemporaryFolder folder;
  Outcomes whole;
  try_scene(folder, name, good, whole);
  ASSERT_EQ(whole.loaded, 1u);
  Outcomes flipped;
  for (std::size_t i = 0; i < good.size(); ++i) {
    for (const unsigned mask :
         {0x01u, 0x02u, 0x10u, 0x80u, 0xffu, static_cast<unsigned char>(good[i]) ^ 0x39u}) {  // the last makes a '9'
      if (mask == 0) continue;
      std::string bad = good;
      bad[i] = static_cast<char>(static_cast<unsigned char>(bad[i]) ^ mask);
      SCOPED_TRACE(fmt::format("{}: byte {} ^ {:#x}", name, i, mask));
      try_scene(folder, name, bad, flipped);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  Outcomes truncated;
  for (std::size_t length = 0; length < good.size(); ++length) {
    SCOPED_TRACE(fmt::format("{}: cut to {} bytes", name, length));
    try_scene(folder, name, good.substr(0, length), truncated);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GE(flipped.loaded + flipped.refused, 5 * good.size());
  EXPECT_GT(flipped.refused, good.size());
  EXPECT_EQ(truncated.loaded + truncated.refused, good.size());
  EXPECT_GT(truncated.refused, good.size() / 2);
}

/// Transforms, two primitives, a strip, interleaving and a sparse accessor.
GltfBuilder rich_gltf() {
  GltfBuilder b = two_triangles();
  const int strip =
      b.accessor(b.view(std::string(64, '\x3e'), R"(,"byteStride":16)"), 5126, 4, "VEC3", R"(,"byteOffset":4)");
  const int which = b.view(bytes_of(std::vector<std::uint8_t>{1, 3}));
  const int values = b.view(bytes_of(std::vector<glm::vec3>{{7, 7, 7}, {8, 8, 8}}));
  b.accessors[0].pop_back();
  b.accessors[0] += fmt::format(
      R"(,"sparse":{{"count":2,"indices":{{"bufferView":{},"componentType":5121}},"values":{{"bufferView":{}}}}}}})",
      which, values);
  b.mesh({GltfBuilder::primitive(strip, -1, 5), GltfBuilder::primitive(0, 1)});
  b.nodes = {R"({"mesh":0,"children":[1]})", R"({"mesh":1,"rotation":[0,0,1,0],"translation":[1,2,3]})"};
  return b;
}

TEST(SceneCorruption, glb_loads_or_is_refused_whatever_byte_changes) { corrupt("s.glb", rich_gltf().glb()); }

TEST(SceneCorruption, gltf_loads_or_is_refused_whatever_byte_changes) { corrupt("s.gltf", rich_gltf().gltf()); }

TEST(SceneCorruption, obj_loads_or_is_refused_whatever_byte_changes) {
  corrupt("s.obj",
          "# a\nmtllib m.mtl\no b\nv 0 0 0\nv 1.5e2 -.25 +3\nv 0 1 0.125\r\nvn 0 0 1\nvt 0 0\nf 1 2 3\ng c\nv 1 1 1 "
          "0.5 0.5 0.5\nusemtl d\n"
          "f -1 -2 -3 -4\ns 1\nf 1/1/1 2/1/1 3//1\nl 1 2\n");
}

const std::string kPlyElements =
    " 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\nproperty list uchar "
    "float q\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty uchar flag\nend_header\n";

TEST(SceneCorruption, ascii_ply_loads_or_is_refused_whatever_byte_changes) {
  corrupt("s.ply", "ply\nformat ascii" + kPlyElements +
                       "0 0 0 0\n1.5e2 -.25 3 1 7\n0 1 0 0\n1 1 1 2 5 5\n3 0 1 2 9\n4 3 2 1 0 8\n");
}

TEST(SceneCorruption, binary_ply_loads_or_is_refused_whatever_byte_changes) {
  for (const bool is_big : {false, true}) {
    const auto raw = [&](auto value) {
      std::string bytes = bytes_of(std::vector<decltype(value)>{value});
      return is_big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    };
    std::string bytes =
        std::string("ply\nformat ") + (is_big ? "binary_big_endian" : "binary_little_endian") + kPlyElements;
    for (int i = 0; i < 4; ++i)
      bytes += raw(0.5f * static_cast<float>(i)) + raw(0.25 * i) + raw(static_cast<std::int16_t>(i * i)) + '\x01' +
               raw(1.0f);
    bytes += '\x03' + raw(0) + raw(1) + raw(2) + 'a' + '\x04' + raw(3) + raw(2) + raw(1) + raw(0) + 'b';
    corrupt("s.ply", bytes);
  }
}

}  // namespace
}  // namespace cbvh::golden
