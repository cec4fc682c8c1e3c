// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/gltf_json.h"

#include <nlohmann/json.hpp>
#include <set>

#include "golden/input_error.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

using Json = nlohmann::json;

constexpr int kMaxDepth = 64;                      // geometry nests 6 levels; the rest is room for extras
constexpr std::uint32_t kMaxInteger = 0x7fffffff;  // tinygltf keeps most integers as int
constexpr std::int64_t kMaxBufferBytes = std::int64_t{1} << 32;

/// Extensions that change how things look, not where they are.
bool leaves_geometry_alone(const std::string& extension) {
  for (const char* prefix : {"KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_", "MSFT_texture_"}) {
    if (extension.starts_with(prefix)) return true;
  }
  return false;
}

/// A parser's callback could check the depth too, but nlohmann's callback parser takes quadratic time.
void check_depth(std::string_view text, const std::string& file) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      in_string = !in_string;
    } else if (in_string) {
      if (c == '\\') ++i;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxDepth) throw InputError(file, fmt::format("JSON: nested more than {} levels deep", kMaxDepth));
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
}

void drop_members(Json& value, const std::set<std::string>& names) {
  if (value.is_object()) {
    for (const std::string& name : names) value.erase(name);
  }
  if (value.is_structured()) {
    for (Json& part : value) drop_members(part, names);
  }
}

