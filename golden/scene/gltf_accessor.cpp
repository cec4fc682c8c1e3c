// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/scene/gltf_accessor.h"

#include <tiny_gltf.h>

#include <bit>
#include <cstring>

#include "golden/input_error.h"

namespace cbvh::golden {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian, and so are the machines we run on");

/// Zeros an accessor without a buffer view may ask for: enough for any use, too few to exhaust memory with a tiny file.
constexpr std::uint64_t kMaxImpliedZeros = std::uint64_t{1} << 16;

/// Equally spaced elements inside a buffer.
struct Elements {
  const unsigned char* first = nullptr;  ///< null: all zero
  std::size_t stride = 0;
  std::uint64_t count = 0;

  const unsigned char* at(std::uint64_t i) const { return first + i * stride; }
};

struct ElementKind {
  int component_type;
  std::size_t component_bytes;
  std::size_t components;

  std::size_t bytes() const { return component_bytes * components; }
};

/// Follows references into the model and checks each, so that reading needs no check.
class Resolver {
 public:
  Resolver(const GltfSource& from, int accessor_index, const std::string& user)
      : source(from), at(fmt::format("accessors[{}]", accessor_index)) {
    const auto& accessors = source.model.accessors;
    if (accessor_index < 0 || static_cast<std::size_t>(accessor_index) >= accessors.size()) {
      throw InputError(source.file,
                       fmt::format("{}: accessor {}, wanted less than {}", user, accessor_index, accessors.size()));
    }
    accessor = &accessors[static_cast<std::size_t>(accessor_index)];
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(source.file, at + ": " + what); }

  Elements dense(const ElementKind& kind) const {
    if (accessor->bufferView >= 0) return view(accessor->bufferView, accessor->byteOffset, accessor->count, kind, "");
    if (accessor->count > kMaxImpliedZeros) {
      fail(fmt::format("count: found {} without a bufferView, wanted at most {}", accessor->count, kMaxImpliedZeros));
    }
    return {nullptr, 0, accessor->count};
  }

  Elements sparse_indices() const {
    const auto& sparse = accessor->sparse;
    return view(sparse.indices.bufferView, to_size(sparse.indices.byteOffset), to_size(sparse.count),
                index_kind(sparse.indices.componentType, "sparse.indices."), "sparse.indices.");
  }

  Elements sparse_values(const ElementKind& kind) const {
    const auto& sparse = accessor->sparse;
    return view(sparse.values.bufferView, to_size(sparse.values.byteOffset), to_size(sparse.count), kind,
                "sparse.values.");
  }

  ElementKind index_kind(int component_type, const char* part) const {
    switch (component_type) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return {component_type, 1, 1};
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return {component_type, 2, 1};
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return {component_type, 4, 1};
    }
    fail(fmt::format("{}componentType: found {}, wanted 5121, 5123 or 5125 (unsigned byte, short or int)", part,
                     component_type));
  }

  const GltfSource& source;
  const tinygltf::Accessor* accessor;
  std::string at;

 private:
  static std::size_t to_size(int value) {
    return static_cast<std::size_t>(value);
  }  // geometry_json let no negative one through

  Elements view(int view_index, std::size_t offset, std::uint64_t count, const ElementKind& kind,
                const char* part) const {
    const auto& views = source.model.bufferViews;
    if (view_index < 0 || to_size(view_index) >= views.size()) {
      fail(fmt::format("{}bufferView: found {}, wanted less than {}", part, view_index, views.size()));
    }
    const tinygltf::BufferView& found = views[to_size(view_index)];
    const std::string name = fmt::format("bufferViews[{}]", view_index);
    const auto& buffers = source.model.buffers;
    if (found.buffer < 0 || to_size(found.buffer) >= buffers.size()) {
      throw InputError(source.file,
                       fmt::format("{}.buffer: found {}, wanted less than {}", name, found.buffer, buffers.size()));
    }
    const auto& bytes = buffers[to_size(found.buffer)].data;
    if (found.byteOffset > bytes.size() || found.byteLength > bytes.size() - found.byteOffset) {
      throw InputError(source.file,
                       fmt::format("{}: bytes {} to {} lie outside buffers[{}] of {} bytes", name, found.byteOffset,
                                   found.byteOffset + found.byteLength, found.buffer, bytes.size()));
    }
    if ((found.byteOffset + offset) % kind.component_bytes != 0) {
      fail(fmt::format("{}byteOffset: offset {} in the buffer, wanted a multiple of {}", part,
                       found.byteOffset + offset, kind.component_bytes));
    }
    const std::size_t stride = found.byteStride == 0 ? kind.bytes() : found.byteStride;
    if (stride < kind.bytes())
      throw InputError(source.file,
                       fmt::format("{}.byteStride: found {}, wanted at least {}", name, stride, kind.bytes()));
    // All factors are below 2^32, so no product overflows.
    const std::uint64_t needed = count == 0 ? 0 : offset + (count - 1) * stride + kind.bytes();
    if (needed > found.byteLength) {
      fail(fmt::format("{}count: {} elements need {} bytes of {}, which has {}", part, count, needed, name,
                       found.byteLength));
    }
    return {bytes.data() + found.byteOffset + offset, stride, count};
  }
};

