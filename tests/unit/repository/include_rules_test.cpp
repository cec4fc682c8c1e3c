// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
// Who may include whom (docs/architecture.md). Runs in the repository's root.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct FolderRule {
  std::string folder;                    ///< its files
  std::vector<std::string> may_include;  ///< folders and headers of ours, besides the folder itself
  bool libraries = true;                 ///< anything but the standard library
};

const std::vector<std::string> kEverything = {"golden", "rtl_model", "vectors", "testbench", "fpga", "tests"};

const std::vector<FolderRule> kRules = {
    {"golden", {}},
    {"rtl_model", {}, false},
    {"vectors", {"golden", "rtl_model"}},
    {"testbench", {"golden", "rtl_model", "vectors", "fpga/host"}},
    {"fpga/host", {"vectors", "golden/input_error.h"}},
    {"fpga/emulator", kEverything},
    {"tests", kEverything},
    {"bench", kEverything},
};

struct Report {
  std::map<std::string, std::size_t> files_checked;  ///< by the rule's folder
  std::vector<std::string> violations;               ///< file:line: what is wrong
};

struct Include {
  std::string path;
  bool quoted;
};

/// The target of an #include line; nothing for any other line.
std::optional<Include> parse_include(std::string_view line) {
  const auto skip_blanks = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  if (!line.starts_with('#')) return std::nullopt;
  line.remove_prefix(1);
  skip_blanks();
  if (!line.starts_with("include")) return std::nullopt;
  line.remove_prefix(std::string_view("include").size());
  skip_blanks();
  if (line.empty() || (line[0] != '"' && line[0] != '<')) return std::nullopt;
  const char closing = line[0] == '"' ? '"' : '>';
  return Include{std::string(line.substr(1, line.find(closing, 1) - 1)), closing == '"'};
}

bool is_below(std::string_view path, std::string_view folder) {
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

bool is_ours(std::string_view path) {
  return std::any_of(kRules.begin(), kRules.end(),
                     [&](const FolderRule& rule) { return is_below(path, rule.folder); }) ||
         is_below(path, "fpga");
}

/// Standard headers have neither a folder nor an extension.
bool is_standard(std::string_view path) { return path.find_first_of("/.") == std::string_view::npos; }

std::optional<std::string> violation(const FolderRule& rule, const Include& include) {
  if (is_ours(include.path)) {
    if (!include.quoted) return "our own header in angle brackets";
    if (is_below(include.path, rule.folder)) return std::nullopt;
    for (const std::string& folder : rule.may_include) {
      if (include.path == folder || is_below(include.path, folder)) return std::nullopt;
    }
    return rule.folder + "/ must not include it";
  }
  if (include.quoted && rule.folder == "tests" && include.path.find('/') == std::string::npos)
    return std::nullopt;  // a helper beside it
  if (include.quoted) return "quotes are for our own headers, by their path from the repository's root";
  if (!rule.libraries && !is_standard(include.path)) return rule.folder + "/ uses the standard library only";
  return std::nullopt;
}

void check_file(const fs::path& root, const fs::path& file, const FolderRule& rule, Report& report) {
  std::ifstream stream(file);
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    const std::optional<Include> include = parse_include(line);
    if (!include) continue;
    if (const auto wrong = violation(rule, *include)) {
      report.violations.push_back(file.lexically_relative(root).string() + ":" + std::to_string(number) + ": '" +
                                  include->path + "': " + *wrong);
    }
  }
}

Report check_includes(const fs::path& root) {
  Report report;
  for (const FolderRule& rule : kRules) {
    if (!fs::exists(root / rule.folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / rule.folder)) {
      if (is_below(entry.path().lexically_relative(root).string(), "tests/end_to_end/find_package"))
        continue;  // a user's program
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp" && extension != ".inc") continue;
      ++report.files_checked[rule.folder];
      check_file(root, entry.path(), rule, report);
    }
  }
  return report;
}

