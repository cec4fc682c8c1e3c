// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/report_page/result.h"

#include <fmt/format.h>

#include <stdexcept>

namespace cbvh::testbench {

Tally& Tally::operator+=(const Tally& more) {
  passed += more.passed;
  failed += more.failed;
  skipped += more.skipped;
  return *this;
}

Outcome outcome(const Tally& tally) {
  if (tally.failed != 0) return Outcome::failed;
  return tally.passed == 0 ? Outcome::nothing_checked : Outcome::passed;
}

std::uint64_t count(const Json& json, const char* key) {
  const Json& value = json.at(key);
  if (!value.is_number_unsigned()) throw std::invalid_argument(fmt::format("'{}' is {}, no count", key, value.dump()));
  return value;
}

Tally one_check(bool passed) { return passed ? Tally{1, 0, 0} : Tally{0, 1, 0}; }

}  // namespace cbvh::testbench
