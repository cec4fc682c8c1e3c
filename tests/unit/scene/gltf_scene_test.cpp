// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "gltf_builder.h"

namespace cbvh::golden {
namespace {

const Triangles kTwo = {{0, 1, 2}, {0, 2, 3}};

Mesh load(const GltfBuilder& builder) { return load_scene(TemporaryFolder().write("s.glb", builder.glb())); }

std::string error(const GltfBuilder& builder) { return error_of(TemporaryFolder().write("s.glb", builder.glb())); }

/// A single mesh with one primitive that draws `count` non-indexed points in the mode.
GltfBuilder strip_of(int mode, std::size_t count) {
  GltfBuilder b;
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < count; ++i) points.emplace_back(i, i * i, 0);
  b.mesh({GltfBuilder::primitive(b.positions(points), -1, mode)});
  b.nodes = {R"({"mesh":0})"};
  return b;
}

TEST(GltfScene, positions_and_triangle_order_survive_bit_for_bit) {
  GltfBuilder b;
  const int p = b.positions(difficult_positions());
  b.mesh({GltfBuilder::primitive(p, b.indices<std::uint32_t>({5, 4, 3, 0, 1, 2, 2, 2, 2, 0, 1, 2}))});
  b.nodes = {R"({"mesh":0,"translation":[0,0,0],"scale":[1,1,1],"rotation":[0,0,0,1]})"};
  const Mesh mesh = load(b);
  EXPECT_TRUE(same_bits(mesh.positions, difficult_positions()));
  EXPECT_EQ(mesh.triangles, (Triangles{{5, 4, 3}, {0, 1, 2}, {2, 2, 2}, {0, 1, 2}}));
  EXPECT_EQ(mesh.name, "s");
}

TEST(GltfScene, indices_may_have_8_16_or_32_bits_or_be_absent) {
  const std::vector<glm::vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto with = [&](auto indices) {
    GltfBuilder b;
    const int p = b.positions(square);
    b.mesh({GltfBuilder::primitive(p, b.indices(indices))});
    b.nodes = {R"({"mesh":0})"};
    return load(b).triangles;
  };
  EXPECT_EQ(with(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}), kTwo);
  EXPECT_EQ(with(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}), kTwo);
  EXPECT_EQ(with(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}), kTwo);
  EXPECT_EQ(load(strip_of(4, 6)).triangles, (Triangles{{0, 1, 2}, {3, 4, 5}}));
}

TEST(GltfScene, strips_and_fans_become_triangles_as_the_specification_orders_them) {
  EXPECT_EQ(load(strip_of(5, 6)).triangles, (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}));
  EXPECT_EQ(load(strip_of(6, 5)).triangles, (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST(GltfScene, points_and_lines_are_skipped) {
  GltfBuilder b = two_triangles();
  b.meshes.clear();
  b.mesh({GltfBuilder::primitive(0, -1, 0), GltfBuilder::primitive(0, -1, 3), GltfBuilder::primitive(0, 1)});
  EXPECT_EQ(load(b).triangles, kTwo);
  for (int mode = 0; mode < 4; ++mode) EXPECT_EQ(error(strip_of(mode, 6)), "s.glb: no triangles");
  EXPECT_EQ(error(strip_of(7, 6)), "s.glb: meshes[0].primitives[0].mode: found 7, wanted 0 to 6");
}

TEST(GltfScene, several_meshes_and_primitives_come_in_depth_first_order) {
  GltfBuilder b;
  const int p = b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int q = b.positions({{5, 5, 5}, {6, 5, 5}, {5, 6, 5}});
  b.mesh({GltfBuilder::primitive(p), GltfBuilder::primitive(q)});
  b.mesh({GltfBuilder::primitive(q)});
  b.nodes = {R"({"children":[2,1]})", R"({"mesh":1})", R"({"mesh":0,"children":[3]})",
             R"({"mesh":1,"translation":[0,0,1]})"};
  const Mesh mesh = load(b);
  ASSERT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}}));
  EXPECT_EQ(mesh.positions[0], glm::vec3(0, 0, 0));
  EXPECT_EQ(mesh.positions[3], glm::vec3(5, 5, 5));
  EXPECT_EQ(mesh.positions[6], glm::vec3(5, 5, 6));  // node 3, below node 2
  EXPECT_EQ(mesh.positions[9], glm::vec3(5, 5, 5));
}

