// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "vectors/vector_set.h"

namespace cbvh::testbench {

/// Whether the one case of a set (with the golden's responses) still fails. InputError: it is not well formed.
using StillFails = std::function<bool(const vectors::VectorSet& set)>;

/// A smaller case that still fails: sequences lose stimuli (whole trees where there are trees), then every stimulus's
/// fields go to 0 or 1.0 one by one, as long as the case fails. Tries at most `attempts` cases.
std::unique_ptr<vectors::VectorSet> minimise(const vectors::VectorSet& set, std::size_t index,
                                             const StillFails& still_fails, std::size_t attempts = 2000);

}  // namespace cbvh::testbench
