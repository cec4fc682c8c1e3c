// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "scene_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace cbvh::golden {
namespace {

Mesh load(const std::string& bytes) { return load_scene(TemporaryFolder().write("s.ply", bytes)); }

std::string error(const std::string& bytes) { return error_of(TemporaryFolder().write("s.ply", bytes)); }

enum class Order { kLittle, kBig };

template <class T>
std::string raw(T value, Order order) {
  std::string bytes = bytes_of(std::vector<T>{value});
  if (order == Order::kBig) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string header(const std::string& format, std::size_t vertices, std::size_t faces) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment a test\nobj_info none\nelement vertex {}\nproperty float x\nproperty float "
      "y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, vertices, faces);
}

const std::string kTriangle = "0 0 0\n1 0 0\n0 1 0\n";

std::string binary(Order order, const std::vector<glm::vec3>& positions,
                   const std::vector<std::vector<int>>& polygons) {
  std::string bytes =
      header(order == Order::kBig ? "binary_big_endian" : "binary_little_endian", positions.size(), polygons.size());
  for (const glm::vec3& p : positions) bytes += raw(p.x, order) + raw(p.y, order) + raw(p.z, order);
  for (const auto& polygon : polygons) {
    bytes += static_cast<char>(polygon.size());
    for (const int corner : polygon) bytes += raw(corner, order);
  }
  return bytes;
}

TEST(PlyScene, positions_and_triangle_order_survive_bit_for_bit_in_all_three_formats) {
  std::string ascii = header("ascii", 6, 3);
  for (const glm::vec3& p : difficult_positions()) ascii += fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  ascii += "3 5 4 3\n4 0 1 2 3\n3 1 1 1\n";
  const std::vector<std::vector<int>> polygons = {{5, 4, 3}, {0, 1, 2, 3}, {1, 1, 1}};
  for (const std::string& bytes : {ascii, binary(Order::kLittle, difficult_positions(), polygons),
                                   binary(Order::kBig, difficult_positions(), polygons)}) {
    const Mesh mesh = load(bytes);
    EXPECT_TRUE(same_bits(mesh.positions, difficult_positions()));
    EXPECT_EQ(mesh.triangles, (Triangles{{5, 4, 3}, {0, 1, 2}, {0, 2, 3}, {1, 1, 1}}));
    EXPECT_EQ(mesh.name, "s");
  }
}

TEST(PlyScene, text_is_read_as_the_nearest_binary32) {
  const Mesh mesh = load(header("ascii", 3, 1) +
                         "3.40282347e+38 1.17549435e-38 1e-45\n1.00000005960464477540 1.0000000596046448 0.1\n0 1e-60 "
                         "16777219\n3 0 1 2\n");
  EXPECT_EQ(mesh.positions[0], glm::vec3(0x1.fffffep127f, 0x1p-126f, 0x1p-149f));
  EXPECT_EQ(mesh.positions[1],
            glm::vec3(0x1.000002p0f, 0x1.000002p0f, 0.1f));  // just above the midpoint of 1 and the next number
  EXPECT_EQ(mesh.positions[2], glm::vec3(0.0f, 0.0f, 16777220.0f));
}

TEST(PlyScene, other_properties_elements_and_types_are_read_past) {
  std::string bytes =
      "ply\r\nformat binary_little_endian 1.0\r\nelement skipped 1\r\nproperty list ushort short a\r\nproperty double "
      "b\r\n"
      "element vertex 3\r\nproperty uchar red\r\nproperty double z\r\nproperty short y\r\nproperty list uchar float "
      "q\r\nproperty uint8 x\r\n"
      "element face 1\r\nproperty int flag\r\nproperty list int ushort vertex_index\r\nproperty list uchar float "
      "texcoord\r\nend_header\r\n";
  constexpr Order kOrder = Order::kLittle;
  bytes +=
      raw<std::uint16_t>(2, kOrder) + raw<std::int16_t>(-1, kOrder) + raw<std::int16_t>(2, kOrder) + raw(0.5, kOrder);
  for (int i = 0; i < 3; ++i) {
    bytes += std::string("\x07", 1) + raw(0.1 * i, kOrder) + raw(static_cast<std::int16_t>(-300 * i), kOrder) +
             std::string("\x01", 1) + raw(2.0f, kOrder) + static_cast<char>(200 + i);
  }
  bytes += raw(9, kOrder) + raw(3, kOrder) + raw<std::uint16_t>(2, kOrder) + raw<std::uint16_t>(1, kOrder) +
           raw<std::uint16_t>(0, kOrder) + std::string("\x02", 1) + raw(0.0f, kOrder) + raw(1.0f, kOrder);
  const Mesh mesh = load(bytes);
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{200, 0, 0}, {201, -300, 0.1f}, {202, -600, 0.2f}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{2, 1, 0}}));
}

