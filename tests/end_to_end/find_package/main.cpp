// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// What a user's program needs to build against an installed cbvh.
#include <golden/scene/mesh.h>

#include <cstdio>

int main() {
  const cbvh::golden::Mesh triangle{"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  std::printf("%zu triangle\n", triangle.triangles.size());
}
