// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/report_page/recognise.h"

namespace cbvh::testbench {

/// The whole page: the verdict over all checks, units by backend, each result's tables and plots, the pictures, and the
/// files with the commands and versions that made them. Needs nothing but itself to be shown.
std::string report_page(const Contents& contents);

/// Of every result together.
Tally tally_of(const Contents& contents);

}  // namespace cbvh::testbench
