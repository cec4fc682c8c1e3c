// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "golden/build/float_tree.h"
#include "golden/options/options.h"

namespace cbvh::golden {

/// A way to build a tree, with its options. A builder's result depends on the mesh and the options alone, never on how
/// many threads build it. Its leaves hold the mesh's triangles; a builder that splits triangles may put one into
/// several leaves.
struct BuilderKind {
  std::string name;
  std::string meaning;  ///< in a line, and the paper's place
  std::vector<Option> options;
  FloatTree (*build)(const Mesh& mesh, const OptionValues& options);
};

/// All kinds, in the order in which help and reports name them.
const std::vector<BuilderKind>& builder_kinds();

/// A kind with values for its options.
class Builder {
 public:
  /// From "NAME[,key=value...]", as "binned,bins=16". Throws InputError at `place`.
  Builder(const std::string& place, std::string_view description);

  /// As it was described.
  const std::string& text() const { return text_; }
  const BuilderKind& kind() const { return *kind_; }

  /// Throws InputError as triangle_boxes does, and when the tree grows beyond what its options or the formats allow.
  FloatTree build(const Mesh& mesh) const { return kind_->build(mesh, options_); }

 private:
  std::string text_;
  const BuilderKind* kind_;
  OptionValues options_;
};

/// The kinds and their options, for help.
std::string builder_help();

}  // namespace cbvh::golden
