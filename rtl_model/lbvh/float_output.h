// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "rtl_model/lbvh/float_node_writer.h"
#include "rtl_model/lbvh/pipeline_config.h"

namespace cbvh::rtl {

/// The LBVH pipeline's output for float pairs: an uncompressed build. Paper table 2, first column.
class FloatOutput {
 public:
  static constexpr const char* kFirstModule = "float_node_writer";

  FloatOutput(Channel<StreamJob>& jobs, const LbvhConfig& config)
      : writer_(jobs, link_.requests, link_.answers, reports_, config.float_pairs) {}

  auto parts() { return std::tie(writer_, link_, reports_); }
  template <class Visit>
  void channels(Visit&& visit) const {
    link_.channels("float_node_writer", visit);
  }
  std::vector<NamedPort> ports() { return {{"float_node_writer", link_.port()}}; }
  bool done() const { return reports_.can_pop(); }

 private:
  LineLink link_;
  Channel<WriteReport> reports_;
  FloatNodeWriter writer_;
};

}  // namespace cbvh::rtl
