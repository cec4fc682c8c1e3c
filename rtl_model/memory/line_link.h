// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "rtl_model/kernel/channel.h"
#include "rtl_model/memory/ideal_line_memory.h"
#include "rtl_model/memory/line_port.h"

namespace cbvh::rtl {

/// The channels between one module and one port of the memory.
struct LineLink {
  Channel<LineRequest> requests;
  Channel<LineData> answers;

  LinePort port() { return {&requests, &answers}; }
  auto parts() { return std::tie(requests, answers); }

  /// As `channels` of a composite says it, for the module at this end.
  template <class Visit>
  void channels(const char* module, Visit&& visit) const {
    visit("requests", module, "memory", requests);
    visit("answers", "memory", module, answers);
  }
};

}  // namespace cbvh::rtl
