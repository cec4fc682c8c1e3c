// Copyright the cbvh authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "fpga/host/frame_reader.h"
#include "fpga/host/messages.h"
#include "vectors/registry.h"
#include "vectors/vector_set.h"

namespace cbvh::testing {

/// The board's side of the link, whose units are the golden. One answer a call of send().
class FakeBoard {
 public:
  FakeBoard() {
    hello.firmware_version = 1;
    hello.buffers = 4;
    hello.clock_khz = 1000;
    hello.greatest_payload_in = 2048;
    hello.greatest_payload_out = 2048;
    hello.name = "cbvh fake";
    for (const char* name : {"axis_compressor", "context_stack"}) offer(name);
  }
  void offer(const std::string& name) {
    hello.units.push_back({host::unit_id(name), name, 0x1FC, 2, vectors::find_unit(name).stateful});
  }

  void receive(host::ByteSpan bytes) {
    reader_.feed(bytes);
    while (const auto frame = reader_.next()) take(*frame);
  }
  bool has_answer() const { return !queue_.empty(); }
  host::Bytes send() {
    const auto answer = std::move(queue_.front());
    queue_.pop_front();
    return answer();
  }
  /// Off and on again.
  void power_cycle() {
    reader_.clear();
    reset();
    sequence_ = 0;
    tracker_ = {};
  }

  host::BoardHello hello;
  std::uint8_t version = host::kProtocolVersion;
  bool mute = false;                                ///< takes frames and answers none
  bool deaf_to_vectors = false;                     ///< answers all but VECTORS
  std::function<void(host::BatchResults&)> tamper;  ///< changes what it answers
  std::optional<host::ErrorReason> refuse_vectors;  ///< answers VECTORS with this
  std::uint64_t batches_run = 0;
  std::uint64_t without_credit = 0;  ///< batches that came although it had no buffer

 private:
  using Answer = std::function<host::Bytes()>;

  void reset() {
    queue_.clear();
    waiting_ = 0;
    set_.reset();
  }
  std::uint32_t credit() const { return tracker_.next() + static_cast<std::uint32_t>(hello.buffers - waiting_); }

  host::Bytes frame(host::FrameType type, const host::Bytes& payload) {
    host::Bytes bytes;
    host::append_frame(bytes, type, sequence_++, payload);
    if (version != host::kProtocolVersion) {
      bytes.clear();
      host::append_header(bytes, {version, type, 0, 0});
    }
    return bytes;
  }
  void answer(host::FrameType type, std::function<host::Bytes()> payload) {
    if (!mute) queue_.push_back([this, type, payload] { return frame(type, payload()); });
  }
  void refuse(std::uint32_t sequence, host::ErrorReason reason, std::uint32_t detail) {
    answer(host::FrameType::error, [=, this] {
      return host::BoardError{credit(), reason, sequence, detail}.to_payload();
    });
  }

  void take(const host::FrameReader::Frame& frame) {
    const host::Header& header = frame.header;
    if (frame.kind != host::FrameReader::Kind::whole) return;
    if (header.type == host::FrameType::reset) {
      tracker_.restart(header.sequence);
      reset();
      sequence_ = 0;
    } else if (!tracker_.take(header.sequence)) {
      return;
    }
    switch (header.type) {
      case host::FrameType::reset:
        return answer(host::FrameType::board_reset, [this] { return host::BoardCredit{credit()}.to_payload(); });
      case host::FrameType::hello:
        return answer(host::FrameType::board_hello, [this] {
          hello.credit = credit();
          return hello.to_payload();
        });
      case host::FrameType::status:
        return answer(host::FrameType::board_status, [this] { return host::BoardStatus{credit()}.to_payload(); });
      case host::FrameType::open:
        return open(header.sequence, frame.payload);
      case host::FrameType::vectors:
        return vectors(header.sequence, {frame.payload.begin(), frame.payload.end()});
      default:
        return refuse(header.sequence, host::ErrorReason::type, static_cast<std::uint32_t>(header.type));
    }
  }

  void open(std::uint32_t sequence, host::ByteSpan payload) {
    const auto request = host::OpenRequest::parse(payload);
    for (const host::OfferedUnit& unit : hello.units) {
      if (!request || unit.id != request->unit) continue;
      if ((unit.bits_mask >> request->bits & 1) == 0) {
        return refuse(sequence, host::ErrorReason::parameters, request->bits + 256U * request->treelet);
      }
      set_ = vectors::make_set(vectors::find_unit(unit.name), {request->bits, request->treelet}, 1);
      const auto widths = std::pair(set_->stimulus_codec().width, set_->response_codec().width);
      return answer(host::FrameType::board_open, [=, this] {
        return host::OpenAnswer{credit(),
                                request->unit,
                                request->bits,
                                request->treelet,
                                static_cast<std::uint32_t>(widths.first),
                                static_cast<std::uint32_t>(widths.second)}
            .to_payload();
      });
    }
    refuse(sequence, host::ErrorReason::unit, request ? request->unit : 0);
  }

  void vectors(std::uint32_t sequence, const host::Bytes& payload) {
    if (deaf_to_vectors) return;
    if (!set_) return refuse(sequence, host::ErrorReason::not_open, 0);
    if (refuse_vectors) return refuse(sequence, *refuse_vectors, 77);
    if (waiting_ == hello.buffers) {
      ++without_credit;
      return refuse(sequence, host::ErrorReason::credit, credit());
    }
    ++waiting_;
    answer(host::FrameType::results, [this, payload] { return run(payload); });
  }

  host::Bytes run(const host::Bytes& payload) {
    --waiting_;
    ++batches_run;
    const std::size_t stimulus_bytes = set_->stimulus_codec().packed_bytes();
    const auto batch = host::Batch::parse(payload, stimulus_bytes);
    host::BatchResults results{credit(), batch->number, 100, {}};
    std::deque<host::Bytes> records;
    for (const host::Batch::Episode& episode : batch->episodes) {
      records.push_back(respond(episode, stimulus_bytes));
      const std::size_t size = host::BatchResults::record_bytes(set_->response_codec().packed_bytes());
      results.episodes.push_back(
          {static_cast<std::uint32_t>(records.back().size() / size), false, false, records.back()});
    }
    if (tamper) tamper(results);
    return results.to_payload();
  }

  host::Bytes respond(const host::Batch::Episode& episode, std::size_t stimulus_bytes) {
    set_->clear();
    for (std::uint32_t i = 0; i < episode.stimuli; ++i) {
      if (i == 0 || !set_->unit().stateful) set_->begin_case(i, 0);
      set_->stimulus_codec().unpack(episode.packed.data() + i * stimulus_bytes, set_->add_stimulus());
      if (!set_->unit().stateful) set_->complete_case();
    }
    if (set_->unit().stateful && episode.stimuli > 0) set_->complete_case();
    host::Bytes records;
    host::Bytes packed(set_->response_codec().packed_bytes());
    for (std::size_t i = 0; i < set_->response_count(); ++i) {
      host::append(records, set_->latency_at(i));
      set_->response_codec().pack(set_->response_at(i), packed.data());
      host::append(records, packed);
    }
    return records;
  }

  host::FrameReader reader_{4096};
  host::SequenceTracker tracker_;
  std::uint32_t sequence_ = 0;
  std::deque<Answer> queue_;
  unsigned waiting_ = 0;  ///< batches in buffers
  std::unique_ptr<vectors::VectorSet> set_;
};

}  // namespace cbvh::testing
