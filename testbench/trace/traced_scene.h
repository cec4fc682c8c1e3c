// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "golden/quantize/codes.h"
#include "testbench/trace/pixel_source.h"

namespace cbvh::testbench {

/// How a compressed tree is made. All give the same pictures, the first two the same bits.
enum class Compression : std::uint8_t {
  streaming,  ///< through the RTL stream compressor
  top_down,   ///< by the golden
  refitted,   ///< a tree of twisted triangles, then the RTL refit unit
};
inline constexpr std::array<std::string_view, 3> kCompressions = {"streaming", "top-down", "refitted"};

/// What is traced.
struct TraceTrees {
  std::string scene;
  std::string builder = "lbvh";
  std::string top = "rebraid";  ///< of a scene of instances
  int bits = 6;
  golden::Code code = golden::Code::modulo;
  Compression compression = Compression::streaming;
};

/// A scene with its trees, float and compressed.
class TracedScene {
 public:
  virtual ~TracedScene() = default;

  virtual const golden::Box& box() const = 0;
  virtual std::uint64_t triangles() const = 0;
  /// Whether the compressed trees are the golden's, bit for bit.
  virtual bool identical() const = 0;
  virtual std::unique_ptr<PixelSource> pixels(bool compressed, const Shot& shot) const = 0;
};

/// A scene as load_scene takes it, or one of instances ("KIND[,key=value...]:SCENE"). Throws InputError for what is
/// none, for a builder that is none, and for instances that are to be refitted.
std::unique_ptr<TracedScene> load_traced_scene(const TraceTrees& trees);

/// Whether it names a scene of instances.
bool names_instances(const std::string& scene);

}  // namespace cbvh::testbench