TEST(GltfScene, matrix_and_its_translation_rotation_scale_place_a_mesh_alike_and_nest) {
  GltfBuilder b;
  b.mesh({GltfBuilder::primitive(b.positions({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}))});
  // A quarter turn about z after doubling, then moved. 0.5 and its square root's square are exact enough: all results
  // are integers.
  const std::string parts = R"({"mesh":0,"translation":[10,20,30],"rotation":[0,0,1,0],"scale":[2,2,2]})";
  const std::string matrix = R"({"mesh":0,"matrix":[-2,0,0,0, 0,-2,0,0, 0,0,2,0, 10,20,30,1]})";
  const std::vector<glm::vec3> wanted = {{8, 20, 30}, {10, 18, 30}, {10, 20, 32}};
  b.nodes = {parts};
  EXPECT_EQ(load(b).positions, wanted);
  b.nodes = {matrix};
  EXPECT_EQ(load(b).positions, wanted);
  b.nodes = {R"({"translation":[1,0,0],"scale":[1,1,2],"children":[1]})", matrix};
  EXPECT_EQ(load(b).positions, (std::vector<glm::vec3>{{9, 20, 60}, {11, 18, 60}, {11, 20, 64}}));
}

TEST(GltfScene, only_the_default_scene_is_loaded_and_the_first_when_none_is_named) {
  GltfBuilder b = two_triangles();
  b.mesh({GltfBuilder::primitive(0, 1), GltfBuilder::primitive(0, 1)});
  b.nodes.push_back(R"({"mesh":1})");
  b.scenes = R"("scenes":[{"nodes":[0]},{"nodes":[1]}],"scene":1)";
  EXPECT_EQ(load(b).triangles.size(), 4u);
  b.scenes = R"("scenes":[{"nodes":[0]},{"nodes":[1]}])";
  EXPECT_EQ(load(b).triangles.size(), 2u);
  b.scenes = R"("scenes":[{"nodes":[0]},{"nodes":[1]}],"scene":2)";
  EXPECT_EQ(error(b), "s.glb: scene: found 2, wanted less than 2");
}

TEST(GltfScene, without_a_scene_all_root_nodes_and_then_all_unplaced_meshes_are_loaded) {
  GltfBuilder b = two_triangles();
  b.scenes = "";
  EXPECT_EQ(load(b).triangles, kTwo);
  b.nodes.clear();
  EXPECT_EQ(load(b).triangles, kTwo);
  b.mesh({GltfBuilder::primitive(0, 1)});
  b.nodes = {R"({"mesh":1,"translation":[7,0,0]})"};
  const Mesh mesh = load(b);
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.positions[0], glm::vec3(7, 0, 0));
  EXPECT_EQ(mesh.positions[4], glm::vec3(0, 0, 0));
}

TEST(GltfScene, buffers_may_be_embedded_external_or_the_binary_chunk) {
  const TemporaryFolder folder;
  const GltfBuilder b = two_triangles();
  const std::vector<glm::vec3> wanted = load(b).positions;
  EXPECT_EQ(load_scene(folder.write("embedded.gltf", b.gltf())).positions, wanted);
  folder.write("part one.bin", b.buffer);
  const Mesh external = load_scene(folder.write("external.gltf", b.json(R"(,"uri":"part%20one.bin")")));
  EXPECT_EQ(external.positions, wanted);
  EXPECT_EQ(external.triangles, kTwo);
  EXPECT_EQ(
      load_scene(folder.write("external.glb", GltfBuilder::glb_of(b.json(R"(,"uri":"part%20one.bin")"), ""))).positions,
      wanted);
}

TEST(GltfScene, interleaved_vertices_and_offsets_are_followed) {
  GltfBuilder b;
  const std::vector<float> data = {9, 0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0};  // an unused float before each position
  const int view = b.view(bytes_of(data), R"(,"byteStride":16)");
  b.mesh({GltfBuilder::primitive(b.accessor(view, 5126, 3, "VEC3", R"(,"byteOffset":4)"))});
  b.nodes = {R"({"mesh":0})"};
  EXPECT_EQ(load(b).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

std::string sparse(int count, int indices, int index_type, int values) {
  return fmt::format(
      R"(,"sparse":{{"count":{},"indices":{{"bufferView":{},"componentType":{}}},"values":{{"bufferView":{}}}}})",
      count, indices, index_type, values);
}

TEST(GltfScene, sparse_accessors_replace_elements_of_positions_and_of_indices) {
  GltfBuilder b;
  const int base = b.view(bytes_of(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  const int which = b.view(bytes_of(std::vector<std::uint8_t>{0, 2}));
  const int values = b.view(bytes_of(std::vector<glm::vec3>{{7, 7, 7}, {8, 8, 8}}));
  const int p = b.accessor(base, 5126, 3, "VEC3", sparse(2, which, 5121, values));
  const int from = b.view(bytes_of(std::vector<std::uint16_t>{0, 1, 2}));
  const int last = b.view(bytes_of(std::vector<std::uint32_t>{2}));
  const int corner = b.view(bytes_of(std::vector<std::uint16_t>{1}));
  b.mesh({GltfBuilder::primitive(p, b.accessor(from, 5123, 3, "SCALAR", sparse(1, last, 5125, corner)))});
  b.nodes = {R"({"mesh":0})"};
  const Mesh mesh = load(b);
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{7, 7, 7}, {1, 0, 0}, {8, 8, 8}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 1}}));

  b.accessors[0] = fmt::format(R"({{"componentType":5126,"count":3,"type":"VEC3"{}}})", sparse(2, which, 5121, values));
  EXPECT_EQ(load(b).positions, (std::vector<glm::vec3>{{7, 7, 7}, {0, 0, 0}, {8, 8, 8}}));  // no bufferView: zeros
}

