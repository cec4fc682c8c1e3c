// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rtl_model/kernel/channel.h"

namespace cbvh::rtl {

/// Which modules a design's channels join. A composite lists them in `channels(visit)`, calling
/// visit(name, producer, consumer, channel) for each; a name that is empty is that of a port of the composite. From
/// this one list come the utilisation table, the waveforms and the explanation of a deadlock. Nobody pays for it but
/// who looks.
class Netlist {
 public:
  struct Link {
    std::string name;
    std::string producer;
    std::string consumer;
    const ChannelState* channel;
    std::function<bool()> ended;  ///< whether the item marked last has passed; empty if items are not so marked
  };

  template <class T>
  void add(const std::string& name, const std::string& producer, const std::string& consumer,
           const Channel<T>& channel) {
    Link link{name, producer, consumer, &channel, {}};
    if constexpr (requires(const T& item) { item.last; }) {
      link.ended = [&channel] { return channel.pops() > 0 && !channel.can_pop() && bool(channel.last_popped().last); };
    } else if constexpr (requires(const T& item) { item.root.value(); }) {
      link.ended = [&channel] { return channel.pops() > 0 && !channel.can_pop() && bool(channel.last_popped().root); };
    }
    links_.push_back(std::move(link));
  }
  /// All channels of a composite.
  template <class Design>
  void add(const Design& design) {
    design.channels([this](const char* name, const char* producer, const char* consumer, const auto& channel) {
      this->add(name, producer, consumer, channel);
    });
  }

  const std::vector<Link>& links() const { return links_; }
  /// The modules, in the order in which they were first named.
  std::vector<std::string> modules() const;

  /// Transfers out of all channels so far: while it grows, something moves.
  std::uint64_t transfers() const;
  /// For a design in which nothing moves: each module that waits, and for what.
  std::vector<std::string> waiting() const;

 private:
  std::vector<Link> links_;
};

}  // namespace cbvh::rtl
