// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/invocation.h"

#include <gtest/gtest.h>

namespace cbvh::testbench {
namespace {

TEST(Invocation, arguments_are_quoted_only_where_a_shell_needs_it) {
  EXPECT_EQ(shell_quote("proc:cloth,sheet=20"), "proc:cloth,sheet=20");
  EXPECT_EQ(shell_quote(""), "''");
  EXPECT_EQ(shell_quote("proc:explode,time={time}"), "'proc:explode,time={time}'");
  EXPECT_EQ(shell_quote("a b"), "'a b'");
  EXPECT_EQ(shell_quote("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_quote("$(x)"), "'$(x)'");
}

TEST(Invocation, the_line_names_the_command_without_its_folder) {
  const char* const argv[] = {"/opt/bin/cbvh", "eval", "a scene.glb"};
  record_command_line(3, argv);
  EXPECT_EQ(command_line(), "cbvh eval 'a scene.glb'");
}

}  // namespace
}  // namespace cbvh::testbench