TEST(GltfScene, sparse_indices_must_increase_and_lie_in_the_accessor) {
  for (const auto& bad : {std::vector<std::uint8_t>{2, 2}, {2, 0}, {0, 3}}) {
    GltfBuilder b;
    const int base = b.view(std::string(36, '\0'));
    const int which = b.view(bytes_of(bad));
    b.mesh({GltfBuilder::primitive(
        b.accessor(base, 5126, 3, "VEC3", sparse(2, which, 5121, b.view(std::string(24, '\0')))))});
    b.nodes = {R"({"mesh":0})"};
    EXPECT_EQ(
        error(b),
        fmt::format("s.glb: accessors[0]: sparse.indices: entry 1 is {}, wanted increasing numbers below 3", bad[1]));
  }
}

TEST(GltfScene, optional_extensions_extras_and_images_are_not_looked_at) {
  GltfBuilder b = two_triangles();
  std::string deep = "0";
  for (int i = 0; i < 40; ++i) deep = "[" + deep + "]";
  b.more = R"("extensionsUsed":["KHR_draco_mesh_compression"],"images":[{"uri":"none.png"}],"extras":)" + deep + ",";
  b.nodes = {R"({"mesh":0,"extras":{"a":[]},"extensions":{"X":{}}})"};
  EXPECT_EQ(load(b).triangles, kTwo);
  b.more = R"("extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"],)";
  EXPECT_EQ(load(b).triangles, kTwo);
}

TEST(GltfScene, required_extensions_of_geometry_are_refused_by_name) {
  for (const char* name :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization", "EXT_mesh_gpu_instancing"}) {
    GltfBuilder b = two_triangles();
    b.more = fmt::format(R"("extensionsRequired":["{}"],)", name);
    EXPECT_EQ(error(b), fmt::format("s.glb: extensionsRequired: '{}' is not supported", name));
  }
}

TEST(GltfScene, a_bad_container_is_named_with_its_offset) {
  const TemporaryFolder folder;
  const std::string good = two_triangles().glb();
  const auto with = [&](std::size_t offset, const std::string& bytes) {
    return error_of(folder.write("s.glb", std::string(good).replace(offset, bytes.size(), bytes)));
  };
  EXPECT_EQ(with(0, "glXF"), "s.glb:offset 0: magic: found 'glXF', wanted 'glTF'");
  EXPECT_EQ(with(4, "\x01"), "s.glb:offset 4: version: found 1, wanted 2");
  EXPECT_EQ(error_of(folder.write("s.glb", good + "x")),
            fmt::format("s.glb:offset 8: length: found {}, wanted the file's {} bytes", good.size(), good.size() + 1));
  EXPECT_EQ(with(14, "\x01"),
            fmt::format("s.glb:offset 12: JSON chunk: length {}, but {} bytes follow",
                        65536 + *reinterpret_cast<const std::uint16_t*>(good.data() + 12), good.size() - 20));
  EXPECT_EQ(with(16, "NOSJ"), "s.glb:offset 12: JSON chunk: type 0x4a534f4e, wanted 0x4e4f534a");
  EXPECT_EQ(error_of(folder.write("s.glb", "")), "s.glb: GLB header: found 0 bytes, wanted 12");
  EXPECT_EQ(
      with(20, "["),
      "s.glb: [json.exception.parse_error.101] parse error at line 1, column 9: syntax error while parsing array - "
      "unexpected ':'; expected ']'");
}

