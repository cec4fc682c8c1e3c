// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "scene_files.h"

#include <cstdlib>

namespace cbvh::golden {
namespace {

TEST(LoadScene, an_unknown_extension_is_refused_with_the_known_ones) {
  EXPECT_EQ(error_of("bunny.stl"),
            "bunny.stl: extension: found '.stl', wanted .glb, .gltf, .obj, .ply, or a scene 'proc:NAME'");
  EXPECT_EQ(error_of("bunny"), "bunny: extension: found none, wanted .glb, .gltf, .obj, .ply, or a scene 'proc:NAME'");
  EXPECT_EQ(error_of(""), ": extension: found none, wanted .glb, .gltf, .obj, .ply, or a scene 'proc:NAME'");
}

TEST(LoadScene, a_missing_file_a_folder_and_a_device_are_refused) {
  const TemporaryFolder folder;
  for (const char* extension : {".glb", ".gltf", ".obj", ".ply"}) {
    const std::string name = std::string("none") + extension;
    EXPECT_EQ(error_of(folder.path(name)), name + ": no such file");
    std::filesystem::create_directory(folder.path(name));
    EXPECT_EQ(error_of(folder.path(name)), name + ": not a regular file");
  }
  std::filesystem::create_symlink("/dev/zero", folder.path("zero.ply"));
  EXPECT_EQ(error_of(folder.path("zero.ply")), "zero.ply: not a regular file");
}

TEST(LoadScene, an_empty_file_is_refused) {
  const TemporaryFolder folder;
  for (const char* extension : {".glb", ".gltf", ".obj", ".ply"})
    EXPECT_NE(error_of(folder.write(std::string("e") + extension, "")), "no error");
}

TEST(LoadScene, extensions_are_known_in_capitals_too_and_the_stem_is_the_name) {
  const Mesh mesh = load_scene(TemporaryFolder().write("One.Triangle.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_EQ(mesh.name, "One.Triangle");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
}

/// CBVH_SCENES names a folder with the scenes of the papers, which are not ours to give away.
TEST(LoadScene, shared_scenes_load_bit_for_bit) {
  const char* const folder = std::getenv("CBVH_SCENES");
  if (folder == nullptr) GTEST_SKIP() << "CBVH_SCENES is not set";
  const std::pair<const char*, std::size_t> wanted[] = {
      {"bunny", 69451}, {"armadillo", 30000}, {"sponza", 33663}, {"dragon", 871414}};
  for (const auto& [name, triangles] : wanted) {
    const std::string path = std::string(folder) + "/" + name + ".glb";
    const Mesh mesh = load_scene(path);
    EXPECT_EQ(mesh.triangles.size(), triangles) << name;
    // These files end with the positions and then the indices, as they lie in memory.
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    EXPECT_TRUE(bytes.ends_with(bytes_of(mesh.positions) + bytes_of(mesh.triangles))) << name;
  }
}

}  // namespace
}  // namespace cbvh::golden
