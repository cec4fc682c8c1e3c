// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace cbvh::golden {

/// Bad input, with its place. Everything that reads from outside throws this and nothing else; commands turn it into
/// one line and exit code 2.
class InputError : public std::runtime_error {
 public:
  /// `place` is "file", "file:line", "file:offset 123" or the argument's name; `what` says the field, what was found
  /// and what was wanted.
  InputError(std::string place, const std::string& what)
      : std::runtime_error(place + ": " + what), place_(std::move(place)) {}

  const std::string& place() const { return place_; }

 private:
  std::string place_;
};

}  // namespace cbvh::golden
