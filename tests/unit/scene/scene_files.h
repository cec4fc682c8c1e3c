// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "golden/input_error.h"
#include "golden/scene/load.h"

namespace cbvh::golden {

/// A folder that is gone at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    // Memory, where there is such a folder: the corruption tests write thousands of files.
    const std::filesystem::path memory = "/dev/shm";
    const auto parent = access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
    std::string pattern = (parent / "cbvh_scene_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return (folder / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  std::filesystem::path folder;
};

/// What load_scene says about a bad scene, without the folder before the file's name.
inline std::string error_of(const std::string& spec) {
  try {
    load_scene(spec);
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), text.npos) << text;
    const std::string folder = std::filesystem::path(spec).parent_path().string() + "/";
    return text.starts_with(folder) ? text.substr(folder.size()) : text;
  }
  return "no error";
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

/// Floats where reading goes wrong first: both zeros, subnormals, the extremes, and numbers of all 24 bits.
inline std::vector<glm::vec3> difficult_positions() {
  return {{0.0f, -0.0f, 0x1p-149f},
          {-0x1p-149f, 0x1.fffffcp-127f, 0x1p-126f},
          {0x1.fffffep127f, -0x1.fffffep127f, 1.0f},
          {0x1.000002p0f, -0x1.fffffep-1f, 0.1f},
          {16777217.0f, 1.0f / 3.0f, -2.5e-7f},
          {123456.789f, 9.9999998e-5f, 1e10f}};
}

inline bool same_bits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  return bytes_of(a) == bytes_of(b);
}

using Triangles = std::vector<glm::uvec3>;

}  // namespace cbvh::golden
