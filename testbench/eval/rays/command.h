// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "testbench/command.h"

namespace cbvh::testbench {

/// Adds `eval rays`. When it is what was asked for, `*chosen` is set to what runs it.
void add_rays_evaluation(const Command& eval, const std::shared_ptr<std::function<int()>>& chosen);

}  // namespace cbvh::testbench