TEST(PlyScene, faces_may_come_before_vertices) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar uint vertex_indices\nelement vertex 3\nproperty "
      "float x\n"
      "property float y\nproperty float z\nend_header\n";
  EXPECT_EQ(load(start + "3 2 1 0\n" + kTriangle).triangles, (Triangles{{2, 1, 0}}));
  EXPECT_EQ(error(start + "3 2 1 3\n" + kTriangle), "s.ply: triangle 0: vertex 3, wanted less than 3");
}

TEST(PlyScene, bad_headers_are_named_with_their_line) {
  const auto with = [](const std::string& what, const std::string& by) {
    std::string bytes = header("ascii", 3, 1) + kTriangle + "3 0 1 2\n";
    bytes.replace(bytes.find(what), what.size(), by);
    return error(bytes);
  };
  EXPECT_EQ(with("ply", "pLy"), "s.ply:1: magic: found 'pLy\\x0a', wanted 'ply'");
  EXPECT_EQ(error("ply"), "s.ply:1: magic: wanted a line 'ply'");
  EXPECT_EQ(with("ascii", "text"),
            "s.ply:2: format: found 'text', wanted ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(with("ascii 1.0", "ascii 2.0"), "s.ply:2: format version: found '2.0', wanted 1.0");
  EXPECT_EQ(with("comment", "komment"),
            "s.ply:3: found 'komment', wanted element, property, comment, obj_info or end_header");
  EXPECT_EQ(with("vertex 3", "vertex -3"), "s.ply:5: element: wanted a name and a count");
  EXPECT_EQ(with("vertex 3", "vertex 402653185"),
            "s.ply:5: vertices: found 402653185, wanted at most 3 * 2^27 = 402653184");
  EXPECT_EQ(with("float y", "half y"),
            "s.ply:7: type: found 'half', wanted char, uchar, short, ushort, int, uint, float or double");
  EXPECT_EQ(with("float y", "float x"), "s.ply:7: property: 'x' appears twice");
  EXPECT_EQ(with("float y", "float w"), "s.ply: element 'vertex': property y is missing");
  EXPECT_EQ(with("element face", "element vertex"), "s.ply:9: element: 'vertex' appears twice");
  EXPECT_EQ(with("uchar int", "float int"), "s.ply:10: property list: count type 'float', wanted an integer type");
  EXPECT_EQ(with("uchar int", "uchar float"), "s.ply: element 'face': wanted vertex indices of an integer type");
  EXPECT_EQ(with("vertex_indices", "corners"),
            "s.ply: element 'face': wanted a property list vertex_indices or vertex_index");
  EXPECT_EQ(error("ply\nformat ascii 1.0\n"), "s.ply:3: header: found the end of the file, wanted end_header");
}

TEST(PlyScene, bad_ascii_values_are_named_with_their_line) {
  const auto body = [](const std::string& text) { return error(header("ascii", 3, 1) + text); };
  EXPECT_EQ(body("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "s.ply:13: vertex 1: y is NaN, wanted a finite number");
  EXPECT_EQ(body("0 0 0\n1 -inf 0\n0 1 0\n3 0 1 2\n"), "s.ply:13: vertex 1: y is infinite, wanted a finite number");
  EXPECT_EQ(body("0 0 0\n1 1e40 0\n0 1 0\n3 0 1 2\n"), "s.ply:13: vertex 1: y is infinite, wanted a finite number");
  EXPECT_EQ(body("0 0 0\n1 O 0\n0 1 0\n3 0 1 2\n"), "s.ply:13: found 'O', wanted a number");
  EXPECT_EQ(body("0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), "s.ply:13: found the end of the line, wanted a value");
  EXPECT_EQ(body("0 0 0\n1 0 0 5\n0 1 0\n3 0 1 2\n"),
            "s.ply:13: found '5' after the item's last value, wanted the end of the line");
  EXPECT_EQ(body(kTriangle + "3 0 1 3\n"), "s.ply:15: vertex_indices: vertex 3, wanted 0 to 2");
  EXPECT_EQ(body(kTriangle + "3 0 1 -1\n"), "s.ply:15: vertex_indices: vertex -1, wanted 0 to 2");
  EXPECT_EQ(body(kTriangle + "2 0 1 2\n"), "s.ply:15: vertex_indices: found 2 corners, wanted 3 or more");
  EXPECT_EQ(body(kTriangle + "256 0 1\n"), "s.ply:15: found '256', wanted an integer from 0 to 255");
  EXPECT_EQ(body(kTriangle + "3 0 1 2\n3 0 1 2\n"),
            "s.ply:16: found '3 0 1 2' after the last item, wanted the end of the file");
  EXPECT_EQ(body(kTriangle + "3 0 1"), "s.ply:15: found the end of the file, wanted a value");
  EXPECT_EQ(error(header("ascii", 3, 0) + kTriangle), "s.ply: no triangles");
}

TEST(PlyScene, bad_binary_values_are_named_with_their_offset) {
  const std::vector<glm::vec3> good = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::string whole = binary(Order::kLittle, good, {{0, 1, 2}});
  const std::size_t body = whole.find("end_header\n") + 11;
  EXPECT_EQ(error(whole.substr(0, whole.size() - 1)),
            fmt::format("s.ply:offset {}: found the end of the file, wanted a value of 4 bytes", whole.size() - 4));
  EXPECT_EQ(error(whole + "x"),
            fmt::format("s.ply:offset {}: 1 bytes after the last item, wanted the end of the file", whole.size()));
  EXPECT_EQ(error(whole.substr(0, body + 35)),
            fmt::format("s.ply:offset {}: element 'vertex': 3 items of at least 12 bytes, but 35 bytes follow", body));
  const std::string infinite = binary(Order::kBig, {{0, 0, 0}, {INFINITY, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(error(infinite),
            fmt::format("s.ply:offset {}: vertex 1: x is infinite, wanted a finite number", infinite.size() - 13 - 12));
  EXPECT_EQ(error(binary(Order::kLittle, good, {{0, 1, 3}})),
            fmt::format("s.ply:offset {}: vertex_indices: vertex 3, wanted 0 to 2", whole.size()));
}

TEST(PlyScene, a_tiny_file_cannot_ask_for_much_memory_or_time) {
  EXPECT_EQ(error(header("ascii", 400000000, 1) + "0 0 0\n"),
            "s.ply:11: element 'vertex': 400000000 items of at least 3 bytes, but 6 bytes follow");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement a 18446744073709551615\nend_header\n"),
            "s.ply: element 'a': has items but no property");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement a 18446744073709551615\nproperty list int int b\nend_header\n0\n"),
            "s.ply:5: element 'a': 18446744073709551615 items of at least 1 bytes, but 2 bytes follow");
}

}  // namespace
}  // namespace cbvh::golden
