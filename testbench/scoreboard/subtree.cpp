// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#include "testbench/scoreboard/subtree.h"

#include <algorithm>
#include <cstring>

#include "rtl_model/datapath/payloads.h"

namespace cbvh::testbench {

const vectors::PayloadCodec& subtree_codec() { return vectors::payload_codec<rtl::StreamJob>(); }

std::vector<std::vector<std::vector<std::uint8_t>>> subtrees(const std::vector<std::vector<std::uint8_t>>& tree) {
  std::vector<rtl::StreamJob> jobs(tree.size());
  std::vector<std::size_t> begins(jobs.size());  ///< of the subtree that ends with each pair
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::memcpy(&jobs[i], tree[i].data(), sizeof(rtl::StreamJob));
    if (jobs[i].root && i + 1 < jobs.size()) return {};  // several trees: nothing to cut
    begins[i] = i;
    for (std::size_t child = 0; child < 2; ++child) {
      const std::size_t pointer = jobs[i].pair.pointer[child].value();
      if (jobs[i].pair.leaf[child]) continue;
      if (pointer >= i) return {};  // not a tree: nothing to cut
      begins[i] = std::min(begins[i], begins[pointer]);
    }
    if (i + 1 < jobs.size()) roots.push_back(i);
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [&](std::size_t a, std::size_t b) { return a - begins[a] < b - begins[b]; });
  std::vector<std::vector<std::vector<std::uint8_t>>> result;
  for (const std::size_t root : roots) {
    std::vector<std::vector<std::uint8_t>> subtree;
    for (std::size_t i = begins[root]; i <= root; ++i) {
      rtl::StreamJob job = jobs[i];
      job.root = rtl::UInt<1>(i == root);
      for (std::size_t child = 0; child < 2; ++child) {
        if (!job.pair.leaf[child])
          job.pair.pointer[child] = rtl::Pointer(job.pair.pointer[child].value() - begins[root]);
      }
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(&job);
      subtree.emplace_back(bytes, bytes + sizeof(job));
    }
    result.push_back(subtree);
  }
  return result;
}

}  // namespace cbvh::testbench
