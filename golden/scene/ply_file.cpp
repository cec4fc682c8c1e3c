// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "golden/scene/mesh_check.h"
#include "golden/scene/ply_cursor.h"
#include "golden/scene/ply_header.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

constexpr int kNotACoordinate = -1;

/// Reads the body an item at a time. Items are only believed in as they are found: a count in the header takes no
/// memory.
template <class Cursor>
class BodyReader {
 public:
  BodyReader(const PlyHeader& from, Cursor values, const std::string& file_name)
      : header(from), cursor(values), file(file_name) {}

  Mesh read() {
    for (const PlyElement& element : header.elements) {
      check_items_fit(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i)
          read_item(element, [&](const PlyProperty& property) { skip(property); });
      }
    }
    cursor.end_body();
    check_indices();
    return std::move(mesh);
  }

 private:
  /// An item takes at least a byte, so that the count is bounded by the file's size before anything is read or
  /// reserved.
  void check_items_fit(const PlyElement& element) const {
    if (element.count == 0) return;
    std::size_t least_bytes = 0;
    for (const PlyProperty& property : element.properties) {
      const bool is_ascii = header.format == PlyFormat::kAscii;
      least_bytes += is_ascii ? 1 : byte_count(property.is_list ? property.count_type : property.type);
    }
    if (least_bytes == 0)
      throw InputError(file, fmt::format("element {}: has items but no property", in_quotes(element.name)));
    if (element.count > cursor.bytes_left() / least_bytes) {
      throw InputError(cursor.place(),
                       fmt::format("element {}: {} items of at least {} bytes, but {} bytes follow",
                                   in_quotes(element.name), element.count, least_bytes, cursor.bytes_left()));
    }
  }

  template <class ReadProperty>
  void read_item(const PlyElement& element, const ReadProperty& read_property) {
    cursor.begin_item();
    for (const PlyProperty& property : element.properties) read_property(property);
    cursor.end_item();
  }

  void read_vertices(const PlyElement& element) {
    std::vector<int> axes;
    for (const PlyProperty& property : element.properties) {
      const std::size_t axis = std::string_view("xyz").find(property.name);
      const bool is_coordinate = property.name.size() == 1 && axis != std::string_view::npos && !property.is_list;
      axes.push_back(is_coordinate ? static_cast<int>(axis) : kNotACoordinate);
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (std::find(axes.begin(), axes.end(), axis) == axes.end()) {
        throw InputError(file, fmt::format("element 'vertex': property {} is missing", "xyz"[axis]));
      }
    }
    mesh.positions.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      glm::vec3 position(0.0f);
      std::size_t column = 0;
      read_item(element, [&](const PlyProperty& property) {
        if (const int axis = axes[column++]; axis != kNotACoordinate) {
          position[axis] = cursor.real(property.type);
        } else {
          skip(property);
        }
      });
      if (const std::string fault = non_finite(position, i); !fault.empty()) throw InputError(cursor.place(), fault);
      mesh.positions.push_back(position);
    }
  }

  static bool holds_corners(const PlyProperty& property) {
    return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  void read_faces(const PlyElement& element) {
    const auto corners = std::find_if(element.properties.begin(), element.properties.end(), holds_corners);
    if (corners == element.properties.end())
      throw InputError(file, "element 'face': wanted a property list vertex_indices or vertex_index");
    if (!is_integer(corners->type)) throw InputError(file, "element 'face': wanted vertex indices of an integer type");
    mesh.triangles.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      read_item(element, [&](const PlyProperty& property) {
        if (&property == &*corners) {
          read_polygon(property);
        } else {
          skip(property);
        }
      });
    }
  }

  void read_polygon(const PlyProperty& property) {
    const std::int64_t count = cursor.integer(property.count_type);
    if (count < 3)
      throw InputError(cursor.place(), fmt::format("{}: found {} corners, wanted 3 or more", property.name, count));
    const std::uint32_t first = read_corner(property);
    std::uint32_t previous = read_corner(property);
    for (std::int64_t i = 2; i < count; ++i) {
      const std::uint32_t corner = read_corner(property);
      mesh.triangles.emplace_back(first, previous, corner);
      previous = corner;
    }
    if (mesh.triangles.size() > kMaxTriangles) check_size(mesh.triangles.size(), 0, cursor.place());
  }

  std::uint32_t read_corner(const PlyProperty& property) {
    const std::int64_t index = cursor.integer(property.type);
    const bool is_known = has_vertices_before_faces();
    if (index < 0 || (is_known && static_cast<std::uint64_t>(index) >= mesh.positions.size())) {
      throw InputError(cursor.place(), fmt::format("{}: vertex {}, wanted 0 to {}", property.name, index,
                                                   static_cast<std::int64_t>(mesh.positions.size()) - 1));
    }
    return static_cast<std::uint32_t>(index);
  }

  bool has_vertices_before_faces() const { return header.elements.front().name == "vertex" || !mesh.positions.empty(); }

  /// Faces may come before vertices; then their indices can be checked only here.
  void check_indices() const {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& triangle = mesh.triangles[i];
      const std::uint32_t highest = std::max({triangle.x, triangle.y, triangle.z});
      if (highest >= mesh.positions.size()) {
        throw InputError(file,
                         fmt::format("triangle {}: vertex {}, wanted less than {}", i, highest, mesh.positions.size()));
      }
    }
  }

  void skip(const PlyProperty& property) {
    const std::int64_t count = property.is_list ? cursor.integer(property.count_type) : 1;
    if (count < 0)
      throw InputError(cursor.place(), fmt::format("{}: found {} entries, wanted 0 or more", property.name, count));
    for (std::int64_t i = 0; i < count; ++i) cursor.real(property.type);
  }

  const PlyHeader& header;
  Cursor cursor;
  const std::string& file;
  Mesh mesh;
};

}  // namespace

Mesh read_ply(const std::string& path) {
  const std::string bytes = read_file(path);
  const PlyHeader header = parse_ply_header(bytes, path);
  if (header.format == PlyFormat::kAscii) return BodyReader(header, PlyAsciiCursor(bytes, header, path), path).read();
  return BodyReader(header, PlyBinaryCursor(bytes, header, path), path).read();
}

}  // namespace cbvh::golden
