// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace cbvh::testbench {

/// The project's version, as CMakeLists.txt has it.
extern const char* const kVersion;

}  // namespace cbvh::testbench
