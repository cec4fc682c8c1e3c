// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>
#include <map>

#include "fpga/emulator/model/model_core.h"
#include "fpga/host/frame_reader.h"
#include "fpga/host/messages.h"

namespace cbvh::testing {

/// A board that computes the first batch of each size only, and answers the others of that size with the same
/// responses: what is left is the link. Its host must send nothing but one set over a link without faults.
class ReplayCore final : public emulator::Core {
 public:
  explicit ReplayCore(const emulator::CoreOptions& options) : model_(options), buffers_(options.buffers) {}

  void receive(std::span<const std::uint8_t> bytes) override {
    reader_.feed(bytes);
    while (const auto frame = reader_.next()) take(frame->header, frame->payload);
  }
  std::vector<std::uint8_t> send(std::size_t most) override {
    const std::size_t count = std::min(most, to_send_.size() - sent_);
    const auto begin = to_send_.begin() + static_cast<std::ptrdiff_t>(sent_);
    std::vector<std::uint8_t> bytes(begin, begin + static_cast<std::ptrdiff_t>(count));
    sent_ += count;
    if (sent_ == to_send_.size()) {
      to_send_.clear();
      sent_ = 0;
    }
    return bytes;
  }
  void reset() override {}

 private:
  static constexpr std::size_t kEverything = std::size_t{1} << 30U;
  static constexpr std::size_t kGreatestPayload = std::size_t{1} << 24U;

  void take(const host::Header& header, host::ByteSpan payload) {
    if (header.type == host::FrameType::reset) sequence_ = 0;
    host::Bytes& known = answers_[payload.size()];
    if (header.type != host::FrameType::vectors || known.empty()) {
      // The model sees every frame that is not answered from memory, under a number of its own.
      host::Bytes frame;
      host::append_frame(frame, header.type, model_sequence_++, payload);
      model_.receive(frame);
      host::FrameReader answer(kGreatestPayload);
      answer.feed(model_.send(kEverything));
      while (const auto found = answer.next()) {
        if (header.type == host::FrameType::vectors) {
          known.assign(found->payload.begin(), found->payload.end());
        } else {
          pass(found->header.type, {found->payload.begin(), found->payload.end()}, header.sequence);
        }
      }
    }
    if (header.type != host::FrameType::vectors) return;
    constexpr std::ptrdiff_t kNumber = 4;  // behind the credit; in VECTORS it is the first
    std::copy_n(payload.begin(), kNumber, known.begin() + kNumber);
    pass(host::FrameType::results, known, header.sequence);
  }

  void pass(host::FrameType type, host::Bytes payload, std::uint32_t of_sequence) {
    const std::uint32_t credit = of_sequence + 1 + buffers_;
    for (std::size_t i = 0; i < sizeof credit; ++i) payload[i] = static_cast<std::uint8_t>(credit >> (8 * i));
    host::append_frame(to_send_, type, sequence_++, payload);
  }

  emulator::ModelCore model_;
  std::uint32_t buffers_;
  host::FrameReader reader_{kGreatestPayload};
  std::map<std::size_t, host::Bytes> answers_;  ///< RESULTS by the size of VECTORS
  host::Bytes to_send_;
  std::size_t sent_ = 0;
  std::uint32_t sequence_ = 0;
  std::uint32_t model_sequence_ = 0;
};

}  // namespace cbvh::testing