/// Replaces in the JSON of two_triangles and gives the error.
std::string error_with(const std::string& what, const std::string& by) {
  const GltfBuilder b = two_triangles();
  std::string json = b.json("");
  const std::size_t at = json.find(what);
  EXPECT_NE(at, json.npos) << what << " is not in " << json;
  json.replace(at, what.size(), by);
  return error_of(TemporaryFolder().write("s.glb", GltfBuilder::glb_of(json, b.buffer)));
}

TEST(GltfScene, references_and_types_are_checked_and_named) {
  EXPECT_EQ(error_with(R"("POSITION":0)", R"("POSITION":9)"),
            "s.glb: meshes[0].primitives[0].attributes.POSITION: accessor 9, wanted less than 2");
  EXPECT_EQ(error_with(R"("POSITION")", R"("POSITIOM")"),
            "s.glb: meshes[0].primitives[0].attributes: POSITION is missing");
  EXPECT_EQ(error_with(R"("POSITION":0)", R"("POSITION":-1)"),
            "s.glb: meshes[0].primitives[0].attributes: POSITION: found -1, wanted an integer from 0 to 2147483647");
  EXPECT_EQ(
      error_with(R"("POSITION":0)", R"("POSITION":4294967296)"),
      "s.glb: meshes[0].primitives[0].attributes: POSITION: found 4294967296, wanted an integer from 0 to 2147483647");
  EXPECT_EQ(
      error_with("5126", "5123"),
      "s.glb: accessors[0]: componentType and type: found 5123 and 3, wanted 5126 (FLOAT) and VEC3 for positions");
  EXPECT_EQ(error_with("5123", "5122"),
            "s.glb: accessors[1]: componentType: found 5122, wanted 5121, 5123 or 5125 (unsigned byte, short or int)");
  EXPECT_EQ(error_with("SCALAR", "VEC2"), "s.glb: accessors[1]: type: wanted SCALAR for indices");
  EXPECT_EQ(error_with(R"("bufferView":0)", R"("bufferView":2)"),
            "s.glb: accessors[0]: bufferView: found 2, wanted less than 2");
  EXPECT_EQ(error_with(R"("buffer":0)", R"("buffer":1)"), "s.glb: bufferViews[0].buffer: found 1, wanted less than 1");
  EXPECT_EQ(error_with(R"("byteLength":48)", R"("byteLength":61)"),
            "s.glb: bufferViews[0]: bytes 0 to 61 lie outside buffers[0] of 60 bytes");
  EXPECT_EQ(error_with(R"("byteOffset":0)", R"("byteOffset":2)"),
            "s.glb: accessors[0]: byteOffset: offset 2 in the buffer, wanted a multiple of 4");
  EXPECT_EQ(error_with(R"("byteOffset":0)", R"("byteOffset":"0")"),
            "s.glb: bufferViews[0]: byteOffset: found '0', wanted an integer from 0 to 2147483647");
  EXPECT_EQ(error_with(R"("mesh":0)", R"("mesh":1)"), "s.glb: nodes[0].mesh: found 1, wanted less than 1");
  EXPECT_EQ(error_with(R"("nodes":[0])", R"("nodes":[3])"), "s.glb: scenes[0].nodes: node 3, wanted less than 1");
  EXPECT_EQ(error_with(R"("mesh":0)", R"("mesh":0,"scale":[1,2])"),
            "s.glb: nodes[0]: scale: found an array of 2, wanted an array of 3 numbers");
  EXPECT_EQ(error_with(R"("mesh":0)", R"("mesh":0,"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1])"),
            "s.glb: nodes[0].matrix: wanted a last row of 0 0 0 1");
  EXPECT_EQ(error_with("2.0", "1.0"), "s.glb: asset.version: found '1.0', wanted 2.x");
  EXPECT_EQ(error_with(R"("buffers":[)", R"("buffers":[{"byteLength":4},)"), "s.glb: buffers[1]: uri: missing");
}

TEST(GltfScene, an_index_beyond_the_vertices_is_named) {
  GltfBuilder b;
  const int p = b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  b.mesh({GltfBuilder::primitive(p, b.indices<std::uint8_t>({0, 1, 2, 0, 3, 2}))});
  b.nodes = {R"({"mesh":0})"};
  EXPECT_EQ(error(b), "s.glb: meshes[0].primitives[0]: accessors[1]: element 4 is vertex 3, wanted less than 3");
}

TEST(GltfScene, a_number_of_corners_that_makes_no_triangles_is_named) {
  EXPECT_EQ(error(strip_of(4, 5)), "s.glb: meshes[0].primitives[0]: 5 corners, wanted a multiple of 3");
  EXPECT_EQ(error(strip_of(5, 2)), "s.glb: meshes[0].primitives[0]: 2 corners, wanted 3 or more");
}

