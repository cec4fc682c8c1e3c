// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "vectors/format/format.h"
#include "vectors/format/output.h"

/// A file that $readmemh loads: one word a line, with the same number of digits in every line. The first digit says
/// what the rest is: 1 a case's first stimulus, 0 a further one, 2 a response. A payload's first field has its lowest
/// bits. What a bench does not need is in comments: `// id class` at a first stimulus, `// @latency` at a response.
namespace cbvh::vectors {

void write_hex(const VectorSet& set, Output& output);
std::unique_ptr<SetReader> read_hex(std::string_view bytes, const std::string& name);

}  // namespace cbvh::vectors
