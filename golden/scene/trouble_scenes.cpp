// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/trouble_scenes.h"

#include <fmt/format.h>

#include <glm/common.hpp>
#include <limits>

#include "golden/quantize/exact.h"
#include "golden/scene/procedural/random.h"

namespace cbvh::golden {
namespace {

/// The distributions made of splitmix64; integer arithmetic and exact scalings only, so every platform draws the same
/// scenes.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random(seed) {}
  int between(int low, int high) {
    return low + static_cast<int>(random.bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(int percent) { return between(1, 100) <= percent; }
  /// A multiple of 2^(e - 20) in [-2^e, 2^e].
  float within(int e) {
    return static_cast<float>(between(-(1 << 20), 1 << 20)) * static_cast<float>(power_of_two(e - 20));
  }
  /// Any sign and significand with the exponent e.
  float of_exponent(int e) {
    const double x = static_cast<double>((1 << 23) + between(0, (1 << 23) - 1)) * power_of_two(e - 23);
    return static_cast<float>(chance(50) ? -x : x);
  }
  template <class Coordinate>
  glm::vec3 vec3(Coordinate coordinate) {
    const float x = coordinate();
    const float y = coordinate();
    const float z = coordinate();
    return {x, y, z};
  }

 private:
  Random random;
};

void add(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// `count` triangles of vertices drawn one by one.
template <class Vertex>
void add_each(Mesh& mesh, int count, Vertex vertex) {
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a = vertex();
    const glm::vec3 b = vertex();
    const glm::vec3 c = vertex();
    add(mesh, a, b, c);
  }
}

/// `count` triangles of about 2^size around centres that `centre` draws.
template <class Centre>
void add_around(Mesh& mesh, Draw& draw, int count, int size, Centre centre) {
  for (int i = 0; i < count; ++i) {
    const glm::vec3 m = centre();
    const glm::vec3 a = m + draw.vec3([&] { return draw.within(size); });
    const glm::vec3 b = m + draw.vec3([&] { return draw.within(size); });
    const glm::vec3 c = m + draw.vec3([&] { return draw.within(size); });
    add(mesh, a, b, c);
  }
}

void add_huge(Mesh& mesh, Draw& draw, int count) {
  const int lowest = draw.between(100, 127);
  add_each(mesh, count, [&] {
    return draw.vec3([&] {
      if (draw.chance(3))
        return draw.chance(50) ? std::numeric_limits<float>::max() : -std::numeric_limits<float>::max();
      return draw.of_exponent(draw.between(lowest, 127));
    });
  });
}

void add_subnormal(Mesh& mesh, Draw& draw, int count) {
  const int range = 1 << draw.between(1, 23);
  add_each(mesh, count,
           [&] { return draw.vec3([&] { return static_cast<float>(draw.between(-range, range)) * 0x1p-149F; }); });
}

void add_negative_offsets(Mesh& mesh, Draw& draw, int count) {
  const glm::vec3 offset =
      draw.vec3([&] { return draw.chance(70) ? -static_cast<float>(draw.between(1, 100'000)) : 0.0F; });
  add_around(mesh, draw, count, draw.between(-6, 3),
             [&] { return offset + draw.vec3([&] { return draw.within(4); }); });
}

void add_lattice(Mesh& mesh, Draw& draw, int count) {
  const auto cell = static_cast<float>(power_of_two(draw.between(-20, 20)));
  const int range = 1 << draw.between(1, 9);
  add_each(mesh, count,
           [&] { return draw.vec3([&] { return static_cast<float>(draw.between(-range, range)) * cell; }); });
}

void add_duplicates(Mesh& mesh, Draw& draw, int count) {
  const int distinct = draw.between(1, 5);
  add_around(mesh, draw, distinct, draw.between(-4, 0), [&] { return draw.vec3([&] { return draw.within(2); }); });
  while (static_cast<int>(mesh.triangles.size()) < count) {
    mesh.triangles.push_back(mesh.triangles[static_cast<std::size_t>(draw.between(0, distinct - 1))]);
  }
}

void add_points(Mesh& mesh, Draw& draw, int count) {
  const int e = draw.between(-10, 10);
  for (int i = 0; i < count; ++i) {
    const glm::vec3 p = draw.vec3([&] { return draw.within(e); });
    add(mesh, p, p, p);
  }
}

void add_equal_codes(Mesh& mesh, Draw& draw, int count) {
  const glm::vec3 home = draw.vec3([&] { return draw.within(0); });
  add_around(mesh, draw, count, draw.between(-20, -9),
             [&] { return draw.chance(80) ? home : home + draw.vec3([&] { return draw.within(-6); }); });
  const glm::vec3 away = draw.vec3([&] { return draw.within(6); });
  add(mesh, away, away, away);
}

void add_planes(Mesh& mesh, Draw& draw, int count) {
  const int flat = draw.between(0, 2);
  const float height = draw.chance(30) ? 0.0F : (draw.chance(50) ? -0.4F : draw.within(3));
  const int size = draw.between(-6, -1);
  add_around(mesh, draw, count, size, [&] { return draw.vec3([&] { return draw.within(1); }); });
  for (glm::vec3& p : mesh.positions) p[flat] = height;
  if (draw.chance(70)) add_around(mesh, draw, 2, size, [&] { return draw.vec3([&] { return draw.within(1); }); });
}

void add_mixed_scales(Mesh& mesh, Draw& draw, int count) {
  for (int i = 0; i < count; ++i) {
    add_around(mesh, draw, 1, draw.between(-20, 20),
               [&] { return draw.vec3([&] { return draw.within(draw.between(-20, 20)); }); });
  }
}

void add_axis_aligned(Mesh& mesh, Draw& draw, int count) {
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a = draw.vec3([&] { return static_cast<float>(draw.between(-40, 40)) * 0.1F; });
    const int axis = draw.between(0, 2);
    glm::vec3 b = a;
    glm::vec3 c = a;
    b[(axis + 1) % 3] += static_cast<float>(draw.between(1, 30)) * 0.1F;
    c[(axis + 2) % 3] += static_cast<float>(draw.between(1, 30)) * 0.1F;
    add(mesh, a, b, c);
  }
}

}  // namespace

const char* name_of(Trouble trouble) {
  switch (trouble) {
    case Trouble::huge:
      return "huge";
    case Trouble::tiny:
      return "tiny";
    case Trouble::subnormal:
      return "subnormal";
    case Trouble::negative_offsets:
      return "negative_offsets";
    case Trouble::lattice:
      return "lattice";
    case Trouble::duplicates:
      return "duplicates";
    case Trouble::points:
      return "points";
    case Trouble::equal_codes:
      return "equal_codes";
    case Trouble::planes:
      return "planes";
    case Trouble::mixed_scales:
      return "mixed_scales";
    case Trouble::axis_aligned:
      return "axis_aligned";
    case Trouble::single_triangle:
      return "single_triangle";
  }
  return "unknown";
}

Mesh trouble_scene(Trouble trouble, std::uint64_t seed, int most_triangles) {
  Mesh mesh;
  mesh.name = fmt::format("trouble:{},seed={},most={}", name_of(trouble), seed, most_triangles);
  Draw draw(seed * 16 + static_cast<std::uint64_t>(trouble));
  const int count = draw.between(1, most_triangles);
  switch (trouble) {
    case Trouble::huge:
      add_huge(mesh, draw, count);
      break;
    case Trouble::tiny:
      add_each(mesh, count, [&] { return draw.vec3([&] { return draw.of_exponent(draw.between(-126, -96)); }); });
      break;
    case Trouble::subnormal:
      add_subnormal(mesh, draw, count);
      break;
    case Trouble::negative_offsets:
      add_negative_offsets(mesh, draw, count);
      break;
    case Trouble::lattice:
      add_lattice(mesh, draw, count);
      break;
    case Trouble::duplicates:
      add_duplicates(mesh, draw, count);
      break;
    case Trouble::points:
      add_points(mesh, draw, count);
      break;
    case Trouble::equal_codes:
      add_equal_codes(mesh, draw, count);
      break;
    case Trouble::planes:
      add_planes(mesh, draw, count);
      break;
    case Trouble::mixed_scales:
      add_mixed_scales(mesh, draw, count);
      break;
    case Trouble::axis_aligned:
      add_axis_aligned(mesh, draw, count);
      break;
    case Trouble::single_triangle:
      add_each(mesh, 1, [&] {
        return draw.vec3([&] { return draw.chance(20) ? 0.0F : draw.of_exponent(draw.between(-30, 30)); });
      });
      break;
  }
  return mesh;
}

}  // namespace cbvh::golden
