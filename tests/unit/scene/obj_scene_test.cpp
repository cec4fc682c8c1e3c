// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "scene_files.h"

#include <fmt/format.h>

namespace cbvh::golden {
namespace {

Mesh load(const std::string& text) { return load_scene(TemporaryFolder().write("s.obj", text)); }

std::string error(const std::string& text) { return error_of(TemporaryFolder().write("s.obj", text)); }

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjScene, positions_survive_bit_for_bit_when_printed_with_nine_digits) {
  std::string text;
  for (const glm::vec3& p : difficult_positions()) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  const Mesh mesh = load(text + "f 1 2 3\nf 6 5 4\n");
  EXPECT_TRUE(same_bits(mesh.positions, difficult_positions()));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {5, 4, 3}}));
  EXPECT_EQ(mesh.name, "s");
}

TEST(ObjScene, polygons_become_fans_and_degenerate_triangles_stay_in_order) {
  EXPECT_EQ(load(kSquare + "f 1 2 3 4\nf 2 2 2\nf 4 3 2 1 2\n").triangles,
            (Triangles{{0, 1, 2}, {0, 2, 3}, {1, 1, 1}, {3, 2, 1}, {3, 1, 0}, {3, 0, 1}}));
}

TEST(ObjScene, corners_may_name_texture_and_normal_and_count_back_from_the_last_vertex) {
  const Mesh mesh = load(kSquare +
                         "vn 0 0 1\nvt 0 0\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 4/1/1\nf -4 -3/-1 "
                         "-1/1/-1\nv 5 5 5\nf -1 -2 +1\n");
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 1, 3}, {0, 1, 3}, {4, 3, 0}}));
}

TEST(ObjScene, line_ends_comments_groups_colours_and_lines_are_taken_as_they_come) {
  const Mesh mesh = load(
      "# s\r\nmtllib none.mtl\r\n\r\no a\rv 0 0 0 0.5 0.5 0.5 # red\r  v\t1 0 0 1\nv 0 1 0\ng b\ns off\nusemtl c\nl 1 "
      "2\np 1\n\tf 1 2 3  ");
  EXPECT_EQ(mesh.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
}

TEST(ObjScene, a_face_may_come_before_its_vertices) {
  EXPECT_EQ(load("f 1 2 3\n" + kSquare).triangles, (Triangles{{0, 1, 2}}));
}

TEST(ObjScene, bad_vertices_are_named_with_their_line) {
  EXPECT_EQ(error("v 0 0 0\nv 1 nan 0\n"), "s.obj:2: v: y is 'nan', wanted a finite number");
  EXPECT_EQ(error("v 0 0 -inf\n"), "s.obj:1: v: z is '-inf', wanted a finite number");
  EXPECT_EQ(error("v 1e39 0 0\n"), "s.obj:1: v: x is '1e39', wanted a finite number");
  EXPECT_EQ(error("v 1e999 0 0\n"), "s.obj:1: v: x is '1e999', wanted a number");
  EXPECT_EQ(error("v 0 0\n"), "s.obj:1: v: found 2 numbers, wanted 3");
  EXPECT_EQ(error("v 0 0 # 1\n"), "s.obj:1: v: z is '#', wanted a number");
  EXPECT_EQ(error("v 0 0x1 0\n"), "s.obj:1: v: y is '0x1', wanted a number");
  EXPECT_EQ(error("v 0 0 0 red\n"), "s.obj:1: v: number 4 is 'red', wanted a number");
}

TEST(ObjScene, bad_faces_are_named_with_their_line) {
  EXPECT_EQ(error(kSquare + "f 1 2 5\nf 1 2 3\n"), "s.obj:5: f: vertex 5, wanted at most 4");
  EXPECT_EQ(error(kSquare + "f 1 2 -5\n"), "s.obj:5: f: vertex -5, wanted at least -4");
  EXPECT_EQ(error(kSquare + "f 1 0 2\n"), "s.obj:5: f: vertex 0, wanted 1 or more, or a negative number");
  EXPECT_EQ(error(kSquare + "f 1 2\n"), "s.obj:5: f: found 2 corners, wanted 3 or more");
  for (const char* corner : {"x", "1/", "1//", "1/2/", "1/2/3/4", "1/x", "1.5", "99999999999", "#"}) {
    EXPECT_EQ(error(kSquare + "f 1 2 " + corner + "\n"),
              fmt::format("s.obj:5: f: found '{}', wanted a corner as 1, 1/2, 1//3 or 1/2/3", corner));
  }
}

TEST(ObjScene, what_is_no_obj_is_refused) {
  EXPECT_EQ(error(kSquare + "w 1 2 3\n"), "s.obj:5: statement: found 'w', wanted one of OBJ");
  EXPECT_EQ(error(std::string("v 0 0 0\n\0\n", 10)), "s.obj:2: found a zero byte, wanted text");
  EXPECT_EQ(error(""), "s.obj: no triangles");
  EXPECT_EQ(error(kSquare), "s.obj: no triangles");
}

}  // namespace
}  // namespace cbvh::golden