std::uint32_t index_at(const Elements& elements, std::size_t component_bytes, std::uint64_t i) {
  std::uint32_t value = 0;
  std::memcpy(&value, elements.at(i), component_bytes);
  return value;
}

/// Calls replace(target, source byte) for each sparse entry; targets must lie in the accessor and increase.
template <class Replace>
void for_each_sparse(const Resolver& resolver, const ElementKind& kind, const Replace& replace) {
  if (!resolver.accessor->sparse.isSparse) return;
  const Elements targets = resolver.sparse_indices();
  const Elements values = resolver.sparse_values(kind);
  const std::size_t index_bytes =
      resolver.index_kind(resolver.accessor->sparse.indices.componentType, "").component_bytes;
  std::uint64_t lowest = 0;
  for (std::uint64_t i = 0; i < targets.count; ++i) {
    const std::uint64_t target = index_at(targets, index_bytes, i);
    if (target < lowest || target >= resolver.accessor->count) {
      resolver.fail(fmt::format("sparse.indices: entry {} is {}, wanted increasing numbers below {}", i, target,
                                resolver.accessor->count));
    }
    lowest = target + 1;
    replace(target, values.at(i));
  }
}

void check_sparse(const Resolver& resolver, const ElementKind& kind) {
  for_each_sparse(resolver, kind, [](std::uint64_t, const unsigned char*) {});
}

constexpr ElementKind kPosition = {TINYGLTF_COMPONENT_TYPE_FLOAT, sizeof(float), 3};

}  // namespace

std::uint64_t count_positions(const GltfSource& source, int index, const std::string& user) {
  const Resolver resolver(source, index, user);
  if (resolver.accessor->componentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
      resolver.accessor->type != TINYGLTF_TYPE_VEC3) {
    resolver.fail(fmt::format("componentType and type: found {} and {}, wanted 5126 (FLOAT) and VEC3 for positions",
                              resolver.accessor->componentType, resolver.accessor->type));
  }
  resolver.dense(kPosition);
  check_sparse(resolver, kPosition);
  return resolver.accessor->count;
}

std::uint64_t count_indices(const GltfSource& source, int index, const std::string& user) {
  const Resolver resolver(source, index, user);
  const ElementKind kind = resolver.index_kind(resolver.accessor->componentType, "");
  if (resolver.accessor->type != TINYGLTF_TYPE_SCALAR) resolver.fail("type: wanted SCALAR for indices");
  resolver.dense(kind);
  check_sparse(resolver, kind);
  return resolver.accessor->count;
}

void append_positions(const GltfSource& source, int index, std::vector<glm::vec3>& positions) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  const Resolver resolver(source, index, "");
  const Elements elements = resolver.dense(kPosition);
  const std::size_t base = positions.size();
  positions.resize(base + elements.count, glm::vec3(0.0f));
  for (std::uint64_t i = 0; elements.first != nullptr && i < elements.count; ++i) {
    std::memcpy(&positions[base + i], elements.at(i), sizeof(glm::vec3));
  }
  for_each_sparse(resolver, kPosition, [&](std::uint64_t target, const unsigned char* value) {
    std::memcpy(&positions[base + target], value, sizeof(glm::vec3));
  });
}

std::vector<std::uint32_t> read_indices(const GltfSource& source, int index) {
  const Resolver resolver(source, index, "");
  const ElementKind kind = resolver.index_kind(resolver.accessor->componentType, "");
  const Elements elements = resolver.dense(kind);
  std::vector<std::uint32_t> indices(elements.count, 0);
  for (std::uint64_t i = 0; elements.first != nullptr && i < elements.count; ++i)
    indices[i] = index_at(elements, kind.component_bytes, i);
  for_each_sparse(resolver, kind, [&](std::uint64_t target, const unsigned char* value) {
    indices[target] = 0;
    std::memcpy(&indices[target], value, kind.component_bytes);
  });
  return indices;
}

}  // namespace cbvh::golden
