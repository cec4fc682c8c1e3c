// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// What commands need of CLI11, whose headers take longer to compile than most of our sources: only command.cpp and
/// command_line.cpp include them.
namespace cbvh::testbench {

/// An option, or a positional argument, of a command.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  CommandOption& required();
  CommandOption& type_name(const std::string& name);
  /// Help shows the value that the variable has now.
  CommandOption& capture_default_str();
  CommandOption& envname(const std::string& name);
  CommandOption& delimiter(char delimiter);
  CommandOption& allow_extra_args(bool allow);
  CommandOption& range(unsigned low, unsigned high);
  CommandOption& positive();
  /// `problem` gives an empty text, or what is wrong with the argument.
  CommandOption& check(std::function<std::string(const std::string&)> problem);

 private:
  CLI::Option* option_;
};

/// A subcommand of cbvh, while options are added to it.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  /// T: those of the end of command.cpp.
  template <class T>
  CommandOption add_option(const std::string& name, T& value, const std::string& description) const;
  void add_flag(const std::string& name, bool& value, const std::string& description) const;
  Command add_subcommand(const std::string& name, const std::string& description) const;
  void require_subcommand(int count) const;
  void callback(std::function<void()> callback) const;
  void footer(const std::string& text) const;

 private:
  CLI::App* app_;
};

}  // namespace cbvh::testbench
