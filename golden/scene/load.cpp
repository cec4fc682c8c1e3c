// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/load.h"

#include <filesystem>
#include <new>

#include "golden/input_error.h"
#include "golden/scene/gltf_file.h"
#include "golden/scene/mesh_check.h"
#include "golden/scene/obj_file.h"
#include "golden/scene/ply_file.h"
#include "golden/scene/procedural/procedural.h"
#include "golden/scene/read_file.h"
#include "golden/scene/rotate.h"

namespace cbvh::golden {
namespace {

constexpr std::string_view kProcedural = "proc:";
constexpr std::string_view kRotated = "rotated:";

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

Mesh read_scene(const std::string& spec) {
  if (spec.starts_with(kRotated)) {
    Mesh mesh = rotated(load_scene(spec.substr(kRotated.size())));
    mesh.name = std::string(kRotated) + mesh.name;
    return mesh;
  }
  if (spec.starts_with(kProcedural)) return make_procedural_scene(spec, spec.substr(kProcedural.size()));
  const std::filesystem::path path(spec);
  const std::string extension = lower_case(path.extension().string());
  Mesh mesh;
  if (extension == ".glb") {
    mesh = read_glb(spec);
  } else if (extension == ".gltf") {
    mesh = read_gltf(spec);
  } else if (extension == ".obj") {
    mesh = read_obj(spec);
  } else if (extension == ".ply") {
    mesh = read_ply(spec);
  } else {
    throw InputError(spec, fmt::format("extension: found {}, wanted .glb, .gltf, .obj, .ply, or a scene 'proc:NAME'",
                                       extension.empty() ? "none" : in_quotes(extension)));
  }
  mesh.name = path.stem().string();
  return mesh;
}

}  // namespace

Mesh load_scene(const std::string& spec) {
  try {
    Mesh mesh = read_scene(spec);
    if (spec.starts_with(kProcedural)) mesh.name = spec;
    check_mesh(mesh, spec);
    return mesh;
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw InputError(spec, "needs more memory than there is");
  } catch (const std::exception& error) {
    throw InputError(spec, one_line(error.what()));
  }
}

}  // namespace cbvh::golden
