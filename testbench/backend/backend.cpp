// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/backend/backend.h"

#include "testbench/unavailable.h"
#include "vectors/registry.h"

namespace cbvh::testbench {

std::vector<std::string> backend_names() {
  std::vector<std::string> names;
  for (MakeBackend* make : all_backends()) names.push_back(make()->name());
  return names;
}

std::unique_ptr<Backend> make_backend(const std::string& name) {
  for (MakeBackend* make : all_backends()) {
    std::unique_ptr<Backend> backend = make();
    if (backend->name() != name) continue;
    const std::string reason = backend->why_unavailable();
    if (!reason.empty()) throw Unavailable(fmt::format("backend {}: {}", name, reason));
    return backend;
  }
  throw golden::InputError("--backend", fmt::format("unknown '{}', known: {}", name, fmt::join(backend_names(), ", ")));
}

void require_unit(const Backend& backend, const vectors::UnitDescription& unit) {
  if (backend.has(unit)) return;
  std::vector<std::string_view> names;
  for (const vectors::UnitDescription& other : vectors::units()) {
    if (backend.has(other)) names.push_back(other.name);
  }
  throw Unavailable(
      fmt::format("backend {}: has no unit '{}', only: {}", backend.name(), unit.name, fmt::join(names, ", ")));
}

void require_parameters(const Backend& backend, const vectors::VectorSet& set) {
  const vectors::UnitDescription& unit = set.unit();
  if (backend.takes(unit, set.parameters())) return;
  std::vector<std::string> known;
  for (const int bits : unit.bits) {
    for (const int treelet : unit.treelets) {
      if (backend.takes(unit, {bits, treelet})) known.push_back(fmt::format("N = {} D = {}", bits, treelet));
    }
  }
  throw Unavailable(fmt::format("backend {}: has no unit '{}' with N = {} D = {}, only: {}", backend.name(), unit.name,
                                set.parameters().bits, set.parameters().treelet, fmt::join(known, ", ")));
}

}  // namespace cbvh::testbench
