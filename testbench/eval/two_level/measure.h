// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "testbench/eval/measure.h"

namespace cbvh::testbench {

/// One top level of one scene of instances, over float or compressed trees of its objects.
struct TopLevelMeasure {
  std::string scene;
  std::string top;              ///< "NAME[,key=value...]"
  std::string objects;          ///< "float" or "compressed"
  std::uint64_t triangles = 0;  ///< of all instances
  std::uint64_t instances = 0;
  std::uint64_t references = 0;
  std::uint64_t object_pairs = 0;    ///< of all objects, each once
  std::uint64_t pairs = 0;           ///< of the top level
  int depth = 0;                     ///< of the top level
  double build_seconds = 0;          ///< of the top level
  double objects_seconds = 0;        ///< to build the objects' float trees
  double sah = 0;                    ///< of both levels, C_T = C_I = 1, relative to the box around all instances
  double sah_compressed = 0;         ///< the same with the top level's decoded boxes; N = 6, e_min the exactness limit
  std::optional<double> sah_single;  ///< of one tree over all triangles, by the objects' builder
  std::optional<double> single_seconds;
  bool transformed = false;  ///< the instances are, at least one of them
  CodeCounts modulo;         ///< of streaming the top level
  std::uint64_t checks = 0;
  std::vector<std::string> failures;
};

struct TwoLevelJob {
  std::vector<std::string> scenes;
  std::vector<std::string> tops;
  std::string objects = "binned";         ///< builder of the objects' trees and of the single tree
  unsigned repeats = 1;                   ///< builds of which the fastest counts
  std::uint64_t most_single = 2'000'000;  ///< no single tree of more triangles
};

/// Measures every top level on every scene, scene by scene, over float and over compressed trees. Checked of each: the
/// golden finds no faults (every triangle of every instance once, enclosed), its compressed form encloses it, and
/// streamed by the golden and through the RTL it is the top-down tree bit for bit. Throws InputError for what cannot be
/// read, before anything is measured.
std::vector<TopLevelMeasure> measure_two_level(const TwoLevelJob& job);

}  // namespace cbvh::testbench