/// A tree of files in a temporary folder.
class PlantedTree {
 public:
  PlantedTree() { fs::create_directories(root); }
  ~PlantedTree() { fs::remove_all(root); }
  PlantedTree(const PlantedTree&) = delete;
  PlantedTree& operator=(const PlantedTree&) = delete;

  void plant(const std::string& path, const std::string& text) const {
    fs::create_directories((root / path).parent_path());
    std::ofstream(root / path) << text;
  }

  const fs::path root = fs::temp_directory_path() / ("cbvh_include_rules." + std::to_string(getpid()));
};

TEST(IncludeRules, every_folder_includes_only_what_it_may) {
  const Report report = check_includes(fs::current_path());
  for (const char* folder : {"golden", "rtl_model", "vectors", "fpga/host", "tests"}) {
    EXPECT_GT(report.files_checked.count(folder), 0u)
        << "no file checked in " << folder << ", from " << fs::current_path();
  }
  for (const std::string& violation : report.violations) ADD_FAILURE() << violation;
}

TEST(IncludeRules, each_kind_of_planted_violation_is_found_and_nothing_else) {
  const PlantedTree tree;
  tree.plant("golden/fine.h", "#include <glm/vec3.hpp>\n#include \"golden/scene/mesh.h\"\n");
  tree.plant("golden/wrong.h", "#pragma once\n# include \"rtl_model/bits/uint.h\"\n");
  tree.plant("rtl_model/fine.h", "#include <cstdint>\n#include \"rtl_model/kernel/reg.h\"\n// #include <fmt/core.h>\n");
  tree.plant("rtl_model/kernel/wrong.cpp", "#include <fmt/core.h>\n#include \"vectors/payload.h\"\n");
  tree.plant("vectors/fine.cpp", "#include \"golden/input_error.h\"\n#include \"rtl_model/kernel/reg.h\"\n");
  tree.plant("vectors/wrong.cpp",
             "#include <golden/input_error.h>\n#include \"payload.h\"\n#include \"testbench/backend.h\"\n");
  tree.plant("testbench/fine.cpp", "#include \"fpga/host/link.h\"\n");
  tree.plant("testbench/wrong.cpp", "#include \"fpga/emulator/board.h\"\n");
  tree.plant("fpga/host/fine.cpp", "#include \"golden/input_error.h\"\n");
  tree.plant("fpga/host/wrong.cpp", "#include \"vectors/payload.h\"\n#include \"golden/scene/mesh.h\"\n");
  tree.plant("tests/fine_test.cpp",
             "#include \"fpga/emulator/board.h\"\n#include <gtest/gtest.h>\n#include \"helper.h\"\n");
  Report report = check_includes(tree.root);
  std::sort(report.violations.begin(), report.violations.end());
  const std::vector<std::string> expected = {
      "fpga/host/wrong.cpp:2: 'golden/scene/mesh.h': fpga/host/ must not include it",
      "golden/wrong.h:2: 'rtl_model/bits/uint.h': golden/ must not include it",
      "rtl_model/kernel/wrong.cpp:1: 'fmt/core.h': rtl_model/ uses the standard library only",
      "rtl_model/kernel/wrong.cpp:2: 'vectors/payload.h': rtl_model/ must not include it",
      "testbench/wrong.cpp:1: 'fpga/emulator/board.h': testbench/ must not include it",
      "vectors/wrong.cpp:1: 'golden/input_error.h': our own header in angle brackets",
      "vectors/wrong.cpp:2: 'payload.h': quotes are for our own headers, by their path from the repository's root",
      "vectors/wrong.cpp:3: 'testbench/backend.h': vectors/ must not include it",
  };
  EXPECT_EQ(report.violations, expected);
}

TEST(IncludeRules, an_empty_tree_checks_no_file) {
  const PlantedTree tree;
  EXPECT_TRUE(check_includes(tree.root).files_checked.empty());
}

}  // namespace