Json parse_geometry(std::string_view text, const std::string& file) {
  check_depth(text, file);
  try {
    Json json = Json::parse(text.begin(), text.end());
    if (!json.is_object()) throw InputError(file, "JSON: wanted an object");
    Json geometry = Json::object();
    for (const char* section :
         {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers", "extensionsRequired"}) {
      if (const auto it = json.find(section); it != json.end()) geometry[section] = std::move(*it);
    }
    drop_members(geometry, {"extras", "extensions", "targets", "weights", "name"});
    return geometry;
  } catch (const Json::exception& error) {
    throw InputError(file, one_line(error.what()));
  }
}

class Checker {
 public:
  Checker(const Json& root, const std::string& file_name) : json(root), file(file_name) {}

  void check_all(bool is_binary) const {
    check_asset();
    check_extensions();
    integer(json, "scene", "");
    each("scenes", [&](const Json& o, const std::string& at) { indices(o, "nodes", at); });
    each("nodes", [&](const Json& o, const std::string& at) { check_node(o, at); });
    each("meshes", [&](const Json& o, const std::string& at) { check_mesh_object(o, at); });
    each("accessors", [&](const Json& o, const std::string& at) { check_accessor(o, at); });
    each("bufferViews", [&](const Json& o, const std::string& at) {
      integers(o, {"buffer", "byteOffset", "byteLength", "byteStride"}, at);
    });
    check_buffers(is_binary);
  }

 private:
  [[noreturn]] void fail(const std::string& at, const std::string& what) const {
    throw InputError(file, at.empty() ? what : at + ": " + what);
  }

  void integer(const Json& object, const char* key, const std::string& at) const {
    if (const auto it = object.find(key); it != object.end()) integer_value(*it, key, at);
  }

  void integer_value(const Json& value, const char* key, const std::string& at) const {
    // What the parser reads as a signed integer is negative.
    if (value.is_number_unsigned() && value.get<std::uint64_t>() <= kMaxInteger) return;
    fail(at, fmt::format("{}: found {}, wanted an integer from 0 to {}", key, shown(value), kMaxInteger));
  }

  void integers(const Json& object, std::initializer_list<const char*> keys, const std::string& at) const {
    for (const char* key : keys) integer(object, key, at);
  }

  void indices(const Json& object, const char* key, const std::string& at) const {
    const auto it = object.find(key);
    if (it == object.end()) return;
    if (!it->is_array()) fail(at, fmt::format("{}: found {}, wanted an array", key, shown(*it)));
    for (const Json& entry : *it) integer_value(entry, key, at);
  }

  void numbers(const Json& object, const char* key, std::size_t count, const std::string& at) const {
    const auto it = object.find(key);
    if (it == object.end()) return;
    bool good = it->is_array() && it->size() == count;
    for (std::size_t i = 0; good && i < count; ++i) good = (*it)[i].is_number();
    if (!good) fail(at, fmt::format("{}: found {}, wanted an array of {} numbers", key, shown(*it), count));
  }

  template <class Check>
  void each(const char* section, const Check& check) const {
    if (json.contains(section)) each_of(json[section], section, check);
  }

  template <class Check>
  void each_of(const Json& array, const std::string& at, const Check& check) const {
    if (!array.is_array()) fail(at, fmt::format("found {}, wanted an array", shown(array)));
    for (std::size_t i = 0; i < array.size(); ++i) {
      const std::string entry = fmt::format("{}[{}]", at, i);
      if (!array[i].is_object()) fail(entry, fmt::format("found {}, wanted an object", shown(array[i])));
      check(array[i], entry);
    }
  }

  void check_asset() const {
    if (!json.contains("asset") || !json["asset"].is_object()) fail("asset", "missing");
    const auto version = json["asset"].find("version");
    if (version == json["asset"].end() || !version->is_string()) fail("asset.version", "missing");
    if (!version->get_ref<const std::string&>().starts_with("2.")) {
      fail("asset.version", fmt::format("found {}, wanted 2.x", shown(*version)));
    }
  }

  void check_extensions() const {
    if (!json.contains("extensionsRequired")) return;
    const Json& required = json["extensionsRequired"];
    if (!required.is_array()) fail("extensionsRequired", fmt::format("found {}, wanted an array", shown(required)));
    for (const Json& name : required) {
      if (!name.is_string() || !leaves_geometry_alone(name.get_ref<const std::string&>())) {
        fail("extensionsRequired", fmt::format("{} is not supported", shown(name)));
      }
    }
  }

  void check_node(const Json& node, const std::string& at) const {
    integer(node, "mesh", at);
    indices(node, "children", at);
    numbers(node, "matrix", 16, at);
    numbers(node, "translation", 3, at);
    numbers(node, "rotation", 4, at);
    numbers(node, "scale", 3, at);
  }

  void check_mesh_object(const Json& mesh, const std::string& at) const {
    if (!mesh.contains("primitives")) fail(at, "primitives: missing");
    each_of(mesh["primitives"], at + ".primitives", [&](const Json& primitive, const std::string& place) {
      integers(primitive, {"indices", "mode", "material"}, place);
      const auto attributes = primitive.find("attributes");
      if (attributes == primitive.end() || !attributes->is_object()) fail(place, "attributes: missing");
      for (const auto& [key, value] : attributes->items()) integer(*attributes, key.c_str(), place + ".attributes");
    });
  }

  void check_accessor(const Json& accessor, const std::string& at) const {
    integers(accessor, {"bufferView", "byteOffset", "componentType", "count"}, at);
    if (!accessor.contains("sparse")) return;
    const Json& sparse = accessor["sparse"];
    if (!sparse.is_object()) fail(at, "sparse: wanted an object");
    integer(sparse, "count", at + ".sparse");
    for (const char* part : {"indices", "values"}) {
      if (!sparse.contains(part) || !sparse[part].is_object()) fail(at + ".sparse", fmt::format("{}: missing", part));
      integers(sparse[part], {"bufferView", "byteOffset", "componentType"}, at + ".sparse." + part);
    }
  }

  void check_buffers(bool is_binary) const {
    std::int64_t total_bytes = 0;
    bool is_first = true;
    each("buffers", [&](const Json& buffer, const std::string& at) {
      integer(buffer, "byteLength", at);
      if (!buffer.contains("byteLength")) fail(at, "byteLength: missing");
      if (buffer["byteLength"] == 0) fail(at, "byteLength: found 0, wanted 1 or more");
      total_bytes += buffer["byteLength"].get<std::int64_t>();
      if (total_bytes > kMaxBufferBytes)
        fail(at, fmt::format("byteLength: the buffers together exceed {} bytes", kMaxBufferBytes));
      const auto uri = buffer.find("uri");
      if (uri == buffer.end()) {
        if (!is_binary || !is_first) fail(at, "uri: missing");
      } else if (!uri->is_string() || uri->get_ref<const std::string&>().size() > kMaxInteger) {
        fail(at, fmt::format("uri: found {}, wanted a string", shown(*uri)));
      }
      is_first = false;
    });
  }

  static std::string shown(const Json& value) {
    if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
    if (value.is_structured()) return fmt::format("an {} of {}", value.type_name(), value.size());
    return value.dump();
  }

  const Json& json;
  const std::string& file;
};

}  // namespace

std::string geometry_json(std::string_view text, const std::string& file, bool is_binary) {
  const Json json = parse_geometry(text, file);
  Checker(json, file).check_all(is_binary);
  return json.dump();
}

}  // namespace cbvh::golden
