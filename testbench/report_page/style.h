// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cbvh::testbench {

/// The page's style sheet: light and dark, screen and paper.
extern const char* const kReportStyle;

}  // namespace cbvh::testbench
