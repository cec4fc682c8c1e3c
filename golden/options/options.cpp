// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/options/options.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "golden/input_error.h"
#include "golden/scene/parse_number.h"
#include "golden/scene/read_file.h"

namespace cbvh::golden {
namespace {

std::string range_of(const Option& option) {
  if (!option.words.empty()) return fmt::format("one of {}", fmt::join(option.words, ", "));
  return fmt::format("{} from {} to {}", option.is_integer ? "an integer" : "a number", option.least, option.greatest);
}

double value_of(const Option& option, std::string_view text, const std::string& place) {
  double value = option.least - 1;
  if (!option.words.empty()) {
    const auto word = std::find(option.words.begin(), option.words.end(), text);
    if (word != option.words.end()) value = static_cast<double>(word - option.words.begin());
  } else if (option.is_integer) {
    if (const auto integer = parse_integer<std::int64_t>(text)) value = static_cast<double>(*integer);
  } else {
    if (const auto real = parse_float(text)) value = static_cast<double>(*real);
  }
  const bool in_range = value >= option.least && value <= option.greatest;  // false for NaN
  if (!in_range)
    throw InputError(place,
                     fmt::format("option {}: found {}, wanted {}", option.name, in_quotes(text), range_of(option)));
  return value;
}

/// Cuts the text up to the next comma off `rest`.
std::string_view next_part(std::string_view& rest) {
  const std::string_view part = rest.substr(0, rest.find(','));
  rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  return part;
}

std::string initial_of(const Option& option) {
  return option.words.empty() ? fmt::format("{}", option.initial) : option.words.front();
}

}  // namespace

Option word_option(std::string name, std::string meaning, std::vector<std::string> words) {
  const auto last = static_cast<double>(words.size() - 1);
  return {std::move(name), std::move(meaning), 0, 0, last, true, std::move(words)};
}

std::string_view name_of(std::string_view description) { return description.substr(0, description.find(',')); }

OptionValues read_options(const std::string& place, std::string_view description, const std::vector<Option>& options) {
  OptionValues found;
  const std::size_t comma = description.find(',');
  bool more = comma != description.npos;
  std::string_view rest = more ? description.substr(comma + 1) : "";
  while (more) {
    more = rest.find(',') != rest.npos;
    const std::string_view part = next_part(rest);
    const std::size_t equals = part.find('=');
    if (equals == part.npos)
      throw InputError(place, fmt::format("option: found {}, wanted key=value", in_quotes(part)));
    const std::string_view key = part.substr(0, equals);
    const Option* option = find_named(options, key);
    if (option == nullptr) {
      throw InputError(place,
                       options.empty()
                           ? fmt::format("option: found {}, but {} has none", in_quotes(key), name_of(description))
                           : fmt::format("option: found {}, wanted one of {}", in_quotes(key), names_of(options)));
    }
    if (!found.values.emplace(option->name, value_of(*option, part.substr(equals + 1), place)).second) {
      throw InputError(place, fmt::format("option {}: given twice", option->name));
    }
  }
  for (const Option& option : options) found.values.emplace(option.name, option.initial);
  return found;
}

std::string options_help(const std::vector<Option>& options) {
  std::string help;
  for (const Option& option : options) {
    help += fmt::format("    {}={}  {}; {}\n", option.name, initial_of(option), option.meaning, range_of(option));
  }
  return help;
}

}  // namespace cbvh::golden
