// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "vectors/format/format.h"
#include "vectors/format/output.h"

/// `id class stimulus > response @latency`, a case a line; an episode is `id class episode S R` and a line for each of
/// its S stimuli (`< fields`) and R responses (`> fields @latency`).
namespace cbvh::vectors {

void write_text(const VectorSet& set, Output& output);
std::unique_ptr<SetReader> read_text(std::string_view bytes, const std::string& name);

}  // namespace cbvh::vectors
