// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/report_page/picture.h"
#include "testbench/report_page/result.h"

namespace cbvh::testbench {

/// What a page is made of, each in the order it was given.
struct Contents {
  std::vector<Result> results;
  std::vector<Picture> pictures;
};

/// Every kind of result there is.
std::vector<ResultKind> result_kinds();

/// Adds the file with these bytes: a PNG picture, or JSON of one of the kinds. Throws InputError with `place`, the line
/// and column where there is one, what was found and what was wanted.
void recognise(const std::string& place, const std::string& bytes, Contents& contents);

}  // namespace cbvh::testbench
