// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cbvh::golden {

/// What may follow a name: a number, "soup,triangles=500", or one of a few words, "binned,top=grid".
struct Option {
  std::string name;
  std::string meaning;
  double initial;
  double least;
  double greatest;
  bool is_integer = true;
  std::vector<std::string> words = {};  ///< if there are any: the value is a word's index
};

/// One of a few words; the first is the initial one.
Option word_option(std::string name, std::string meaning, std::vector<std::string> words);

/// The values of the options of one name: all of them, each in its range.
class OptionValues {
 public:
  std::uint64_t integer(const std::string& name) const { return static_cast<std::uint64_t>(values.at(name)); }
  /// The index of the word.
  std::size_t word(const std::string& name) const { return static_cast<std::size_t>(values.at(name)); }
  float real(const std::string& name) const { return static_cast<float>(values.at(name)); }

  std::map<std::string, double> values;
};

/// The name at the front of "NAME[,key=value...]".
std::string_view name_of(std::string_view description);

/// The values that "NAME[,key=value...]" gives, and initial ones for the other options. Throws InputError at `place`
/// for a key that is not among the options, given twice or without a value, and for a value out of its range.
OptionValues read_options(const std::string& place, std::string_view description, const std::vector<Option>& options);

/// A line of help for each option.
std::string options_help(const std::vector<Option>& options);

/// The one of that name; nullptr if there is none.
template <class Named>
const Named* find_named(const std::vector<Named>& all, std::string_view name) {
  for (const Named& one : all) {
    if (one.name == name) return &one;
  }
  return nullptr;
}

/// "a, b, c".
template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::string list;
  for (const Named& one : all) {
    if (!list.empty()) list += ", ";
    list += one.name;
  }
  return list;
}

}  // namespace cbvh::golden
