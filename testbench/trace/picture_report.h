// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "testbench/report/json.h"
#include "testbench/trace/picture.h"
#include "testbench/trace/traced_scene.h"

namespace cbvh::testbench {

inline constexpr std::array<std::string_view, 3> kRayKinds = {"primary", "ambient-occlusion", "path"};

/// A scene with the trees that a picture of it is traced through: the float tree, the compressed one, and with `all`
/// those of every other way to compress.
class TracedScenes {
 public:
  /// Throws InputError as load_traced_scene does.
  TracedScenes(const TraceTrees& job, bool all);

  const TraceTrees job;
  std::vector<PictureTree> trees;
  const TracedScene& first() const { return *scenes_.front(); }
  std::vector<std::string> failures;  ///< trees that are not the golden's
  std::uint64_t checks = 0;           ///< compressed trees compared with the golden's

 private:
  void add(const TraceTrees& of, bool with_floats);

  std::vector<std::unique_ptr<TracedScene>> scenes_;
};

/// The figures, with the stable keys of `cbvh trace --json` (testbench/report_page/kinds/trace.cpp shows them). `pass`:
/// every pixel is the same through all trees, and every compressed tree is the golden's.
Json to_json(const TracedScenes& scenes, const PictureJob& job, const TracedPicture& picture);

/// The same for people.
std::string to_text(const Json& figures);

}  // namespace cbvh::testbench
