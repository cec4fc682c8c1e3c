// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "testbench/eval/table.h"
#include "testbench/eval/two_level/frames.h"
#include "testbench/eval/two_level/measure.h"

namespace cbvh::testbench {

/// Quality, size and build time of each top level; ratios to the first one of the same scene and kind of object trees.
/// Beside them what Benthin et al. (2017) found, where their scenes compare.
Table two_level_table(const std::vector<TopLevelMeasure>& measures);

/// Median and largest build time, and quality, of each top level over all frames.
Table frames_table(const std::vector<FramesMeasure>& measures);

/// The same of every frame, for programs.
Table every_frame_table(const std::vector<FramesMeasure>& measures);

}  // namespace cbvh::testbench