TEST(GltfScene, positions_that_are_not_finite_are_named_before_and_after_the_transform) {
  GltfBuilder b;
  b.mesh({GltfBuilder::primitive(b.positions({{0, 0, 0}, {1, NAN, 0}, {0, 1, 0}}))});
  b.nodes = {R"({"mesh":0})"};
  EXPECT_EQ(error(b), "s.glb: meshes[0].primitives[0].attributes.POSITION: vertex 1: y is NaN, wanted a finite number");
  b = strip_of(4, 3);
  b.nodes = {R"({"mesh":0,"scale":[1e39,1,1]})"};
  EXPECT_EQ(error(b),
            "s.glb: meshes[0].primitives[0].attributes.POSITION: vertex 1: x is infinite, wanted a finite number after "
            "its node's transform");
}

TEST(GltfScene, a_tiny_file_cannot_ask_for_much_memory) {
  GltfBuilder b = two_triangles();
  b.accessors[0] = R"({"bufferView":0,"componentType":5126,"count":2147483646,"type":"VEC3"})";
  EXPECT_EQ(error(b),
            "s.glb: accessors[0]: count: 2147483646 elements need 25769803752 bytes of bufferViews[0], which has 48");
  b.accessors[0] = R"({"componentType":5126,"count":2147483646,"type":"VEC3"})";
  EXPECT_EQ(error(b), "s.glb: accessors[0]: count: found 2147483646 without a bufferView, wanted at most 65536");
}

TEST(GltfScene, more_than_2_to_the_27_triangles_are_refused_before_they_are_made) {
  GltfBuilder b;
  const int p = b.positions({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const int i = b.accessor(b.view(std::string((1 << 21) + 2, '\0')), 5121, (1 << 21) + 2, "SCALAR");
  b.mesh(std::vector<std::string>(65, GltfBuilder::primitive(p, i, 5)));
  b.nodes = {R"({"mesh":0})"};
  EXPECT_EQ(error(b), "s.glb: triangles: found 136314880, wanted at most 2^27 = 134217728");
}

TEST(GltfScene, cycles_and_shared_children_are_refused_and_depth_is_no_limit) {
  GltfBuilder b = two_triangles();
  b.nodes = {R"({"children":[1]})", R"({"children":[0]})"};
  EXPECT_EQ(error(b), "s.glb: nodes[1].children: node 0 is reached twice, wanted a tree");
  b.nodes = {R"({"mesh":0,"children":[0]})"};
  EXPECT_EQ(error(b), "s.glb: nodes[0].children: node 0 is reached twice, wanted a tree");
  b.nodes = {R"({"children":[1,2]})", R"({"children":[2]})", R"({"mesh":0})"};
  EXPECT_EQ(error(b), "s.glb: nodes[1].children: node 2 is reached twice, wanted a tree");
  b.nodes.clear();
  constexpr int kDepth = 100000;
  for (int i = 1; i < kDepth; ++i) b.nodes.push_back(fmt::format(R"({{"children":[{}]}})", i));
  b.nodes.push_back(R"({"mesh":0})");
  EXPECT_EQ(load(b).triangles, kTwo);
}

TEST(GltfScene, json_nested_absurdly_deep_is_refused) {
  GltfBuilder b = two_triangles();
  b.more = "\"extras\":" + std::string(1000000, '[') + ",";
  EXPECT_EQ(error(b), "s.glb: JSON: nested more than 64 levels deep");
}

TEST(GltfScene, a_missing_or_short_external_buffer_is_named) {
  const TemporaryFolder folder;
  const GltfBuilder b = two_triangles();
  const std::string scene = folder.write("s.gltf", b.json(R"(,"uri":"x.bin")"));
  EXPECT_EQ(error_of(scene), "x.bin: no such file");
  folder.write("x.bin", b.buffer.substr(1));
  EXPECT_EQ(error_of(scene),
            fmt::format("s.gltf: File size mismatch : {}, requestedBytes 60, but got 59", folder.path("x.bin")));
  std::filesystem::remove(folder.path("x.bin"));
  std::filesystem::create_directory(folder.path("x.bin"));
  EXPECT_EQ(error_of(scene), "x.bin: not a regular file");
  EXPECT_EQ(error_of(folder.write("t.gltf", b.json(""))), "t.gltf: buffers[0]: uri: missing");
}

}  // namespace
}  // namespace cbvh::golden
