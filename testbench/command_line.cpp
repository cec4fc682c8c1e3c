// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <memory>

#include "golden/input_error.h"
#include "testbench/invocation.h"
#include "testbench/unavailable.h"
#include "testbench/version.h"

namespace cbvh::testbench {

namespace {

constexpr const char* kDescription =
    "cbvh: bit- and cycle-exact models of hardware that builds quantized BVHs, checked against an exact golden model.\n"
    "Exit codes: 0 pass, 1 mismatch, 2 bad input or usage, 77 skipped (something the run needs is not here).";

int fail(int code, const std::string& line) {
  std::string one_line = line;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  fmt::print(stderr, "cbvh: {}\n", one_line);
  return code;
}

std::vector<const CLI::App*> all_subcommands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> known_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : all_subcommands(app)) names.push_back(command->get_name());
  for (const CLI::Option* option : app.get_options()) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return names;
}

/// The deepest subcommand that was named: its options are the ones a wrong option should have been of.
const CLI::App& innermost(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : innermost(*chosen.back());
}

/// "cbvh: build: unknown '--treelets', known: --bits, ..." of whatever CLI11 found wrong.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = innermost(app);
  const std::string place = &command == &app ? "command line" : command.get_name();
  const std::vector<std::string> extra = app.remaining(true);
  if (!extra.empty()) {
    return fmt::format("{}: unknown '{}', known: {}", place, extra[0], fmt::join(known_names(command), ", "));
  }
  return fmt::format("{}: {}", place, error.what());
}

void add_help_command(CLI::App& app, CommandLine& commands) {
  auto name = std::make_shared<std::string>();
  const Command help = commands.add("help", "What the commands do, or one of them: help COMMAND", [&app, name] {
    if (name->empty()) {
      fmt::print("{}", app.help());
      return kPass;
    }
    for (const CLI::App* command : all_subcommands(app)) {
      if (command->get_name() != *name) continue;
      fmt::print("{}", command->help());
      return kPass;
    }
    throw golden::InputError("help", fmt::format("unknown '{}', known: {}", *name, fmt::join(known_names(app), ", ")));
  });
  help.add_option("command", *name, "the command to explain");
}

}  // namespace

Command CommandLine::add(const std::string& name, const std::string& description, std::function<int()> run) {
  CLI::App* command = app_.add_subcommand(name, description);
  command->callback([this, run = std::move(run)] { chosen_ = run; });
  return Command(*command);
}

int run_command_line(int argc, const char* const* argv) {
  record_command_line(argc, argv);
  CLI::App app{kDescription, "cbvh"};
  app.set_version_flag("--version", fmt::format("cbvh {}", kVersion), "print the version and exit");
  app.require_subcommand(1);
  CommandLine commands(app);
  for (AddCommand* add : all_commands()) add(commands);
  add_help_command(app, commands);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return fail(kBadInput, usage_error(app, error));
  }
  try {
    return commands.run_chosen();
  } catch (const Unavailable& reason) {
    return fail(kSkipped, reason.what());
  } catch (const golden::InputError& error) {
    return fail(kBadInput, error.what());
  } catch (const std::exception& error) {
    return fail(kBadInput, fmt::format("internal: {}", error.what()));
  }
}

}  // namespace cbvh::testbench
