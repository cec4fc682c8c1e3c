// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "golden/tree/validate.h"

#include <fmt/format.h>

#include <memory>

#include "golden/build/lbvh.h"
#include "golden/scene/load.h"
#include "golden/tree/digest.h"
#include "golden/tree/tree_file.h"
#include "testbench/command_line.h"
#include "testbench/output.h"

namespace cbvh::testbench {

namespace {

struct Options {
  std::string tree;
  std::string scene;
  Output output;
};

int run(const Options& options) {
  const golden::CompressedTree tree =
      golden::read_tree(options.tree);  // structure; a tree that violates it is bad input
  std::vector<golden::Violation> violations;
  if (!options.scene.empty())
    violations = golden::validate(tree, golden::build_lbvh(golden::load_scene(options.scene)));
  Json texts = Json::array();
  std::string text;
  for (const golden::Violation& violation : violations) {
    texts.push_back(golden::to_string(violation));
    text += fmt::format("{}: {}\n", options.tree, golden::to_string(violation));
  }
  const std::string digest = fmt::format("{:016x}", golden::digest(tree));
  text += fmt::format("{}: {} pairs, {} leaves, {} primitives, digest {}, {} violations\n", options.tree,
                      tree.pairs.size(), tree.leaves, tree.primitives, digest, violations.size());
  options.output.text(text);
  options.output.json({{"file", options.tree},
                       {"scene", options.scene},
                       {"bits", tree.rules.bits},
                       {"pairs", tree.pairs.size()},
                       {"leaves", tree.leaves},
                       {"triangles", tree.primitives},
                       {"digest", digest},
                       {"violations", violations.size()},
                       {"violation_texts", texts}});
  return violations.empty() ? kPass : kMismatch;
}

}  // namespace

void add_validate_command(CommandLine& commands) {
  auto options = std::make_shared<Options>();
  const Command command = commands.add(
      "validate", "Checks a tree file: its structure, and with --scene that every box encloses its triangles",
      [options] { return run(*options); });
  command.add_option("tree", options->tree, "a .cbvh file").required().type_name("FILE");
  command.add_option("--scene", options->scene, "the scene it was built from").type_name("SCENE");
  options->output.add_option(command);
}

}  // namespace cbvh::testbench
