// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "golden/scene/mesh.h"
#include "testbench/report/json.h"
#include "testbench/rtl/stream_tree.h"

namespace cbvh::testbench {

struct BuildJob {
  std::string builder = "lbvh";  ///< "NAME[,key=value...]"
  StreamOptions stream;          ///< its rules' min_scale is set by build_and_compare
  std::optional<int> min_scale;  ///< empty: the scene's exactness limit
  bool golden_streaming = false;
};

struct BuildResult {
  golden::CompressedTree streamed;
  Json json;  ///< figures, with the stable keys of `cbvh build --json`
  bool pass;  ///< identical to the top-down tree, and no violation
};

/// Builds a tree, streams it and compresses it top-down, compares both and measures what it cost.
BuildResult build_and_compare(const golden::Mesh& mesh, const BuildJob& job);

/// The figures for people.
std::string to_text(const std::string& scene, const Json& figures);

}  // namespace cbvh::testbench
