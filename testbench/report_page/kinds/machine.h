// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/report_page/figure.h"
#include "testbench/report_page/result.h"

namespace cbvh::testbench {

/// What a simulated machine did (testbench/sim/sim_result.h): its figures, its traffic by purpose, what its modules
/// did. Throws nlohmann::json::exception when the JSON is no such result.
Markup show_machine(const std::string& title, const Json& result, Figures& figures);

/// Its tree against the golden's, and its bytes against the model's, purpose by purpose.
Tally tally_machine(const Json& result);

}  // namespace cbvh::testbench
